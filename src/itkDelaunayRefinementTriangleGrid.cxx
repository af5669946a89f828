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
#include "itkDelaunayRefinementTriangleGrid.h"

#include <algorithm>
#include <numeric>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using PointType = DelaunayRefinementPoint;

/** Cubes for each triangle, at most about. */
constexpr double MostCubes = 8.0;

/** By the part of the plane that the point's foot is in (Ericson, Real-Time Collision Detection, 5.1.5). */
double
ComputeSquaredDistance(const PointType & point, const DelaunayRefinementTriangleGrid::TriangleType & triangle)
{
  const auto & [a, b, c] = triangle;
  const PointType ab = Geometry::Subtract(b, a);
  const PointType ac = Geometry::Subtract(c, a);
  const auto      toEdge = [&point](const PointType & from, double share, const PointType & along) {
    return Geometry::SquaredDistance(point, Geometry::AddScaled(from, share, along));
  };
  const PointType fromA = Geometry::Subtract(point, a);
  const double    abFromA = Geometry::Dot(ab, fromA);
  const double    acFromA = Geometry::Dot(ac, fromA);
  if (abFromA <= 0.0 && acFromA <= 0.0)
  {
    return Geometry::Dot(fromA, fromA);
  }
  const PointType fromB = Geometry::Subtract(point, b);
  const double    abFromB = Geometry::Dot(ab, fromB);
  const double    acFromB = Geometry::Dot(ac, fromB);
  if (abFromB >= 0.0 && acFromB <= abFromB)
  {
    return Geometry::Dot(fromB, fromB);
  }
  const double opposesC = abFromA * acFromB - abFromB * acFromA;
  if (opposesC <= 0.0 && abFromA >= 0.0 && abFromB <= 0.0)
  {
    return toEdge(a, abFromA / (abFromA - abFromB), ab);
  }
  const PointType fromC = Geometry::Subtract(point, c);
  const double    abFromC = Geometry::Dot(ab, fromC);
  const double    acFromC = Geometry::Dot(ac, fromC);
  if (acFromC >= 0.0 && abFromC <= acFromC)
  {
    return Geometry::Dot(fromC, fromC);
  }
  const double opposesB = abFromC * acFromA - abFromA * acFromC;
  if (opposesB <= 0.0 && acFromA >= 0.0 && acFromC <= 0.0)
  {
    return toEdge(a, acFromA / (acFromA - acFromC), ac);
  }
  const double opposesA = abFromB * acFromC - abFromC * acFromB;
  const double towardsC = acFromB - abFromB;
  const double towardsB = abFromC - acFromC;
  if (opposesA <= 0.0 && towardsC >= 0.0 && towardsB >= 0.0)
  {
    return toEdge(b, towardsC / (towardsC + towardsB), Geometry::Subtract(c, b));
  }
  const PointType normal = Geometry::Cross(ab, ac);
  const double    height = Geometry::Dot(fromA, normal);
  return height * height / Geometry::Dot(normal, normal);
}
} // namespace

template <typename TAction>
void
DelaunayRefinementTriangleGrid::ForEachCube(const TriangleType & triangle, const TAction & action) const
{
  PointType minimum = triangle[0];
  PointType maximum = triangle[0];
  for (unsigned int i = 0; i < 3; ++i)
  {
    minimum[i] = std::min({ triangle[0][i], triangle[1][i], triangle[2][i] });
    maximum[i] = std::max({ triangle[0][i], triangle[1][i], triangle[2][i] });
  }
  const CubeType first = m_Cubes.ToCube(minimum);
  const CubeType last = m_Cubes.ToCube(maximum);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        action(m_Cubes.ToOffset({ x, y, z }));
      }
    }
  }
}

