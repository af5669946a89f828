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
#ifndef itkMeshChecks_h
#define itkMeshChecks_h

#include "itkCheckedMesh.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

namespace itk::DelaunayRefinementTest
{
/** \class TetrahedronFace
 * \brief A face of a tetrahedron, counterclockwise as seen from outside of it.
 */
struct TetrahedronFace
{
  std::array<std::uint32_t, 3> vertices;
  std::array<std::uint32_t, 3> sortedVertices;
  std::size_t                  tetrahedron;
  std::uint32_t                opposite;
};

template <std::size_t VSize>
std::array<std::uint32_t, VSize>
MakeSorted(std::array<std::uint32_t, VSize> vertices)
{
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/** A triangle with its smallest vertex first and its orientation kept. */
inline std::array<std::uint32_t, 3>
MakeCanonical(std::array<std::uint32_t, 3> triangle)
{
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/** All faces of all tetrahedra, those with the same vertices next to each other. */
inline std::vector<TetrahedronFace>
ComputeFaces(const CheckedMesh & mesh)
{
  static constexpr unsigned int faceVertices[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  std::vector<TetrahedronFace>  faces;
  faces.reserve(4 * mesh.tetrahedra.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    const auto & tetrahedron = mesh.tetrahedra[t];
    for (unsigned int i = 0; i < 4; ++i)
    {
      const std::array<std::uint32_t, 3> vertices{ tetrahedron[faceVertices[i][0]],
                                                   tetrahedron[faceVertices[i][1]],
                                                   tetrahedron[faceVertices[i][2]] };
      faces.push_back({ vertices, MakeSorted(vertices), t, tetrahedron[i] });
    }
  }
  std::sort(faces.begin(), faces.end(), [](const TetrahedronFace & a, const TetrahedronFace & b) {
    return std::tie(a.sortedVertices, a.tetrahedron) < std::tie(b.sortedVertices, b.tetrahedron);
  });
  return faces;
}

/** Calls function(first, last) for each run of faces with the same vertices. */
template <typename TFunction>
void
ForEachFace(const std::vector<TetrahedronFace> & faces, TFunction && function)
{
  for (auto first = faces.begin(); first != faces.end();)
  {
    const auto last = std::find_if(first, faces.end(), [first](const TetrahedronFace & face) {
      return face.sortedVertices != first->sortedVertices;
    });
    function(first, last);
    first = last;
  }
}

/** The label of the tetrahedron that has a face; the same for all of a mesh without cell data. */
inline double
GetLabel(const CheckedMesh & mesh, const TetrahedronFace & face)
{
  return mesh.tetrahedronLabels.size() == mesh.tetrahedra.size() ? mesh.tetrahedronLabels[face.tetrahedron] : 1.0;
}

/** The faces of exactly one tetrahedron, and those of two with different labels, counterclockwise as seen from outside
 * or from the smaller label. */
inline std::vector<std::array<std::uint32_t, 3>>
ComputeBoundaryTriangles(const CheckedMesh & mesh)
{
  std::vector<std::array<std::uint32_t, 3>> triangles;
  ForEachFace(ComputeFaces(mesh), [&mesh, &triangles](auto first, auto last) {
    if (last - first == 1)
    {
      triangles.push_back(first->vertices);
    }
    else if (last - first == 2 && GetLabel(mesh, *first) != GetLabel(mesh, *(first + 1)))
    {
      triangles.push_back((GetLabel(mesh, *first) > GetLabel(mesh, *(first + 1)) ? first : first + 1)->vertices);
    }
  });
  return triangles;
}

/** \name Validity
 * All of these must be 0. All but the first take for granted that the first is 0.
 */
///@{
/** Cells with vertices that do not exist. */
inline std::size_t
CountBadIndices(const CheckedMesh & mesh)
{
  const auto isBad = [&mesh](const auto & cell) {
    return std::any_of(cell.begin(), cell.end(), [&mesh](std::uint32_t v) { return v >= mesh.points.size(); });
  };
  return std::count_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), isBad) +
         std::count_if(mesh.triangles.begin(), mesh.triangles.end(), isBad);
}

inline std::size_t
CountNonFinitePoints(const CheckedMesh & mesh)
{
  return std::count_if(mesh.points.begin(), mesh.points.end(), [](const PointType & point) {
    return !std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
  });
}

inline std::size_t
CountDuplicatePoints(const CheckedMesh & mesh)
{
  return mesh.points.size() - std::set<PointType>(mesh.points.begin(), mesh.points.end()).size();
}

/** Points of no tetrahedron. */
inline std::size_t
CountOrphanPoints(const CheckedMesh & mesh)
{
  std::set<std::uint32_t> used;
  for (const auto & tetrahedron : mesh.tetrahedra)
  {
    used.insert(tetrahedron.begin(), tetrahedron.end());
  }
  return mesh.points.size() - used.size();
}

inline std::size_t
CountDuplicateTetrahedra(const CheckedMesh & mesh)
{
  std::set<std::array<std::uint32_t, 4>> unique;
  for (const auto & tetrahedron : mesh.tetrahedra)
  {
    unique.insert(MakeSorted(tetrahedron));
  }
  return mesh.tetrahedra.size() - unique.size();
}

/** Tetrahedra that are not positively oriented, by exact arithmetic. */
inline std::size_t
CountInvertedTetrahedra(const CheckedMesh & mesh)
{
  return std::count_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&mesh](const auto & t) {
    return ComputeOrientation(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) <= 0;
  });
}

