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
// The triangulation against CGAL's, which knows nothing of it: the same cells, degenerate points included.

#include "itkDelaunayRefinementThreads.h"
#include "itkDelaunayRefinementTriangulation.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <random>
#include <set>
#include <string>

namespace
{
using TriangulationType = itk::DelaunayRefinementTriangulation;
using IndexType = TriangulationType::IndexType;
using PointType = itk::DelaunayRefinementPoint;
using CellsType = std::set<std::array<IndexType, 4>>;
using KernelType = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBaseType = CGAL::Triangulation_vertex_base_with_info_3<IndexType, KernelType>;
using WitnessType = CGAL::Delaunay_triangulation_3<KernelType, CGAL::Triangulation_data_structure_3<VertexBaseType>>;

const auto keepGoing = [] { return true; };

/** The finite cells, each by its sorted vertices. */
CellsType
GetCells(const TriangulationType & triangulation)
{
  CellsType cells;
  for (IndexType cell = 0; cell < triangulation.GetNumberOfCellIndexes(); ++cell)
  {
    if (triangulation.IsAlive(cell) && !triangulation.IsInfinite(cell))
    {
      auto vertices = triangulation.GetCell(cell).vertices;
      std::sort(vertices.begin(), vertices.end());
      EXPECT_TRUE(cells.insert(vertices).second) << "the same cell twice";
    }
  }
  return cells;
}

/** What CGAL makes of the vertices that are left. */
CellsType
ComputeWitness(const TriangulationType & triangulation)
{
  std::vector<std::pair<KernelType::Point_3, IndexType>> points;
  for (IndexType vertex = 1; vertex < triangulation.GetNumberOfVertexIndexes(); ++vertex)
  {
    if (triangulation.GetCellOfVertex(vertex) != TriangulationType::None)
    {
      const PointType & p = triangulation.GetPoint(vertex);
      points.emplace_back(KernelType::Point_3(p[0], p[1], p[2]), vertex);
    }
  }
  const WitnessType witness(points.begin(), points.end());
  CellsType         cells;
  for (auto cell = witness.finite_cells_begin(); cell != witness.finite_cells_end(); ++cell)
  {
    std::array<IndexType, 4> vertices;
    for (int i = 0; i < 4; ++i)
    {
      vertices[i] = cell->vertex(i)->info();
    }
    std::sort(vertices.begin(), vertices.end());
    cells.insert(vertices);
  }
  return cells;
}

void
ExpectSameAsWitness(const TriangulationType & triangulation)
{
  EXPECT_TRUE(triangulation.IsValid());
  EXPECT_EQ(GetCells(triangulation), ComputeWitness(triangulation));
}

PointType
MakeRandomPoint(std::mt19937 & random)
{
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const double                           x = coordinate(random);
  const double                           y = coordinate(random);
  return { x, y, coordinate(random) };
}

std::vector<PointType>
MakeRandomPoints(std::size_t number)
{
  std::mt19937           random(1);
  std::vector<PointType> points;
  for (std::size_t i = 0; i < number; ++i)
  {
    points.push_back(MakeRandomPoint(random));
  }
  return points;
}

/** Points of which very many lie on common spheres, planes and lines. */
std::vector<PointType>
MakeLattice(int size)
{
  std::vector<PointType> points;
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        points.push_back({ x * 1.0, y * 1.0, z * 1.0 });
      }
    }
  }
  return points;
}

/** Nearly on one sphere, so that one more point in the middle has a very large star. */
std::vector<PointType>
MakeSphere(std::size_t number, double origin)
{
  std::mt19937           random(2);
  std::vector<PointType> points;
  while (points.size() < number)
  {
    const PointType p = MakeRandomPoint(random);
    const double    length = std::sqrt(itk::DelaunayRefinementGeometry::Dot(p, p));
    if (length > 0.1 && length < 1.0)
    {
      points.push_back({ origin + p[0] / length, origin + p[1] / length, origin + p[2] / length });
    }
  }
  return points;
}

/** A rotated plane with noise of the size of rounding, and one point beside it: all cells are nearly flat. */
std::vector<PointType>
MakeNearlyFlat(std::size_t number)
{
  std::mt19937           random(3);
  std::vector<PointType> points{ { 0.3, -0.2, 5.0 } };
  while (points.size() < number)
  {
    const PointType p = MakeRandomPoint(random);
    points.push_back({ p[0], p[1], 0.1 * p[0] + 0.7 * p[1] });
  }
  return points;
}

