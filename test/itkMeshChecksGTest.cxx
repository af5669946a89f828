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

#include "itkMeshExpectations.h"

#include <gtest/gtest-spi.h>

#include <random>

using namespace itk::DelaunayRefinementTest;

namespace
{
using CubeType = std::array<int, 3>;

/** Unit cubes, each cut into six tetrahedra around the diagonal from its lowest to its highest corner. */
CheckedMesh
MakeCubes(const std::vector<CubeType> & cubes)
{
  CheckedMesh                       mesh;
  std::map<CubeType, std::uint32_t> indices;
  const auto                        indexOf = [&](const CubeType & corner) {
    const auto inserted = indices.insert({ corner, static_cast<std::uint32_t>(mesh.points.size()) });
    if (inserted.second)
    {
      mesh.points.push_back(
        { static_cast<double>(corner[0]), static_cast<double>(corner[1]), static_cast<double>(corner[2]) });
    }
    return inserted.first->second;
  };
  for (const CubeType & cube : cubes)
  {
    CubeType axes{ 0, 1, 2 };
    do
    {
      // A path of three edges along the axes in this order.
      std::array<std::uint32_t, 4> tetrahedron;
      CubeType                     corner = cube;
      tetrahedron[0] = indexOf(corner);
      for (unsigned int i = 0; i < 3; ++i)
      {
        ++corner[axes[i]];
        tetrahedron[i + 1] = indexOf(corner);
      }
      const bool isEven = (axes[1] - axes[0] + 3) % 3 == 1;
      if (!isEven)
      {
        std::swap(tetrahedron[2], tetrahedron[3]);
      }
      mesh.tetrahedra.push_back(tetrahedron);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  mesh.triangles = ComputeBoundaryTriangles(mesh);
  return mesh;
}

/** All cubes of a block but those left out. */
CheckedMesh
MakeBlock(const CubeType & size, const std::set<CubeType> & leftOut = {})
{
  std::vector<CubeType> cubes;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        if (leftOut.count({ x, y, z }) == 0)
        {
          cubes.push_back({ x, y, z });
        }
      }
    }
  }
  return MakeCubes(cubes);
}

/** Eight unit cubes; its only inner point is the one in the middle. */
CheckedMesh
MakeCube()
{
  return MakeBlock({ 2, 2, 2 });
}

std::uint32_t
FindMiddle(const CheckedMesh & cube)
{
  const auto found = std::find(cube.points.begin(), cube.points.end(), PointType{ 1.0, 1.0, 1.0 });
  return static_cast<std::uint32_t>(found - cube.points.begin());
}

/** Whether the expectation does not hold. */
template <typename TFunction>
bool
IsSeenToFail(TFunction && expectation)
{
  ::testing::TestPartResultArray results;
  {
    ::testing::ScopedFakeTestPartResultReporter reporter(
      ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    expectation();
  }
  return results.size() > 0;
}

bool
IsSeenAsInvalid(const CheckedMesh & mesh)
{
  return IsSeenToFail([&mesh] { ExpectValidMesh(mesh); });
}
} // namespace

