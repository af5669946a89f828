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
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** Cubes per group; more would take longer to set up than they save. */
constexpr double MostCubesPerGroup = 4.0;

/** Edge of the cubes over the greatest reach. */
constexpr double CubeSize = 0.7;
} // namespace

DelaunayRefinementPatchCover::DelaunayRefinementPatchCover(const PatchesType & roots, double greatestDelta)
  : m_Minimum(roots.GetOrigin())
{
  if (roots.GetSize() == 0)
  {
    return;
  }
  m_Marks.GetPatches().Clear(roots.GetOrigin());
  m_Groups.resize(roots.GetSize());
  PointType maximum = m_Minimum;
  double    largest = 0.0;
  for (std::size_t i = 0; i < roots.GetSize(); ++i)
  {
    const auto root = roots.Get(i);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_Minimum[axis] = i == 0 ? root.center[axis] : std::min(m_Minimum[axis], root.center[axis]);
      maximum[axis] = i == 0 ? root.center[axis] : std::max(maximum[axis], root.center[axis]);
      largest = std::max(largest, root.halfExtents[axis]);
    }
  }
  m_GreatestReach = greatestDelta + largest;
  const PointType extent = Geometry::Subtract(maximum, m_Minimum);
  const auto      getExtent = [&](const PointType & corner) {
    return Geometry::Distance(corner, roots.GetOrigin()) + 2.0 * m_GreatestReach;
  };
  m_Extent = std::max(getExtent(m_Minimum), getExtent(maximum)) + Geometry::Distance(m_Minimum, maximum);
  double     size = CubeSize * m_GreatestReach;
  const auto count = [&] { return (1.0 + extent[0] / size) * (1.0 + extent[1] / size) * (1.0 + extent[2] / size); };
  while (!(count() < 64.0 + MostCubesPerGroup * static_cast<double>(roots.GetSize())))
  {
    size = 1.25 * size + std::numeric_limits<double>::min();
  }
  m_CubesPerLength = 1.0 / size;
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_Size[i] = 1 + static_cast<std::int32_t>(extent[i] * m_CubesPerLength);
  }

  // Sorting by counting keeps the order within cubes.
  std::vector<std::uint32_t> cubes(roots.GetSize());
  m_Starts.assign(this->ToOffset({ m_Size[0] - 1, m_Size[1] - 1, m_Size[2] - 1 }) + 2, 0);
  for (std::size_t i = 0; i < cubes.size(); ++i)
  {
    cubes[i] = static_cast<std::uint32_t>(this->ToOffset(this->FindCube(roots.Get(i).center, 0.0)));
    ++m_Starts[cubes[i] + 1];
  }
  for (std::size_t cube = 1; cube < m_Starts.size(); ++cube)
  {
    m_Starts[cube] += m_Starts[cube - 1];
  }
  std::vector<std::uint32_t> next(m_Starts.begin(), m_Starts.end() - 1);
  m_Order.resize(cubes.size());
  for (std::uint32_t i = 0; i < cubes.size(); ++i)
  {
    const std::uint32_t place = next[cubes[i]]++;
    const auto          root = roots.Get(i);
    m_Order[place] = i;
    m_Groups[place] = { root.center, root.halfExtents, 0, 0, true };
  }
}

void
DelaunayRefinementPatchCover::EndGroup(bool isUniform)
{
  GroupType & group = m_Groups[m_NumberOfGroups];
  group.begin = m_NumberOfGroups == 0 ? 0 : m_Groups[m_NumberOfGroups - 1].end;
  group.end = static_cast<std::uint32_t>(m_Marks.GetPatches().GetSize());
  group.isUniform = isUniform;
  ++m_NumberOfGroups;
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
  if (m_Groups.empty())
  {
    return;
  }
  const CubeType first = this->FindCube(vertex, -m_GreatestReach);
  const CubeType last = this->FindCube(vertex, m_GreatestReach);
  for (std::int32_t cubeZ = first[2]; cubeZ <= last[2]; ++cubeZ)
  {
    for (std::int32_t cubeY = first[1]; cubeY <= last[1]; ++cubeY)
    {
      // The groups of a row of cubes follow each other, and so do their patches.
      const std::uint32_t begin = m_Starts[this->ToOffset({ first[0], cubeY, cubeZ })];
      const std::uint32_t end = m_Starts[this->ToOffset({ last[0], cubeY, cubeZ }) + 1];
      if (begin < end)
      {
        m_Marks.CoverFrom(vertex, m_Groups[begin].begin, m_Groups[end - 1].end);
      }
    }
  }
}
} // end namespace itk