/** Points with a name for the tests' output. */
struct PointSet
{
  std::string            name;
  std::vector<PointType> points;
};

std::ostream &
operator<<(std::ostream & out, const PointSet & set)
{
  return out << set.name;
}

class DelaunayRefinementTriangulation : public testing::TestWithParam<PointSet>
{};
/** With the corners of a box around, which keeps the others off the convex hull, and three points on its faces, where
 * the engine removes vertices too. */
std::vector<PointType>
MakePointsInBox(const std::vector<PointType> & inside)
{
  PointType minimum = inside.front();
  PointType maximum = minimum;
  for (const PointType & point : inside)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      minimum[i] = std::min(minimum[i], point[i] - 4.0);
      maximum[i] = std::max(maximum[i], point[i] + 4.0);
    }
  }
  std::vector<PointType> points;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    points.push_back({ (corner & 1u ? maximum : minimum)[0],
                       (corner & 2u ? maximum : minimum)[1],
                       (corner & 4u ? maximum : minimum)[2] });
  }
  points.push_back({ maximum[0], minimum[1] + 2.0, minimum[2] + 3.0 });
  points.push_back({ maximum[0], minimum[1] + 3.0, maximum[2] - 2.0 });
  points.push_back({ minimum[0] + 1.0, minimum[1], maximum[2] - 1.0 });
  points.insert(points.end(), inside.begin(), inside.end());
  return points;
}
} // namespace

TEST_P(DelaunayRefinementTriangulation, InsertManyMakesTheCellsOfTheWitness)
{
  TriangulationType triangulation;
  ASSERT_TRUE(triangulation.InsertMany(GetParam().points, keepGoing));
  ExpectSameAsWitness(triangulation);
  EXPECT_EQ(GetCells(triangulation).size(),
            static_cast<std::size_t>(std::count_if(triangulation.GetNewCells().begin(),
                                                   triangulation.GetNewCells().end(),
                                                   [&](IndexType cell) { return !triangulation.IsInfinite(cell); })));
}

TEST_P(DelaunayRefinementTriangulation, InsertOneByOneMakesTheCellsOfTheWitness)
{
  const std::vector<PointType> & points = GetParam().points;
  const auto                     half = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  TriangulationType              triangulation;
  ASSERT_TRUE(triangulation.InsertMany({ points.begin(), half }, keepGoing));
  for (auto point = half; point != points.end(); ++point)
  {
    // From anywhere: the hint is no more than that.
    const IndexType hint = triangulation.GetCellOfVertex(triangulation.GetNumberOfVertexIndexes() / 2);
    const IndexType vertex = triangulation.Insert(*point, hint);
    EXPECT_EQ(vertex, triangulation.GetNumberOfVertexIndexes() - 1);
    for (const IndexType cell : triangulation.GetNewCells())
    {
      const auto & vertices = triangulation.GetCell(cell).vertices;
      EXPECT_NE(std::find(vertices.begin(), vertices.end(), vertex), vertices.end());
    }
  }
  ExpectSameAsWitness(triangulation);
  for (const PointType & point : points)
  {
    EXPECT_EQ(triangulation.Insert(point, triangulation.GetNewCells().front()), TriangulationType::None);
  }
}

TEST_P(DelaunayRefinementTriangulation, InsertInBatchesMakesTheCellsOfTheWitness)
{
  std::vector<PointType> points = GetParam().points;
  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  const auto                     half = static_cast<std::ptrdiff_t>(points.size() / 2);
  std::vector<PointType>         left(points.begin() + half, points.end());
  constexpr unsigned int         numberOfThreads = 3;
  itk::DelaunayRefinementThreads threads(numberOfThreads);
  TriangulationType              triangulation;
  ASSERT_TRUE(triangulation.InsertMany({ points.begin(), points.begin() + half }, keepGoing));
  triangulation.SetNumberOfThreads(numberOfThreads);
  std::size_t numberOfReservations = 0;
  std::size_t numberOfBatches = 0;
  while (!left.empty())
  {
    // All that are left at once, so that most of them meet others.
    std::vector<TriangulationType::StarType> stars(left.size());
    threads.Run(left.size(), [&](std::size_t i, unsigned int thread) {
      EXPECT_TRUE(triangulation.FindStar(left[i], triangulation.GetCellOfVertex(1), stars[i], thread));
    });
    triangulation.StartBatch();
    std::vector<std::size_t> reserved;
    std::vector<PointType>   later;
    for (std::size_t i = 0; i < left.size(); ++i)
    {
      if (triangulation.Reserve(stars[i]))
      {
        reserved.push_back(i);
      }
      else
      {
        later.push_back(left[i]);
      }
    }
    ASSERT_FALSE(reserved.empty());
    threads.Run(reserved.size(),
                [&](std::size_t i, unsigned int thread) { triangulation.Fill(stars[reserved[i]], thread); });
    for (const std::size_t i : reserved)
    {
      triangulation.Finish(stars[i]);
    }
    numberOfReservations += reserved.size();
    ++numberOfBatches;
    left.swap(later);
  }
  EXPECT_EQ(numberOfReservations, points.size() - static_cast<std::size_t>(half));
  EXPECT_LT(2 * numberOfBatches, numberOfReservations);
  EXPECT_TRUE(triangulation.IsValid());
  ExpectSameAsWitness(triangulation);
}