/** The smallest ratio of a tetrahedron's volume to its longest edge cubed. */
inline double
ComputeMinimumRelativeVolume(const CheckedMesh & mesh)
{
  double minimum = std::numeric_limits<double>::infinity();
  for (const auto & t : mesh.tetrahedra)
  {
    double longest = 0.0;
    for (unsigned int i = 0; i < 4; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
      {
        longest = std::max(longest, Distance(mesh.points[t[i]], mesh.points[t[j]]));
      }
    }
    const double volume =
      ComputeTetrahedronVolume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    minimum = std::min(minimum, longest > 0.0 ? volume / (longest * longest * longest) : 0.0);
  }
  return minimum;
}

/** Faces of more than two tetrahedra. */
inline std::size_t
CountOversharedFaces(const CheckedMesh & mesh)
{
  std::size_t count = 0;
  ForEachFace(ComputeFaces(mesh), [&count](auto first, auto last) { count += last - first > 2 ? 1 : 0; });
  return count;
}

/** Faces of two tetrahedra that are on the same side of it. */
inline std::size_t
CountFoldedFaces(const CheckedMesh & mesh)
{
  std::size_t count = 0;
  ForEachFace(ComputeFaces(mesh), [&mesh, &count](auto first, auto last) {
    if (last - first == 2)
    {
      const auto sideOf = [&mesh, first](std::uint32_t vertex) {
        return ComputeOrientation(mesh.points[first->vertices[0]],
                                  mesh.points[first->vertices[1]],
                                  mesh.points[first->vertices[2]],
                                  mesh.points[vertex]);
      };
      count += sideOf(first->opposite) * sideOf((last - 1)->opposite) >= 0 ? 1 : 0;
    }
  });
  return count;
}

/** Triangles whose labels are not those of the tetrahedra on their two sides, the larger one first. Outside is 0. */
inline std::size_t
CountTriangleLabelMismatches(const CheckedMesh & mesh)
{
  using PairType = std::array<double, 2>;
  std::map<std::array<std::uint32_t, 3>, PairType> expected;
  ForEachFace(ComputeFaces(mesh), [&](auto first, auto last) {
    const double one = GetLabel(mesh, *first);
    const double other = last - first == 1 ? 0.0 : GetLabel(mesh, *(first + 1));
    expected[first->sortedVertices] = { std::max(one, other), std::min(one, other) };
  });
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto found = expected.find(MakeSorted(mesh.triangles[i]));
    count += found == expected.end() || found->second != PairType{ mesh.triangleLabels[i], mesh.triangleOtherLabels[i] }
               ? 1
               : 0;
  }
  return count;
}

/** Faces of exactly one tetrahedron, or of two with different labels, that are not among the triangles, and triangles
 * that are no such faces; one that looks inward counts as both. */
