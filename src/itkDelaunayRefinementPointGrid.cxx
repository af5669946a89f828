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
#include "itkDelaunayRefinementPointGrid.h"

#include "itkDelaunayRefinementBits.h"

#include <algorithm>

namespace itk
{
namespace
{
constexpr double MostCubes = 1 << 24;
} // namespace

void
DelaunayRefinementPointGrid::Start(const PointType & minimum, const PointType & maximum, double cubeSize)
{
  m_Minimum = minimum;
  m_Points.clear();
  m_Blocks.clear();
  const PointType extent = DelaunayRefinementGeometry::Subtract(maximum, minimum);
  const auto      count = [&extent](double size) {
    return (1.0 + extent[0] / size) * (1.0 + extent[1] / size) * (1.0 + extent[2] / size);
  };
  while (count(cubeSize) > MostCubes)
  {
    cubeSize *= 2.0;
  }
  m_InverseSize = 1.0 / cubeSize;
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_Size[i] = 1 + static_cast<std::int32_t>(extent[i] * m_InverseSize);
  }
  m_LastBlocks.assign(this->ToOffset(m_Size[0] - 1, m_Size[1] - 1, m_Size[2] - 1) + 1, None);
  m_WordsPerRow = static_cast<std::size_t>(m_Size[0] - 1) / 64 + 1;
  m_IsOccupied.assign(m_WordsPerRow * m_Size[1] * m_Size[2], 0);
}

void
DelaunayRefinementPointGrid::Add(const PointType & point)
{
  const CubeType cube = this->ToCube(point);
  std::int32_t & last = m_LastBlocks[this->ToOffset(cube[0], cube[1], cube[2])];
  if (last == None || m_Blocks[last].numberOfPoints == m_Blocks[last].points.size())
  {
    m_Blocks.emplace_back();
    m_Blocks.back().numberOfPoints = 0;
    m_Blocks.back().previous = last;
    last = static_cast<std::int32_t>(m_Blocks.size() - 1);
  }
  m_IsOccupied[m_WordsPerRow * this->ToRow(cube[1], cube[2]) + (cube[0] >> 6)] |= std::uint64_t{ 1 } << (cube[0] & 63);
  BlockType & block = m_Blocks[last];
  block.points[block.numberOfPoints++] = point;
  m_Points.push_back(point);
}

template <typename TVisitor>
bool
DelaunayRefinementPointGrid::VisitBlocks(const PointType & minimum,
                                         const PointType & maximum,
                                         const TVisitor &  visitor) const
{
  const CubeType first = this->ToCube(minimum);
  const CubeType last = this->ToCube(maximum);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      const std::uint64_t * const row = m_IsOccupied.data() + m_WordsPerRow * this->ToRow(y, z);
      for (std::int32_t word = first[0] >> 6; word <= last[0] >> 6; ++word)
      {
        std::uint64_t occupied = row[word] & GetDelaunayRefinementBitsOfRun(first[0], last[0], word);
        for (; occupied != 0; occupied &= occupied - 1)
        {
          const std::int32_t x = 64 * word + static_cast<std::int32_t>(FindDelaunayRefinementBit(occupied));
          for (std::int32_t number = m_LastBlocks[this->ToOffset(x, y, z)]; number != None;
               number = m_Blocks[number].previous)
          {
            if (visitor(m_Blocks[number]))
            {
              return true;
            }
          }
        }
      }
    }
  }
  return false;
}

bool
DelaunayRefinementPointGrid::HasPointWithin(const PointType & point, double radius) const
{
  const double squaredRadius = radius * radius;
  const auto   isWithin = [&](const PointType & other) {
    return DelaunayRefinementGeometry::SquaredDistance(point, other) <= squaredRadius;
  };
  return this->VisitBlocks({ point[0] - radius, point[1] - radius, point[2] - radius },
                           { point[0] + radius, point[1] + radius, point[2] + radius },
                           [&](const BlockType & block) {
                             const auto * const end = block.points.data() + block.numberOfPoints;
                             return std::any_of(block.points.data(), end, isWithin);
                           });
}

void
DelaunayRefinementPointGrid::FindWithinOfBox(const PointType &                    center,
                                             const PointType &                    halfExtents,
                                             double                               radius,
                                             DelaunayRefinementArray<PointType> & found) const
{
  PointType minimum;
  PointType maximum;
  for (unsigned int i = 0; i < 3; ++i)
  {
    minimum[i] = center[i] - halfExtents[i] - radius;
    maximum[i] = center[i] + halfExtents[i] + radius;
  }
  std::size_t number = found.size();
  this->VisitBlocks(minimum, maximum, [&](const BlockType & block) {
    // No branch for each point, as processors can't tell what is within.
    found.resize(number + block.points.size());
    for (std::uint32_t i = 0; i < block.numberOfPoints; ++i)
    {
      const PointType & point = block.points[i];
      double            squared = 0.0;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        const double beyond = std::max(0.0, std::abs(point[axis] - center[axis]) - halfExtents[axis]);
        squared += beyond * beyond;
      }
      found[number] = point;
      number += squared <= radius * radius ? 1 : 0;
    }
    return false;
  });
  found.resize(number);
}
} // end namespace itk
