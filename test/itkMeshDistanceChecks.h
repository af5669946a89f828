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
#ifndef itkMeshDistanceChecks_h
#define itkMeshDistanceChecks_h

#include "itkCheckedMesh.h"

#include <algorithm>

namespace itk::DelaunayRefinementTest
{
/** An axis-aligned box. */
struct BoxType
{
  PointType minimum;
  PointType maximum;
};

inline BoxType
ComputeBoundingBox(const std::vector<PointType> & points)
{
  BoxType box{ points.front(), points.front() };
  for (const PointType & point : points)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      box.minimum[i] = std::min(box.minimum[i], point[i]);
      box.maximum[i] = std::max(box.maximum[i], point[i]);
    }
  }
  return box;
}

/** \class SpatialGrid
 * \brief Finds items by their bounding boxes.
 */
class SpatialGrid
{
public:
  explicit SpatialGrid(const std::vector<BoxType> & boxes)
  {
    std::vector<PointType> corners;
    for (const BoxType & box : boxes)
    {
      corners.push_back(box.minimum);
      corners.push_back(box.maximum);
    }
    m_Bounds = corners.empty() ? BoxType{} : ComputeBoundingBox(corners);
    const PointType size = Subtract(m_Bounds.maximum, m_Bounds.minimum);
    const double    longest = std::max({ size[0], size[1], size[2], std::numeric_limits<double>::min() });
    m_CellSize = longest / std::max(1.0, 2.0 * std::cbrt(static_cast<double>(boxes.size())));
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Size[i] = static_cast<std::size_t>(size[i] / m_CellSize) + 1;
    }
    m_Cells.resize(m_Size[0] * m_Size[1] * m_Size[2]);
    for (std::size_t item = 0; item < boxes.size(); ++item)
    {
      this->ForEachCell(boxes[item], [this, item](std::size_t cell) { m_Cells[cell].push_back(item); });
    }
  }

  /** Calls function(item) for every item whose box may meet the given one; some items more than once. */
  template <typename TFunction>
  void
  ForEachItem(const BoxType & box, TFunction && function) const
  {
    this->ForEachCell(box, [this, &function](std::size_t cell) {
      for (const std::size_t item : m_Cells[cell])
      {
        function(item);
      }
    });
  }

  /** The smallest distance(item) if every item is within its box. */
  template <typename TFunction>
  double
  FindSmallestDistance(const PointType & point, TFunction && distance) const
  {
    const double reach = Distance(m_Bounds.minimum, m_Bounds.maximum) +
                         Distance(point, Scale(Add(m_Bounds.minimum, m_Bounds.maximum), 0.5));
    double smallest = std::numeric_limits<double>::infinity();
    double radius = 0.0;
    // An item found in the corners of a box may be farther than one outside of it.
    while (smallest > radius && radius <= reach)
    {
      radius = std::max(2.0 * radius, m_CellSize);
      const PointType offset{ radius, radius, radius };
      this->ForEachItem({ Subtract(point, offset), Add(point, offset) },
                        [&](std::size_t item) { smallest = std::min(smallest, distance(item)); });
    }
    return smallest;
  }

private:
  template <typename TFunction>
  void
  ForEachCell(const BoxType & box, TFunction && function) const
  {
    std::array<std::size_t, 3> first;
    std::array<std::size_t, 3> last;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const auto toIndex = [this, i](double x) {
        const double index = (x - m_Bounds.minimum[i]) / m_CellSize;
        return static_cast<std::size_t>(std::min(std::max(index, 0.0), static_cast<double>(m_Size[i] - 1)));
      };
      if (box.maximum[i] < m_Bounds.minimum[i] || box.minimum[i] > m_Bounds.maximum[i])
      {
        return;
      }
      first[i] = toIndex(box.minimum[i]);
      last[i] = toIndex(box.maximum[i]);
    }
    for (std::size_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::size_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::size_t x = first[0]; x <= last[0]; ++x)
        {
          function(x + m_Size[0] * (y + m_Size[1] * z));
        }
      }
    }
  }

  BoxType                               m_Bounds{};
  double                                m_CellSize{ 1.0 };
  std::array<std::size_t, 3>            m_Size{};
  std::vector<std::vector<std::size_t>> m_Cells{};
};

/** \class PointLocator
 * \brief Finds the distance to the nearest of some points.
 */
class PointLocator
{
public:
  explicit PointLocator(const std::vector<PointType> & points)
    : m_Points(points)
    , m_Grid(MakeBoxes(points))
  {}

  double
  FindDistance(const PointType & point) const
  {
    return m_Grid.FindSmallestDistance(point, [&](std::size_t i) { return Distance(point, m_Points[i]); });
  }