TEST(MeshChecks, WholeCubeHasTheFiguresOfItsClosedForm)
{
  const CheckedMesh cube = MakeCube();
  ExpectGuarantees(cube);
  ExpectManifoldBoundary(cube);
  ExpectTopology(cube, { 1, 1, 2 });
  EXPECT_EQ(cube.points.size(), 27u);
  EXPECT_EQ(cube.tetrahedra.size(), 48u);
  EXPECT_EQ(cube.triangles.size(), 48u);
  EXPECT_NEAR(ComputeVolume(cube), 8.0, 1e-12);
  EXPECT_NEAR(ComputeEnclosedVolume(cube), 8.0, 1e-12);
  EXPECT_NEAR(Distance(ComputeCentroid(cube), { 1.0, 1.0, 1.0 }), 0.0, 1e-12);
  EXPECT_NEAR(ComputeMaximumRadiusEdgeRatio(cube), std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(ComputeMaximumCircumradius(cube), std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(ComputeMinimumRelativeVolume(cube), 1.0 / 6.0 / std::pow(3.0, 1.5), 1e-12);
  EXPECT_NEAR(ComputePlanarAngles(cube).minimum, 45.0, 1e-9);
  EXPECT_NEAR(ComputePlanarAngles(cube).maximum, 90.0, 1e-9);
  EXPECT_NEAR(ComputeDihedralAngles(cube).minimum, 45.0, 1e-9);
  EXPECT_NEAR(ComputeDihedralAngles(cube).maximum, 90.0, 1e-9);
}

TEST(MeshChecks, RegularTetrahedronHasTheFiguresOfItsClosedForm)
{
  CheckedMesh mesh;
  mesh.points = { { 1.0, 1.0, 1.0 }, { -1.0, 1.0, -1.0 }, { 1.0, -1.0, -1.0 }, { -1.0, -1.0, 1.0 } };
  mesh.tetrahedra = { { 0, 1, 2, 3 } };
  if (CountInvertedTetrahedra(mesh) == 1)
  {
    mesh.tetrahedra = { { 0, 2, 1, 3 } };
  }
  mesh.triangles = ComputeBoundaryTriangles(mesh);
  ExpectGuarantees(mesh, 0.62);
  EXPECT_NEAR(ComputeMaximumRadiusEdgeRatio(mesh), std::sqrt(6.0) / 4.0, 1e-12);
  EXPECT_NEAR(ComputePlanarAngles(mesh).minimum, 60.0, 1e-9);
  EXPECT_NEAR(ComputeDihedralAngles(mesh).minimum, std::acos(1.0 / 3.0) * 180.0 / Pi, 1e-9);
  EXPECT_NEAR(ComputeDihedralAngles(mesh).maximum, std::acos(1.0 / 3.0) * 180.0 / Pi, 1e-9);
}

TEST(MeshChecks, OrientationIsExact)
{
  // p2 is 2 p1 but for one unit in the last place, p3 is p1 + p2 but for one: the determinant is about 2^-105.
  const double    unit = std::ldexp(1.0, -52);
  const PointType origin{};
  const PointType p1{ 0.123456789, 0.0987654321, 0.111 };
  const auto      toMultiple = [unit](double x) { return std::floor(x / unit) * unit; };
  const PointType q1{ toMultiple(p1[0]), toMultiple(p1[1]), toMultiple(p1[2]) };
  const PointType q2{ 2.0 * q1[0], 2.0 * q1[1] + unit, 2.0 * q1[2] };
  for (const int side : { -1, 0, 1 })
  {
    PointType q3 = Add(q1, q2);
    q3[2] += side * unit;
    EXPECT_EQ(ComputeOrientation(origin, q1, q2, q3), side);
    EXPECT_EQ(ComputeOrientation(origin, q2, q1, q3), -side);
    EXPECT_EQ(ComputeOrientation(q3, q1, q2, origin), -side);
  }
  EXPECT_EQ(ComputeOrientation({ 1e5, 1e5, 1e5 }, { 1e5 + 1, 1e5, 1e5 }, { 1e5, 1e5 + 1, 1e5 }, { 1e5, 1e5, 1e5 + 1 }),
            1);
}

TEST(MeshChecks, FlippedTetrahedronIsSeen)
{
  CheckedMesh mesh = MakeCube();
  std::swap(mesh.tetrahedra[7][0], mesh.tetrahedra[7][1]);
  EXPECT_EQ(CountInvertedTetrahedra(mesh), 1u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
}

TEST(MeshChecks, FlatTetrahedronIsSeen)
{
  CheckedMesh mesh;
  mesh.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 1e-11 } };
  mesh.tetrahedra = { { 0, 1, 2, 3 } };
  mesh.triangles = ComputeBoundaryTriangles(mesh);
  EXPECT_EQ(CountInvertedTetrahedra(mesh), 0u);
  EXPECT_LT(ComputeMinimumRelativeVolume(mesh), MinimumRelativeVolume);
  EXPECT_LT(ComputeDihedralAngles(mesh).minimum, 1e-6);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));

  mesh.points[3][2] = 0.0;
  EXPECT_EQ(CountInvertedTetrahedra(mesh), 1u);
  EXPECT_GT(ComputeMaximumRadiusEdgeRatio(mesh), 1e9);
  EXPECT_TRUE(IsSeenToFail([&mesh] { ExpectQuality(mesh, 2.0); }));
}