TEST_P(DelaunayRefinementTriangulation, RemoveLeavesTheCellsOfTheWitness)
{
  TriangulationType triangulation;
  ASSERT_TRUE(triangulation.InsertMany(MakePointsInBox(GetParam().points), keepGoing));
  std::mt19937 random(4);
  for (IndexType vertex = 9; vertex < triangulation.GetNumberOfVertexIndexes(); ++vertex)
  {
    if (vertex < 12 || random() % 2 == 0)
    {
      triangulation.Remove(vertex);
      EXPECT_EQ(triangulation.GetCellOfVertex(vertex), TriangulationType::None);
    }
    if (vertex % 100 == 0 || vertex < 12)
    {
      ExpectSameAsWitness(triangulation);
    }
  }
  ExpectSameAsWitness(triangulation);
}

TEST_P(DelaunayRefinementTriangulation, ReinsertMakesTheCellsOfTheWitness)
{
  // Vertices move to places of others that are out, so that points on common spheres and planes stay so.
  TriangulationType triangulation;
  ASSERT_TRUE(triangulation.InsertMany(MakePointsInBox(GetParam().points), keepGoing));
  const IndexType size = triangulation.GetNumberOfVertexIndexes();
  std::mt19937    random(5);
  for (unsigned int i = 0; i < 60; ++i)
  {
    const IndexType one = 9 + random() % (size - 9);
    const IndexType other = 9 + random() % (size - 9);
    if (one == other)
    {
      continue;
    }
    const PointType pointOfOne = triangulation.GetPoint(one);
    const PointType pointOfOther = triangulation.GetPoint(other);
    triangulation.Remove(one);
    triangulation.Remove(other);
    EXPECT_TRUE(triangulation.Reinsert(one, pointOfOther, triangulation.GetNewCells().front()));
    EXPECT_FALSE(triangulation.Reinsert(other, pointOfOther, triangulation.GetNewCells().front()));
    EXPECT_TRUE(triangulation.Reinsert(other, pointOfOne, triangulation.GetCellOfVertex(one)));
    EXPECT_EQ(triangulation.GetPoint(one), pointOfOther);
    EXPECT_NE(triangulation.GetCellOfVertex(other), TriangulationType::None);
  }
  EXPECT_EQ(triangulation.GetNumberOfVertexIndexes(), size);
  ExpectSameAsWitness(triangulation);
}

TEST_P(DelaunayRefinementTriangulation, BallsGoThroughTheirVertices)
{
  TriangulationType triangulation;
  ASSERT_TRUE(triangulation.InsertMany(GetParam().points, keepGoing));
  for (const IndexType cell : triangulation.GetNewCells())
  {
    const auto ball = triangulation.GetBall(cell);
    if (triangulation.IsInfinite(cell))
    {
      EXPECT_EQ(ball.squaredRadius, 0.0);
      continue;
    }
    for (const IndexType vertex : triangulation.GetCell(cell).vertices)
    {
      const double squared =
        itk::DelaunayRefinementGeometry::SquaredDistance(ball.center, triangulation.GetPoint(vertex));
      EXPECT_NEAR(squared / ball.squaredRadius, 1.0, 1e-7);
    }
  }
}

TEST_P(DelaunayRefinementTriangulation, TheSameCallsGiveTheSameIndexes)
{
  TriangulationType one;
  TriangulationType other;
  ASSERT_TRUE(one.InsertMany(GetParam().points, keepGoing));
  ASSERT_TRUE(other.InsertMany(GetParam().points, keepGoing));
  ASSERT_EQ(one.GetNewCells(), other.GetNewCells());
  for (const IndexType cell : one.GetNewCells())
  {
    EXPECT_EQ(one.GetCell(cell).vertices, other.GetCell(cell).vertices);
  }
}

