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
#include "itkDelaunayRefinementSizeField.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
constexpr double MostCubes = 1e7;
} // namespace

void
DelaunayRefinementSizeField::Start(const BoundsType & bounds, double cubeSize, double size)
{
  double volume = 1.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    volume *= std::max(bounds.maximum[i] - bounds.minimum[i], cubeSize);
  }
  m_Minimum = bounds.minimum;
  m_CubeSize = std::max(cubeSize, std::cbrt(volume / MostCubes));
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_Length[i] = static_cast<std::int32_t>((bounds.maximum[i] - bounds.minimum[i]) / m_CubeSize) + 1;
  }
  m_Sizes.assign(static_cast<std::size_t>(m_Length[0]) * m_Length[1] * m_Length[2], static_cast<float>(size));
}

double
DelaunayRefinementSizeField::ComputeDistance(const PointType & point, const CubeType & cube) const
{
  double squared = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double low = m_Minimum[i] + cube[i] * m_CubeSize;
    const double beyond = std::max({ low - point[i], point[i] - (low + m_CubeSize), 0.0 });
    squared += beyond * beyond;
  }
  return std::sqrt(squared);
}

void
DelaunayRefinementSizeField::Lower(const PointType & point, double radius, double size)
{
  // A relative step that is too small to go on for.
  constexpr double step = 1e-3;
  const auto       lower = [&](const CubeType & cube) {
    const double lowered = size + Growth * std::max(0.0, this->ComputeDistance(point, cube) - radius);
    float &      own = m_Sizes[this->ToOffset(cube)];
    if (lowered < own * (1.0 - step))
    {
      own = static_cast<float>(lowered);
      m_Queue.push_back(cube);
    }
  };
  // From the point outwards, as far as something changes.
  m_Queue.clear();
  lower(this->ToCube(point, 0.0));
  for (std::size_t next = 0; next < m_Queue.size(); ++next)
  {
    const CubeType cube = m_Queue[next];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (const std::int32_t offset : { -1, 1 })
      {
        CubeType neighbor = cube;
        neighbor[axis] += offset;
        if (neighbor[axis] >= 0 && neighbor[axis] < m_Length[axis])
        {
          lower(neighbor);
        }
      }
    }
  }
}

DelaunayRefinementSizeField::RangeType
DelaunayRefinementSizeField::GetRange(const PointType & point, double radius) const
{
  const CubeType first = this->ToCube(point, -radius);
  const CubeType last = this->ToCube(point, radius);
  const double   own = m_Sizes[this->ToOffset(first)];
  RangeType      range{ own, own };
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      const float * row = m_Sizes.data() + this->ToOffset({ 0, y, z });
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        range.least = std::min<double>(range.least, row[x]);
        range.greatest = std::max<double>(range.greatest, row[x]);
      }
    }
  }
  return range;
}
} // end namespace itk