TEST(MeshChecks, MovedPointIsSeen)
{
  CheckedMesh         mesh = MakeCube();
  const std::uint32_t middle = FindMiddle(mesh);
  // Still within its star: all volumes are positive, but the mesh is not Delaunay's.
  mesh.points[middle][0] = 1.5;
  EXPECT_EQ(CountInvertedTetrahedra(mesh), 0u);
  EXPECT_EQ(CountFoldedFaces(mesh), 0u);
  EXPECT_GT(CountDelaunayViolations(mesh), 0u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));

  mesh.points[middle][0] = 3.5;
  EXPECT_GT(CountInvertedTetrahedra(mesh), 0u);
  EXPECT_GT(CountFoldedFaces(mesh), 0u);
}

TEST(MeshChecks, OverlapIsSeen)
{
  // Two blocks that share no vertex, one pushed into the other: every tetrahedron is good by itself.
  CheckedMesh       mesh = MakeCube();
  const CheckedMesh other = MakeCube();
  const auto        shift = static_cast<std::uint32_t>(mesh.points.size());
  for (const PointType & point : other.points)
  {
    mesh.points.push_back(Add(point, PointType{ 1.25, 0.25, 0.125 }));
  }
  for (auto tetrahedron : other.tetrahedra)
  {
    for (std::uint32_t & vertex : tetrahedron)
    {
      vertex += shift;
    }
    mesh.tetrahedra.push_back(tetrahedron);
  }
  mesh.triangles = ComputeBoundaryTriangles(mesh);
  EXPECT_EQ(CountInvertedTetrahedra(mesh) + CountFoldedFaces(mesh) + CountBoundaryMismatches(mesh), 0u);
  EXPECT_GT(CountDelaunayViolations(mesh), 0u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
}

TEST(MeshChecks, MissingTetrahedronIsSeen)
{
  CheckedMesh mesh = MakeBlock({ 3, 3, 3 });
  // One around the middle cube, with no face on the boundary.
  const auto inner = std::find_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&mesh](const auto & tetrahedron) {
    return std::all_of(tetrahedron.begin(), tetrahedron.end(), [&mesh](std::uint32_t vertex) {
      const PointType & point = mesh.points[vertex];
      return std::all_of(point.begin(), point.end(), [](double x) { return x > 0.0 && x < 3.0; });
    });
  });
  ASSERT_NE(inner, mesh.tetrahedra.end());
  mesh.tetrahedra.erase(inner);
  EXPECT_EQ(CountBoundaryMismatches(mesh), 4u);
  EXPECT_GT(std::abs(ComputeVolume(mesh) - ComputeEnclosedVolume(mesh)), 0.1);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
}

