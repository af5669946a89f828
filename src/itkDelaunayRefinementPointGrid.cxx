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

namespace itk
{
namespace
{
constexpr double MostCubes = 1 << 24;
} // namespace

DelaunayRefinementPointGrid::DelaunayRefinementPointGrid(const PointType & minimum,
                                                         const PointType & maximum,
                                                         double            cubeSize)
  : m_Minimum(minimum)
{
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
}

void
DelaunayRefinementPointGrid::Add(const PointType & point)
{
  const CubeType cube = this->ToCube(point, 0.0);
  std::int32_t & last = m_LastBlocks[this->ToOffset(cube[0], cube[1], cube[2])];
  if (last == None || m_Blocks[last].numberOfPoints == m_Blocks[last].points.size())
  {
    m_Blocks.push_back({ {}, 0, last });
    last = static_cast<std::int32_t>(m_Blocks.size() - 1);
  }
  BlockType & block = m_Blocks[last];
  block.points[block.numberOfPoints++] = point;
  m_Points.push_back(point);
}

template <typename TVisitor>
bool
DelaunayRefinementPointGrid::VisitWithin(const PointType & point, double radius, const TVisitor & visitor) const
{
  const CubeType first = this->ToCube(point, -radius);
  const CubeType last = this->ToCube(point, radius);
  const double   squaredRadius = radius * radius;
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        for (std::int32_t number = m_LastBlocks[this->ToOffset(x, y, z)]; number != None;)
        {
          const BlockType & block = m_Blocks[number];
          for (std::uint32_t i = 0; i < block.numberOfPoints; ++i)
          {
            if (DelaunayRefinementGeometry::SquaredDistance(point, block.points[i]) <= squaredRadius &&
                visitor(block.points[i]))
            {
              return true;
            }
          }
          number = block.previous;
        }
      }
    }
  }
  return false;
}

bool
DelaunayRefinementPointGrid::HasPointWithin(const PointType & point, double radius) const
{
  return this->VisitWithin(point, radius, [](const PointType &) { return true; });
}

void
DelaunayRefinementPointGrid::FindWithin(const PointType & point, double radius, std::vector<PointType> & found) const
{
  this->VisitWithin(point, radius, [&found](const PointType & other) {
    found.push_back(other);
    return false;
  });
}
} // end namespace itk