  const SpatialGrid &
  GetGrid() const
  {
    return m_Grid;
  }

private:
  static std::vector<BoxType>
  MakeBoxes(const std::vector<PointType> & points)
  {
    std::vector<BoxType> boxes;
    for (const PointType & point : points)
    {
      boxes.push_back({ point, point });
    }
    return boxes;
  }

  std::vector<PointType> m_Points;
  SpatialGrid            m_Grid;
};

/** \class TriangleLocator
 * \brief Finds the distance to the nearest of a mesh's triangles.
 */
class TriangleLocator
{
public:
  explicit TriangleLocator(const CheckedMesh & mesh)
    : m_Mesh(mesh)
    , m_Grid(MakeBoxes(mesh))
  {}

  double
  FindDistance(const PointType & point) const
  {
    return m_Grid.FindSmallestDistance(point, [&](std::size_t i) {
      const auto & triangle = m_Mesh.triangles[i];
      return Distance(point,
                      ComputeClosestPointOfTriangle(
                        point, m_Mesh.points[triangle[0]], m_Mesh.points[triangle[1]], m_Mesh.points[triangle[2]]));
    });
  }

private:
  static std::vector<BoxType>
  MakeBoxes(const CheckedMesh & mesh)
  {
    std::vector<BoxType> boxes;
    for (const auto & triangle : mesh.triangles)
    {
      boxes.push_back(
        ComputeBoundingBox({ mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]] }));
    }
    return boxes;
  }

  CheckedMesh m_Mesh;
  SpatialGrid m_Grid;
};

/** Tetrahedra with a vertex of the mesh strictly inside their circumsphere, by more than a millionth of its radius.
 * Every n-th tetrahedron is looked at, so that there are some maximumNumberOfSamples at most.
 * None for all tetrahedra implies that no two tetrahedra overlap. */
inline std::size_t
CountDelaunayViolations(const CheckedMesh & mesh, std::size_t maximumNumberOfSamples = 5000)
{
  constexpr long double tolerance = 1e-6L;
  const PointLocator    locator(mesh.points);
  const std::size_t     step = 1 + mesh.tetrahedra.size() / maximumNumberOfSamples;
  std::size_t           count = 0;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); i += step)
  {
    const auto &       t = mesh.tetrahedra[i];
    const PointType &  origin = mesh.points[t[0]];
    const Circumsphere sphere = ComputeCircumsphere(origin, mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    const auto         radius = static_cast<double>(sphere.radius);
    const PointType    center{ origin[0] + static_cast<double>(sphere.center[0]),
                            origin[1] + static_cast<double>(sphere.center[1]),
                            origin[2] + static_cast<double>(sphere.center[2]) };
    const PointType    offset{ radius, radius, radius };
    bool               isViolated = false;
    locator.GetGrid().ForEachItem({ Subtract(center, offset), Add(center, offset) }, [&](std::size_t vertex) {
      const long double distance = Norm(Subtract(LongDifference(origin, mesh.points[vertex]), sphere.center));
      isViolated = isViolated || distance < sphere.radius * (1 - tolerance);
    });
    count += isViolated ? 1 : 0;
  }
  return count;
}

/** Points of the triangles at most \c spacing apart, vertices included. */
inline std::vector<PointType>
SampleBoundary(const CheckedMesh & mesh, double spacing)
{
  std::vector<PointType> samples;
  for (const auto & triangle : mesh.triangles)
  {
    const PointType & corner = mesh.points[triangle[0]];
    const PointType   u = Subtract(mesh.points[triangle[1]], corner);
    const PointType   v = Subtract(mesh.points[triangle[2]], corner);
    const double      longest = std::max({ Norm(u), Norm(v), Norm(Subtract(u, v)) });
    const int         n = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; i + j <= n; ++j)
      {
        samples.push_back(Add(corner, Add(Scale(u, static_cast<double>(i) / n), Scale(v, static_cast<double>(j) / n))));
      }
    }
  }
  return samples;
}

/** The largest distance(point) of the samples; NaN if any is. */
template <typename TFunction>
double
ComputeMaximumDistance(const std::vector<PointType> & samples, TFunction && distance)
{
  double maximum = 0.0;
  for (const PointType & sample : samples)
  {
    const double value = distance(sample);
    if (!(value <= maximum))
    {
      maximum = value;
    }
  }
  return maximum;
}

/** From points of a surface to the mesh's boundary. */
inline double
ComputeDistanceToBoundary(const std::vector<PointType> & surfaceSamples, const CheckedMesh & mesh)
{
  const TriangleLocator locator(mesh);
  return ComputeMaximumDistance(surfaceSamples,
                                [&locator](const PointType & sample) { return locator.FindDistance(sample); });
}
} // end namespace itk::DelaunayRefinementTest

#endif
