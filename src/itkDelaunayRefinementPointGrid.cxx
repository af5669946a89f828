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
  m_Last.assign(this->ToOffset(m_Size[0] - 1, m_Size[1] - 1, m_Size[2] - 1) + 1, None);
}

std::int32_t
DelaunayRefinementPointGrid::Add(const PointType & point)
{
  const CubeType cube = this->ToCube(point, 0.0);
  std::int32_t & last = m_Last[this->ToOffset(cube[0], cube[1], cube[2])];
  m_Nodes.push_back({ point, last });
  last = static_cast<std::int32_t>(m_Nodes.size() - 1);
  return last;
}

std::int32_t
DelaunayRefinementPointGrid::FindNearest(const PointType & point, double radius, double enough) const
{
  const CubeType first = this->ToCube(point, -radius);
  const CubeType last = this->ToCube(point, radius);
  const double   squaredEnough = enough * enough;
  double         best = radius * radius;
  std::int32_t   nearest = None;
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        for (std::int32_t node = m_Last[this->ToOffset(x, y, z)]; node != None; node = m_Nodes[node].previous)
        {
          const double squared = DelaunayRefinementGeometry::SquaredDistance(point, m_Nodes[node].point);
          if (squared <= best)
          {
            best = squared;
            nearest = node;
            if (best <= squaredEnough)
            {
              return nearest;
            }
          }
        }
      }
    }
  }
  return nearest;
}

void
DelaunayRefinementPointGrid::FindWithin(const PointType & point, double radius, std::vector<PointType> & found) const
{
  const CubeType first = this->ToCube(point, -radius);
  const CubeType last = this->ToCube(point, radius);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        for (std::int32_t node = m_Last[this->ToOffset(x, y, z)]; node != None; node = m_Nodes[node].previous)
        {
          if (DelaunayRefinementGeometry::SquaredDistance(point, m_Nodes[node].point) <= radius * radius)
          {
            found.push_back(m_Nodes[node].point);
          }
        }
      }
    }
  }
}
} // end namespace itk