TEST(MeshChecks, DuplicatePointIsSeen)
{
  CheckedMesh mesh = MakeCube();
  mesh.points.push_back(mesh.points[FindMiddle(mesh)]);
  EXPECT_EQ(CountDuplicatePoints(mesh), 1u);
  EXPECT_EQ(CountOrphanPoints(mesh), 1u);
  mesh.tetrahedra[0][0] = static_cast<std::uint32_t>(mesh.points.size() - 1);
  EXPECT_EQ(CountOrphanPoints(mesh), 0u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
}

TEST(MeshChecks, OrphanPointIsSeen)
{
  CheckedMesh mesh = MakeCube();
  mesh.points.push_back({ 5.0, 5.0, 5.0 });
  EXPECT_EQ(CountOrphanPoints(mesh), 1u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
}

TEST(MeshChecks, DuplicateTetrahedronIsSeen)
{
  CheckedMesh  mesh = MakeCube();
  const auto & original = mesh.tetrahedra[5];
  mesh.tetrahedra.push_back({ original[1], original[2], original[0], original[3] });
  EXPECT_EQ(CountInvertedTetrahedra(mesh), 0u);
  EXPECT_EQ(CountDuplicateTetrahedra(mesh), 1u);
  EXPECT_GT(CountOversharedFaces(mesh), 0u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
}

TEST(MeshChecks, WrongTrianglesAreSeen)
{
  const CheckedMesh cube = MakeCube();
  CheckedMesh       mesh = cube;
  std::rotate(mesh.triangles[3].begin(), mesh.triangles[3].begin() + 1, mesh.triangles[3].end());
  EXPECT_EQ(CountBoundaryMismatches(mesh), 0u);

  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_EQ(CountBoundaryMismatches(mesh), 2u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));

  mesh = cube;
  mesh.triangles.pop_back();
  EXPECT_EQ(CountBoundaryMismatches(mesh), 1u);
  EXPECT_EQ(CountNonManifoldEdges(mesh), 3u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
  EXPECT_TRUE(IsSeenToFail([&mesh] { ExpectManifoldBoundary(mesh); }));

  mesh = cube;
  mesh.triangles.push_back(mesh.triangles.front());
  EXPECT_EQ(CountBoundaryMismatches(mesh), 1u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
}

TEST(MeshChecks, BadNumbersAreSeen)
{
  CheckedMesh mesh = MakeCube();
  mesh.points[0][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(CountNonFinitePoints(mesh), 1u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));

  mesh = MakeCube();
  mesh.triangles[0][0] = 27;
  mesh.tetrahedra[0][0] = 27;
  EXPECT_EQ(CountBadIndices(mesh), 2u);
  EXPECT_TRUE(IsSeenAsInvalid(mesh));
  EXPECT_TRUE(IsSeenToFail([&mesh] { ExpectQuality(mesh, 2.0); }));
  EXPECT_TRUE(IsSeenAsInvalid(CheckedMesh{}));
}

TEST(MeshChecks, QualityIsHeldToItsBounds)
{
  const CheckedMesh cube = MakeCube();
  EXPECT_TRUE(IsSeenToFail([&cube] { ExpectQuality(cube, 0.86); }));
  EXPECT_FALSE(IsSeenToFail([&cube] { ExpectQuality(cube, 0.87); }));

  // Stretched, the smallest planar angle is atan(1/2).
  CheckedMesh stretched = cube;
  for (PointType & point : stretched.points)
  {
    point[0] *= 2.0;
  }
  EXPECT_NEAR(ComputePlanarAngles(stretched).minimum, std::atan(0.5) * 180.0 / Pi, 1e-9);
  EXPECT_TRUE(IsSeenToFail([&stretched] { ExpectQuality(stretched, 2.0); }));
}

TEST(MeshChecks, TopologyOfBlocks)
{
  ExpectTopology(MakeBlock({ 3, 3, 1 }, { { 1, 1, 0 } }), { 1, 1, 0 });
  ExpectTopology(MakeBlock({ 3, 3, 3 }, { { 1, 1, 1 } }), { 1, 2, 4 });
  ExpectTopology(MakeCubes({ { 0, 0, 0 }, { 2, 0, 0 } }), { 2, 2, 4 });

  const CheckedMesh cube = MakeCube();
  EXPECT_TRUE(IsSeenToFail([&cube] { ExpectTopology(cube, { 2, 1, 2 }); }));
  EXPECT_TRUE(IsSeenToFail([&cube] { ExpectTopology(cube, { 1, 2, 2 }); }));
  EXPECT_TRUE(IsSeenToFail([&cube] { ExpectTopology(cube, { 1, 1, 0 }); }));
}

TEST(MeshChecks, PinchedBoundaryIsSeen)
{
  const CheckedMesh atEdge = MakeCubes({ { 0, 0, 0 }, { 1, 1, 0 } });
  EXPECT_EQ(CountNonManifoldEdges(atEdge), 1u);
  EXPECT_TRUE(IsSeenToFail([&atEdge] { ExpectManifoldBoundary(atEdge); }));

  const CheckedMesh atVertex = MakeCubes({ { 0, 0, 0 }, { 1, 1, 1 } });
  EXPECT_EQ(CountNonManifoldEdges(atVertex), 0u);
  EXPECT_EQ(CountNonManifoldVertices(atVertex), 1u);
  EXPECT_TRUE(IsSeenToFail([&atVertex] { ExpectManifoldBoundary(atVertex); }));

  const CheckedMesh atFace = MakeCubes({ { 0, 0, 0 }, { 1, 0, 0 } });
  ExpectManifoldBoundary(atFace);
}

TEST(MeshChecks, DistancesAgreeWithBruteForce)
{
  const CheckedMesh mesh = MakeBlock({ 4, 3, 2 }, { { 1, 1, 0 }, { 2, 1, 1 } });
  std::mt19937      generator(3);
  const auto        random = [&generator] { return -4.0 + 12.0 * static_cast<double>(generator()) / 4294967295.0; };

  std::vector<PointType> scattered;
  for (unsigned int i = 0; i < 30; ++i)
  {
    scattered.push_back({ random(), random(), random() });
  }

  const TriangleLocator triangles(mesh);
  const PointLocator    points(scattered);
  for (unsigned int i = 0; i < 1000; ++i)
  {
    const PointType query{ random(), random(), random() };
    double          nearestPoint = std::numeric_limits<double>::infinity();
    for (const PointType & point : scattered)
    {
      nearestPoint = std::min(nearestPoint, Distance(query, point));
    }
    double nearestTriangle = std::numeric_limits<double>::infinity();
    for (const auto & triangle : mesh.triangles)
    {
      nearestTriangle =
        std::min(nearestTriangle,
                 Distance(query,
                          ComputeClosestPointOfTriangle(
                            query, mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]])));
    }
    EXPECT_DOUBLE_EQ(points.FindDistance(query), nearestPoint);
    EXPECT_DOUBLE_EQ(triangles.FindDistance(query), nearestTriangle);
  }
}

TEST(MeshChecks, DistancesOfClosedForm)
{
  const CheckedMesh cube = MakeCube();
  EXPECT_DOUBLE_EQ(ComputeDistanceToBoundary({ { 1.0, 1.0, 2.5 }, { 1.0, 1.0, 1.25 } }, cube), 0.75);
  EXPECT_DOUBLE_EQ(ComputeDistanceToBoundary({ { 5.0, 6.0, 2.0 } }, cube), 5.0);

  // No sample is farther from the center of a cube than its corners, nor nearer than the middles of its faces.
  const auto samples = SampleBoundary(cube, 0.25);
  const auto toMiddle = [](const PointType & point) { return Distance(point, { 1.0, 1.0, 1.0 }); };
  EXPECT_DOUBLE_EQ(ComputeMaximumDistance(samples, toMiddle), std::sqrt(3.0));
  EXPECT_LE(PointLocator(samples).FindDistance({ 0.3, 0.6, 0.0 }), 0.25);
  EXPECT_TRUE(std::isnan(
    ComputeMaximumDistance(samples, [](const PointType &) { return std::numeric_limits<double>::quiet_NaN(); })));
}
