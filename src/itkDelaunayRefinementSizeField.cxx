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
constexpr double MostCubes = 4e6;
} // namespace

void
DelaunayRefinementSizeField::Start(const BoundsType & bounds, double cubeSize, double size)
{
  double volume = 1.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    volume *= std::max(bounds.maximum[i] - bounds.minimum[i], cubeSize);
  }
  m_Cubes.Start(bounds.minimum,
                DelaunayRefinementGeometry::Subtract(bounds.maximum, bounds.minimum),
                std::max(cubeSize, std::cbrt(volume / MostCubes)));
  m_Sizes.assign(m_Cubes.GetNumber(), static_cast<float>(size));
}

double
DelaunayRefinementSizeField::ComputeDistance(const PointType & point, const CubeType & cube) const
{
  double squared = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double low = m_Cubes.minimum[i] + cube[i] * m_Cubes.size;
    const double beyond = std::max({ low - point[i], point[i] - (low + m_Cubes.size), 0.0 });
    squared += beyond * beyond;
  }
  return std::sqrt(squared);
}

void
DelaunayRefinementSizeField::Lower(const PointType & point, double radius, double size)
{
  const CubeType first = m_Cubes.ToCube(point, -radius);
  const CubeType last = m_Cubes.ToCube(point, radius);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        float & own = m_Sizes[m_Cubes.ToOffset({ x, y, z })];
        if (size < own && this->ComputeDistance(point, { x, y, z }) <= radius)
        {
          own = static_cast<float>(size);
        }
      }
    }
  }
}

double
DelaunayRefinementSizeField::Lower(const std::function<double(const PointType &, double)> & size)
{
  const double half = 0.5 * m_Cubes.size;
  float *      own = m_Sizes.data();
  float        least = std::numeric_limits<float>::infinity();
  for (std::int32_t z = 0; z < m_Cubes.length[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Cubes.length[1]; ++y)
    {
      for (std::int32_t x = 0; x < m_Cubes.length[0]; ++x)
      {
        const PointType center{ m_Cubes.minimum[0] + (2 * x + 1) * half,
                                m_Cubes.minimum[1] + (2 * y + 1) * half,
                                m_Cubes.minimum[2] + (2 * z + 1) * half };
        *own = std::min(*own, static_cast<float>(size(center, half)));
        least = std::min(least, *own++);
      }
    }
  }
  return least;
}

void
DelaunayRefinementSizeField::Grade()
{
  // Once in the order of the cubes and once against it, each time from the neighbors that come before.
  const std::int32_t rows = m_Cubes.length[1] * m_Cubes.length[2];
  for (const std::int32_t direction : { 1, -1 })
  {
    for (std::int32_t count = 0; count < rows; ++count)
    {
      const std::int32_t row = direction > 0 ? count : rows - 1 - count;
      const std::int32_t y = row % m_Cubes.length[1];
      const std::int32_t z = row / m_Cubes.length[1];
      this->GradeRow(y, z, -direction);
    }
  }
}

void
DelaunayRefinementSizeField::GradeRow(std::int32_t y, std::int32_t z, std::int32_t before)
{
  const float        step = static_cast<float>(Growth * m_Cubes.size);
  const std::int32_t length = m_Cubes.length[0];
  float * const      own = m_Sizes.data() + m_Cubes.ToOffset({ 0, y, z });
  const auto         gradeFrom = [&](std::int32_t dy, std::int32_t dz) {
    if (y + dy < 0 || y + dy >= m_Cubes.length[1] || z + dz < 0 || z + dz >= m_Cubes.length[2])
    {
      return;
    }
    const float * const other = m_Sizes.data() + m_Cubes.ToOffset({ 0, y + dy, z + dz });
    const auto          across = static_cast<float>(dy * dy + dz * dz);
    const float         straight = step * std::sqrt(across);
    const float         diagonal = step * std::sqrt(across + 1.0f);
    for (std::int32_t x = 0; x < length; ++x)
    {
      own[x] = std::min(own[x], other[x] + straight);
      own[x] = std::min(own[x], other[std::max(x - 1, 0)] + diagonal);
      own[x] = std::min(own[x], other[std::min(x + 1, length - 1)] + diagonal);
    }
  };
  gradeFrom(-1, before);
  gradeFrom(0, before);
  gradeFrom(1, before);
  gradeFrom(before, 0);
  for (std::int32_t count = 1; count < length; ++count)
  {
    const std::int32_t x = before < 0 ? count : length - 1 - count;
    own[x] = std::min(own[x], own[x + before] + step);
  }
}

bool
DelaunayRefinementSizeField::HasChanged(const PointType & point, double radius) const
{
  if (m_Settled.empty())
  {
    return true;
  }
  const CubeType first = m_Cubes.ToCube(point, -radius);
  const CubeType last = m_Cubes.ToCube(point, radius);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      const auto begin = static_cast<std::ptrdiff_t>(m_Cubes.ToOffset({ first[0], y, z }));
      const auto end = begin + last[0] - first[0] + 1;
      if (!std::equal(m_Sizes.begin() + begin, m_Sizes.begin() + end, m_Settled.begin() + begin))
      {
        return true;
      }
    }
  }
  return false;
}

DelaunayRefinementSizeField::RangeType
DelaunayRefinementSizeField::GetRange(const PointType & point, double radius) const
{
  const CubeType first = m_Cubes.ToCube(point, -radius);
  const CubeType last = m_Cubes.ToCube(point, radius);
  const double   own = m_Sizes[m_Cubes.ToOffset(first)];
  RangeType      range{ own, own };
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      const float * row = m_Sizes.data() + m_Cubes.ToOffset({ 0, y, z });
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
