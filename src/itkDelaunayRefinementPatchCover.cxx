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
#include "itkDelaunayRefinementPatchCover.h"

#include <algorithm>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** Cubes per patch; more would take longer to set up than they save. */
constexpr double MostCubesPerPatch = 8.0;

/** Edge of the cubes over the greatest reach. */
constexpr double CubeSize = 0.7;
} // namespace

DelaunayRefinementPatchCover::DelaunayRefinementPatchCover(std::vector<EntryType> entries)
{
  if (entries.empty())
  {
    return;
  }
  m_Minimum = entries.front().patch.center;
  PointType maximum = m_Minimum;
  for (const EntryType & entry : entries)
  {
    m_GreatestReach = std::max(m_GreatestReach, entry.delta);
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Minimum[i] = std::min(m_Minimum[i], entry.patch.center[i]);
      maximum[i] = std::max(maximum[i], entry.patch.center[i]);
    }
  }
  const PointType extent = Geometry::Subtract(maximum, m_Minimum);
  double          size = CubeSize * m_GreatestReach;
  const auto count = [&] { return (1.0 + extent[0] / size) * (1.0 + extent[1] / size) * (1.0 + extent[2] / size); };
  while (!(count() < 64.0 + MostCubesPerPatch * static_cast<double>(entries.size())))
  {
    size = 1.25 * size + std::numeric_limits<double>::min();
  }
  m_CubesPerLength = 1.0 / size;
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_Size[i] = 1 + static_cast<std::int32_t>(extent[i] * m_CubesPerLength);
  }

  // Sorting by counting keeps the order within cubes.
  std::vector<std::uint32_t> cubes(entries.size());
  m_Starts.assign(this->ToOffset({ m_Size[0] - 1, m_Size[1] - 1, m_Size[2] - 1 }) + 2, 0);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    cubes[i] = static_cast<std::uint32_t>(this->ToOffset(this->FindCube(entries[i].patch.center, 0.0)));
    ++m_Starts[cubes[i] + 1];
  }
  for (std::size_t cube = 1; cube < m_Starts.size(); ++cube)
  {
    m_Starts[cube] += m_Starts[cube - 1];
  }
  std::vector<std::uint32_t> next(m_Starts.begin(), m_Starts.end() - 1);
  m_Entries.resize(entries.size());
  m_IsCovered.assign(entries.size(), 0);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    m_Entries[next[cubes[i]]++] = entries[i];
  }
}

DelaunayRefinementPatchCover::CubeType
DelaunayRefinementPatchCover::FindCube(const PointType & point, double offset) const
{
  CubeType cube;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double index = (point[i] + offset - m_Minimum[i]) * m_CubesPerLength;
    cube[i] = static_cast<std::int32_t>(std::clamp(index, 0.0, m_Size[i] - 1.0));
  }
  return cube;
}

void
DelaunayRefinementPatchCover::CoverFrom(const PointType & vertex)
{
  if (m_Entries.empty())
  {
    return;
  }
  const CubeType first = this->FindCube(vertex, -m_GreatestReach);
  const CubeType last = this->FindCube(vertex, m_GreatestReach);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      const std::uint32_t end = m_Starts[this->ToOffset({ last[0], y, z }) + 1];
      for (std::uint32_t i = m_Starts[this->ToOffset({ first[0], y, z })]; i < end; ++i)
      {
        if (IsWithin(m_Entries[i].patch, m_Entries[i].delta, vertex))
        {
          m_IsCovered[i] = 1;
        }
      }
    }
  }
}
} // end namespace itk
