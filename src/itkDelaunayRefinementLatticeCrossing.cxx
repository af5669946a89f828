/*=========================================================================
 *
 *  Copyright The DelaunayRefinement Contributors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementLatticeVisit.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using PointType = DelaunayRefinementPoint;
} // namespace

bool
DelaunayRefinementLatticeOracle::FindFirstCrossing(const PointType & from,
                                                   const PointType & to,
                                                   PointType &       crossing) const
{
  const PointType start = this->ToLattice(from);
  const PointType end = this->ToLattice(to);
  const PointType direction = Geometry::Subtract(end, start);

  // The part of the way between the first and the last cells with surface.
  double begin = 0.0;
  double finish = 1.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double low = m_Bricks->GetFirstCell()[i];
    const double high = m_Bricks->GetLastCell()[i] + 1;
    if (direction[i] == 0.0)
    {
      if (start[i] < low || start[i] > high)
      {
        return false;
      }
      continue;
    }
    const double one = (low - start[i]) / direction[i];
    const double other = (high - start[i]) / direction[i];
    begin = std::max(begin, std::min(one, other));
    finish = std::min(finish, std::max(one, other));
  }
  if (!(begin <= finish))
  {
    return false;
  }

  // From brick to brick.
  const RegionType      region = this->Classify(from);
  constexpr double      size = DelaunayRefinementBricks::BrickSize;
  const IndexType &     levelSize = m_Bricks->GetLevelSize(0);
  IndexType             brick;
  IndexType             step{};
  std::array<double, 3> next;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double position = start[i] + begin * direction[i];
    brick[i] = std::clamp(static_cast<std::int32_t>(std::floor(position / size)), 0, levelSize[i] - 1);
    step[i] = direction[i] > 0.0 ? 1 : direction[i] < 0.0 ? -1 : 0;
    next[i] = step[i] == 0 ? 2.0 : (size * (brick[i] + (step[i] > 0 ? 1 : 0)) - start[i]) / direction[i];
  }
  double share = begin;
  while (true)
  {
    const unsigned int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const double       exit = std::min(next[axis], finish);
    double             found;
    if (m_Bricks->IsActiveNode(0, brick) &&
        this->FindChangeInBrick(brick, start, direction, share, exit, region, found))
    {
      crossing = this->ToPhysical(Geometry::AddScaled(start, found, direction));
      return true;
    }
    if (next[axis] >= finish)
    {
      return false;
    }
    share = exit;
    brick[axis] += step[axis];
    if (brick[axis] < 0 || brick[axis] >= levelSize[axis])
    {
      return false;
    }
    next[axis] += size * step[axis] / direction[axis];
  }
}

bool
DelaunayRefinementLatticeOracle::FindChangeInBrick(const IndexType & brick,
                                                   const PointType & from,
                                                   const PointType & direction,
                                                   double            begin,
                                                   double            end,
                                                   RegionType        region,
                                                   double &          share) const
{
  IndexType             cell;
  IndexType             step{};
  std::array<double, 3> next;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double position = from[i] + begin * direction[i];
    cell[i] = std::clamp(static_cast<std::int32_t>(std::floor(position)), 4 * brick[i], 4 * brick[i] + 3);
    step[i] = direction[i] > 0.0 ? 1 : direction[i] < 0.0 ? -1 : 0;
    next[i] = step[i] == 0 ? 2.0 : (cell[i] + (step[i] > 0 ? 1 : 0) - from[i]) / direction[i];
  }
  double entry = begin;
  while (true)
  {
    const unsigned int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const double       exit = std::min(next[axis], end);
    if (exit >= entry && m_Bricks->IsActiveCell(cell))
    {
      const PointType one = ToLocal(Geometry::AddScaled(from, entry, direction), cell);
      const PointType other = ToLocal(Geometry::AddScaled(from, exit, direction), cell);
      double          found;
      if (this->VisitCell(cell,
                          [&](const auto & content) { return content.FindFirstChange(one, other, region, found); }))
      {
        share = entry + found * (exit - entry);
        return true;
      }
    }
    if (next[axis] >= end)
    {
      return false;
    }
    entry = std::max(entry, exit);
    cell[axis] += step[axis];
    if ((cell[axis] >> 2) != brick[axis])
    {
      return false;
    }
    next[axis] += step[axis] / direction[axis];
  }
}
} // end namespace itk