inline std::size_t
CountBoundaryMismatches(const CheckedMesh & mesh)
{
  const auto makeSortedList = [](std::vector<std::array<std::uint32_t, 3>> triangles) {
    std::transform(triangles.begin(), triangles.end(), triangles.begin(), MakeCanonical);
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  const auto                                expected = makeSortedList(ComputeBoundaryTriangles(mesh));
  const auto                                actual = makeSortedList(mesh.triangles);
  std::vector<std::array<std::uint32_t, 3>> difference;
  std::set_symmetric_difference(
    expected.begin(), expected.end(), actual.begin(), actual.end(), std::back_inserter(difference));
  return difference.size();
}
///@}

/** \name Quality
 */
///@{
/** The largest ratio of circumradius to shortest edge of tetrahedra. */
inline double
ComputeMaximumRadiusEdgeRatio(const CheckedMesh & mesh)
{
  long double maximum = 0;
  for (const auto & t : mesh.tetrahedra)
  {
    long double shortest = std::numeric_limits<long double>::infinity();
    for (unsigned int i = 0; i < 4; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
      {
        shortest = std::min(shortest, Norm(LongDifference(mesh.points[t[i]], mesh.points[t[j]])));
      }
    }
    const Circumsphere sphere =
      ComputeCircumsphere(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    maximum = std::max(maximum, sphere.radius / shortest);
  }
  return static_cast<double>(maximum);
}

inline double
ComputeMaximumCircumradius(const CheckedMesh & mesh)
{
  long double maximum = 0;
  for (const auto & t : mesh.tetrahedra)
  {
    maximum = std::max(
      maximum, ComputeCircumsphere(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]).radius);
  }
  return static_cast<double>(maximum);
}

/** \class AngleRange
 * \brief Smallest and largest angle, in degrees.
 */
struct AngleRange
{
  double minimum{ 180.0 };
  double maximum{ 0.0 };

  void
  Extend(double angle)
  {
    minimum = std::min(minimum, angle);
    maximum = std::max(maximum, angle);
  }
};

/** Planar angles of the triangles. */
inline AngleRange
ComputePlanarAngles(const CheckedMesh & mesh)
{
  AngleRange range;
  for (const auto & triangle : mesh.triangles)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      const PointType & apex = mesh.points[triangle[i]];
      range.Extend(ComputeAngle(LongDifference(apex, mesh.points[triangle[(i + 1) % 3]]),
                                LongDifference(apex, mesh.points[triangle[(i + 2) % 3]])));
    }
  }
  return range;
}

/** Dihedral angles of the tetrahedra. */
inline AngleRange
ComputeDihedralAngles(const CheckedMesh & mesh)
{
  AngleRange range;
  for (const auto & t : mesh.tetrahedra)
  {
    for (unsigned int i = 0; i < 4; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
      {
        // The two vertices that are not on the edge from i to j.
        const unsigned int   k = i != 0 && j != 0 ? 0 : (i != 1 && j != 1 ? 1 : 2);
        const unsigned int   l = 6 - i - j - k;
        const LongVectorType edge = LongDifference(mesh.points[t[i]], mesh.points[t[j]]);
        const auto           normalTo = [&](unsigned int m) {
          return Cross(edge, LongDifference(mesh.points[t[i]], mesh.points[t[m]]));
        };
        range.Extend(ComputeAngle(normalTo(k), normalTo(l)));
      }
    }
  }
  return range;
}
///@}

/** \name Measures
 */
///@{
inline double
ComputeVolume(const CheckedMesh & mesh)
{
  double volume = 0.0;
  for (const auto & t : mesh.tetrahedra)
  {
    volume += ComputeTetrahedronVolume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
  }
  return volume;
}

inline PointType
ComputeCentroid(const CheckedMesh & mesh)
{
  PointType moment{};
  for (const auto & t : mesh.tetrahedra)
  {
    const double volume =
      ComputeTetrahedronVolume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    for (const std::uint32_t vertex : t)
    {
      moment = Add(moment, Scale(mesh.points[vertex], volume / 4.0));
    }
  }
  return Scale(moment, 1.0 / ComputeVolume(mesh));
}

/** The volume that the triangles enclose, by the divergence theorem. */
inline double
ComputeEnclosedVolume(const CheckedMesh & mesh)
{
  double volume = 0.0;
  for (const auto & triangle : mesh.triangles)
  {
    volume += ComputeTetrahedronVolume(
      mesh.points[mesh.triangles[0][0]], mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]);
  }
  return volume;
}
///@}
} // end namespace itk::DelaunayRefinementTest

#endif
