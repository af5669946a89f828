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

/** In units of float's epsilon. */
constexpr double Roundings = 8.0;

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
  this->MakeBoxes(std::max({ extent[0], extent[1], extent[2] }) + m_GreatestReach);
}

void
DelaunayRefinementPatchCover::MakeBoxes(double extent)
{
  // Each of the coordinates and differences is off by at most this share of the extent.
  const double off = Roundings * std::numeric_limits<float>::epsilon() * extent;
  const auto   square = [off](double length) {
    const double less = (1.0 - Roundings * std::numeric_limits<float>::epsilon()) * length - off;
    return less > 0.0 ? static_cast<float>(less * less) : -1.0f;
  };
  for (const EntryType & entry : m_Entries)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Boxes.center[i].push_back(static_cast<float>(entry.patch.center[i] - m_Minimum[i]));
      m_Boxes.halfExtents[i].push_back(static_cast<float>(entry.patch.halfExtents[i]));
    }
    m_Boxes.squaredDelta.push_back(square(entry.delta));
    m_Boxes.squaredReach.push_back(square(entry.delta - entry.patch.radius));
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
  const float    x = static_cast<float>(vertex[0] - m_Minimum[0]);
  const float    y = static_cast<float>(vertex[1] - m_Minimum[1]);
  const float    z = static_cast<float>(vertex[2] - m_Minimum[2]);
  const CubeType first = this->FindCube(vertex, -m_GreatestReach);
  const CubeType last = this->FindCube(vertex, m_GreatestReach);
  for (std::int32_t cubeZ = first[2]; cubeZ <= last[2]; ++cubeZ)
  {
    for (std::int32_t cubeY = first[1]; cubeY <= last[1]; ++cubeY)
    {
      const std::uint32_t end = m_Starts[this->ToOffset({ last[0], cubeY, cubeZ }) + 1];
      for (std::uint32_t i = m_Starts[this->ToOffset({ first[0], cubeY, cubeZ })]; i < end; ++i)
      {
        const float dx = std::abs(x - m_Boxes.center[0][i]);
        const float dy = std::abs(y - m_Boxes.center[1][i]);
        const float dz = std::abs(z - m_Boxes.center[2][i]);
        const float furthestX = dx + m_Boxes.halfExtents[0][i];
        const float furthestY = dy + m_Boxes.halfExtents[1][i];
        const float furthestZ = dz + m_Boxes.halfExtents[2][i];
        const bool  isInBox =
          furthestX * furthestX + furthestY * furthestY + furthestZ * furthestZ <= m_Boxes.squaredDelta[i];
        const bool isInBall = dx * dx + dy * dy + dz * dz <= m_Boxes.squaredReach[i];
        m_IsCovered[i] = static_cast<char>(m_IsCovered[i] | isInBox | isInBall);
      }
    }
  }
}
} // end namespace itk