INSTANTIATE_TEST_SUITE_P(Points,
                         DelaunayRefinementTriangulation,
                         testing::Values(PointSet{ "Random", MakeRandomPoints(2000) },
                                         PointSet{ "Lattice", MakeLattice(8) },
                                         PointSet{ "Sphere", MakeSphere(1000, 0.0) },
                                         PointSet{ "SphereFarAway", MakeSphere(1000, 1e8) },
                                         PointSet{ "NearlyFlat", MakeNearlyFlat(600) }),
                         [](const auto & test) { return test.param.name; });

namespace
{
/** Within the corners of a box, as in a mesh. */
std::vector<PointType>
PutIntoBox(std::vector<PointType> points, double size)
{
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    const PointType point{ corner & 1u ? size : -size, corner & 2u ? size : -size, corner & 4u ? size : -size };
    points.insert(points.begin(), point);
  }
  return points;
}

/** So many points that they are inserted by parts. */
class DelaunayRefinementTriangulationByParts : public testing::TestWithParam<PointSet>
{};
} // namespace

TEST_P(DelaunayRefinementTriangulationByParts, MakesTheCellsOfTheWitness)
{
  TriangulationType              triangulation;
  itk::DelaunayRefinementThreads threads(3);
  ASSERT_TRUE(triangulation.InsertMany(GetParam().points, keepGoing, &threads));
  ExpectSameAsWitness(triangulation);
  for (IndexType vertex = 0; vertex < triangulation.GetNumberOfVertexIndexes(); ++vertex)
  {
    const IndexType cell = triangulation.GetCellOfVertex(vertex);
    ASSERT_TRUE(triangulation.IsAlive(cell));
    const auto & vertices = triangulation.GetCell(cell).vertices;
    EXPECT_NE(std::find(vertices.begin(), vertices.end(), vertex), vertices.end());
  }
}

TEST_P(DelaunayRefinementTriangulationByParts, GivesTheSameIndexesOnAnyNumberOfThreads)
{
  TriangulationType expected;
  ASSERT_TRUE(expected.InsertMany(GetParam().points, keepGoing));
  for (const unsigned int numberOfThreads : { 1, 2, 5 })
  {
    TriangulationType              triangulation;
    itk::DelaunayRefinementThreads threads(numberOfThreads);
    ASSERT_TRUE(triangulation.InsertMany(GetParam().points, keepGoing, &threads));
    ASSERT_EQ(triangulation.GetNewCells(), expected.GetNewCells());
    for (const IndexType cell : expected.GetNewCells())
    {
      ASSERT_EQ(triangulation.GetCell(cell).vertices, expected.GetCell(cell).vertices);
      ASSERT_EQ(triangulation.GetCell(cell).neighbors, expected.GetCell(cell).neighbors);
    }
    for (IndexType vertex = 0; vertex < expected.GetNumberOfVertexIndexes(); ++vertex)
    {
      ASSERT_EQ(triangulation.GetCellOfVertex(vertex), expected.GetCellOfVertex(vertex));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Points,
                         DelaunayRefinementTriangulationByParts,
                         testing::Values(PointSet{ "Random", MakeRandomPoints(20000) },
                                         PointSet{ "RandomInBox", PutIntoBox(MakeRandomPoints(20000), 1.5) },
                                         PointSet{ "Lattice", MakeLattice(27) },
                                         PointSet{ "SphereInBox", PutIntoBox(MakeSphere(20000, 0.0), 2.0) },
                                         PointSet{ "ManyInBox", PutIntoBox(MakeRandomPoints(210000), 1.5) }),
                         [](const auto & test) { return test.param.name; });

TEST(DelaunayRefinementTriangulationStops, WhenItIsTold)
{
  TriangulationType triangulation;
  EXPECT_FALSE(triangulation.InsertMany(MakeRandomPoints(10000), [] { return false; }));
}

TEST(DelaunayRefinementTriangulationStops, AmongParts)
{
  itk::DelaunayRefinementThreads threads(2);
  for (const int most : { 2, 4 })
  {
    int               number = 0;
    TriangulationType triangulation;
    EXPECT_FALSE(triangulation.InsertMany(MakeRandomPoints(50000), [&] { return ++number < most; }, &threads));
  }
}