void
DelaunayRefinementTriangleGrid::Start(std::vector<TriangleType> triangles)
{
  m_Triangles = std::move(triangles);
  m_Numbers.clear();
  if (m_Triangles.empty())
  {
    return;
  }
  PointType minimum = m_Triangles.front().front();
  PointType maximum = minimum;
  double    sumOfEdges = 0.0;
  for (const TriangleType & triangle : m_Triangles)
  {
    for (const PointType & point : triangle)
    {
      for (unsigned int i = 0; i < 3; ++i)
      {
        minimum[i] = std::min(minimum[i], point[i]);
        maximum[i] = std::max(maximum[i], point[i]);
      }
    }
    sumOfEdges += Geometry::Distance(triangle[0], triangle[1]);
  }
  const PointType extent = Geometry::Subtract(maximum, minimum);
  const double    mean = sumOfEdges / static_cast<double>(m_Triangles.size());
  const double    volume = (extent[0] + mean) * (extent[1] + mean) * (extent[2] + mean);
  m_Cubes.Start(
    minimum, extent, std::max(mean, std::cbrt(volume / (MostCubes * static_cast<double>(m_Triangles.size())))));
  m_Ends.assign(m_Cubes.GetNumber() + 1, 0);
  for (const TriangleType & triangle : m_Triangles)
  {
    this->ForEachCube(triangle, [this](std::size_t cube) { ++m_Ends[cube + 1]; });
  }
  std::partial_sum(m_Ends.begin(), m_Ends.end(), m_Ends.begin());
  m_Numbers.resize(m_Ends.back());
  std::vector<std::uint32_t> next(m_Ends.begin(), m_Ends.end() - 1);
  for (std::uint32_t number = 0; number < m_Triangles.size(); ++number)
  {
    this->ForEachCube(m_Triangles[number], [&](std::size_t cube) { m_Numbers[next[cube]++] = number; });
  }
}

DelaunayRefinementTriangleGrid::NearType
DelaunayRefinementTriangleGrid::Find(const PointType & point, double enough, double reach, std::uint32_t first) const
{
  NearType nearest;
  if (m_Triangles.empty())
  {
    return nearest;
  }
  const double   squaredEnough = enough > 0.0 ? enough * enough : -1.0;
  const CubeType middle = m_Cubes.ToCube(point);
  double         squared = reach * reach;
  if (first != None)
  {
    const double own = ComputeSquaredDistance(point, m_Triangles[first]);
    if (own <= squared)
    {
      squared = own;
      nearest.number = first;
    }
  }
  const auto visit = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    const std::size_t cube = m_Cubes.ToOffset({ x, y, z });
    for (std::uint32_t i = m_Ends[cube]; i < m_Ends[cube + 1]; ++i)
    {
      const double own = ComputeSquaredDistance(point, m_Triangles[m_Numbers[i]]);
      if (own <= squared)
      {
        squared = own;
        nearest.number = m_Numbers[i];
      }
    }
  };
  const std::int32_t mostRings = std::max({ m_Cubes.length[0], m_Cubes.length[1], m_Cubes.length[2] });
  for (std::int32_t ring = 0; ring <= mostRings && squared > squaredEnough; ++ring)
  {
    // What is left lies beyond the cubes of the rings before.
    double distanceBeyond = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double low = m_Cubes.minimum[i] + (middle[i] - ring + 1) * m_Cubes.size;
      const double high = m_Cubes.minimum[i] + (middle[i] + ring) * m_Cubes.size;
      distanceBeyond = std::min({ distanceBeyond,
                                  middle[i] - ring >= 0 ? point[i] - low : distanceBeyond,
                                  middle[i] + ring < m_Cubes.length[i] ? high - point[i] : distanceBeyond });
    }
    if (ring > 0 && distanceBeyond > 0.0 && distanceBeyond * distanceBeyond > squared)
    {
      break;
    }
    for (std::int32_t z = std::max(0, middle[2] - ring); z <= std::min(m_Cubes.length[2] - 1, middle[2] + ring); ++z)
    {
      for (std::int32_t y = std::max(0, middle[1] - ring); y <= std::min(m_Cubes.length[1] - 1, middle[1] + ring); ++y)
      {
        const bool         isFace = std::max(std::abs(z - middle[2]), std::abs(y - middle[1])) == ring;
        const std::int32_t step = isFace || ring == 0 ? 1 : 2 * ring;
        for (std::int32_t x = middle[0] - ring; x <= middle[0] + ring; x += step)
        {
          if (x >= 0 && x < m_Cubes.length[0])
          {
            visit(x, y, z);
          }
        }
      }
    }
  }
  if (nearest.number != None)
  {
    nearest.distance = std::sqrt(squared);
  }
  return nearest;
}
} // end namespace itk
