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

#include "itkDelaunayRefinementLocalTopology.h"

#include "itkAnalyticOracles.h"
#include "itkEngineRun.h"

using namespace itk::DelaunayRefinementTest;

namespace
{
using ParametersType = itk::DelaunayRefinementParameters;

const PointType origin{ 0.0, 0.0, 0.0 };

/** \class SliverCase
 * \brief A shape, and the dihedral angle that its mesh has to keep. */
struct SliverCase
{
  const char *                          name;
  std::shared_ptr<const AnalyticOracle> oracle;
  double                                angle;
  double                                cellSize{ std::numeric_limits<double>::infinity() };
  double                                radiusEdgeRatioBound{ 2.0 };
  bool                                  refineOutside{ false };
  bool                                  roundToFloat{ false };
};

std::ostream &
operator<<(std::ostream & out, const SliverCase & value)
{
  return out << value.name << ", " << value.angle << " degrees";
}

class DelaunayRefinementSlivers : public ::testing::TestWithParam<SliverCase>
{};

std::vector<SliverCase>
MakeSliverCases()
{
  const auto   ball = std::make_shared<BallOracle>(origin, 10.0);
  const auto   torus = std::make_shared<TorusOracle>(origin, 10.0, 4.0);
  const double unbounded = std::numeric_limits<double>::infinity();
  return { { "ball", ball, 20.0 },
           { "torus", torus, 15.0 },
           { "hollow ball", std::make_shared<HollowBallOracle>(origin, 5.0, 10.0), 12.0 },
           { "two balls", std::make_shared<TwoBallsOracle>(origin, 9.0, 7.0, 1.0), 12.0 },
           { "plate", std::make_shared<PlateOracle>(origin, PointType{ 10.0, 8.0, 3.0 }), 10.0 },
           { "ball with small cells", ball, 10.0, 1.5 },
           { "ball with a low ratio", ball, 10.0, unbounded, 1.4 },
           { "torus with R2 outside", torus, 10.0, unbounded, 2.0, true },
           { "torus in floats", torus, 12.0, unbounded, 2.0, false, true } };
}
} // namespace

TEST_P(DelaunayRefinementSlivers, AreRemovedWithAllGuaranteesKept)
{
  const SliverCase & test = GetParam();
  auto               parameters = MakeParameters(2.0);
  parameters.cellSize = test.cellSize;
  parameters.radiusEdgeRatioBound = test.radiusEdgeRatioBound;
  parameters.refineOutside = test.refineOutside;
  parameters.roundToFloat = test.roundToFloat;
  const EngineRun plain = RunEngine(*test.oracle, parameters);
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(plain));
  const CheckedMesh plainMesh = MakeCheckedMesh(plain.result);
  EXPECT_LT(ComputeDihedralAngles(plainMesh).minimum, test.angle);
  EXPECT_TRUE(plain.statistics.slivers.empty());

  parameters.minimumDihedralAngle = test.angle;
  const EngineRun run = RunEngine(*test.oracle, parameters);
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  const CheckedMesh mesh = MakeCheckedMesh(run.result);
  EXPECT_GE(ComputeDihedralAngles(mesh).minimum, test.angle);
  EXPECT_TRUE(run.statistics.slivers.empty());
  EXPECT_GT(run.GetInsertions(RefinementRule::SLIVER) + run.statistics.movedVertices, 0u);

  ExpectGuarantees(mesh, parameters.radiusEdgeRatioBound);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(mesh,
                 { CountVolumeComponents(plainMesh),
                   CountBoundaryComponents(plainMesh),
                   ComputeBoundaryEulerCharacteristic(plainMesh) });
  EXPECT_LE(ComputeCoverage(*test.oracle, run.result, 0.1), parameters.delta);
  EXPECT_LE(ComputeMaximumCircumradius(mesh), parameters.cellSize * (1.0 + 1e-9));
  for (const PointType & point : GetFeaturePoints(run.result))
  {
    EXPECT_NEAR(test.oracle->ComputeSignedDistance(point), 0.0, 1e-5);
  }
  if (parameters.radiusEdgeRatioBound >= 2.0 && !std::isfinite(parameters.cellSize))
  {
    // Lemma 5: boundary vertices are on the surface.
    for (const auto & triangle : run.result.boundaryTriangles)
    {
      for (const std::uint32_t point : triangle)
      {
        EXPECT_EQ(run.result.pointKinds[point], VertexKind::FEATURE);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, DelaunayRefinementSlivers, ::testing::ValuesIn(MakeSliverCases()));

TEST(DelaunayRefinementSliverRemoval, ChangesOfFewTetrahedraAreEnough)
{
  // A tenth more tetrahedra at 10 degrees.
  const BallOracle ball(origin, 10.0);
  auto             parameters = MakeParameters(0.7);
  const EngineRun  plain = RunEngine(ball, parameters);
  parameters.minimumDihedralAngle = 10.0;
  const EngineRun run = RunEngine(ball, parameters);
  EXPECT_LT(static_cast<double>(run.result.tetrahedra.size()),
            1.15 * static_cast<double>(plain.result.tetrahedra.size()));
}

TEST(DelaunayRefinementSliverRemoval, TellsWhatIsLeft)
{
  auto parameters = MakeParameters(3.0);
  parameters.minimumDihedralAngle = 50.0;
  const EngineRun run = RunEngine(BallOracle(origin, 6.0), parameters);
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  const CheckedMesh mesh = MakeCheckedMesh(run.result);
  ExpectGuarantees(mesh);
  ExpectManifoldBoundary(mesh);
  const auto & slivers = run.statistics.slivers;
  ASSERT_FALSE(slivers.empty());
  EXPECT_NEAR(slivers.front().dihedralAngle, ComputeDihedralAngles(mesh).minimum, 1e-6);
  EXPECT_TRUE(std::is_sorted(
    slivers.begin(), slivers.end(), [](const auto & a, const auto & b) { return a.dihedralAngle < b.dihedralAngle; }));
  for (const auto & sliver : slivers)
  {
    EXPECT_LT(Norm(sliver.place), 6.0);
  }
}

TEST(DelaunayRefinementSliverRemoval, HeedsTheVertexLimit)
{
  const BallOracle ball(origin, 10.0);
  auto             parameters = MakeParameters(2.0);
  const EngineRun  plain = RunEngine(ball, parameters);
  const auto &     vertices = plain.statistics.vertices;
  parameters.maximumNumberOfVertices = vertices[0] + vertices[1] + vertices[2] + vertices[3];
  parameters.minimumDihedralAngle = 15.0;
  const EngineRun run = RunEngine(ball, parameters);
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  EXPECT_EQ(run.GetInsertions(RefinementRule::SLIVER), 0u);
  EXPECT_GT(run.statistics.movedVertices, 0u);
  ExpectGuarantees(MakeCheckedMesh(run.result));
}

TEST(DelaunayRefinementSliverRemoval, StopsWhenTheCallerSaysSo)
{
  const BallOracle ball(origin, 10.0);
  const auto       countCalls = [&ball](double angle, unsigned int lastCall, TerminationReason & reason) {
    unsigned int numberOfCalls = 0;
    auto         parameters = MakeParameters(0.7);
    parameters.minimumDihedralAngle = angle;
    parameters.progress = [&numberOfCalls, lastCall](double) { return ++numberOfCalls < lastCall; };
    reason = RunEngine(ball, parameters).reason;
    return numberOfCalls;
  };
  constexpr unsigned int never = 1000000;
  TerminationReason      reason;
  const unsigned int     plain = countCalls(0.0, never, reason);
  const unsigned int     whole = countCalls(15.0, never, reason);
  EXPECT_EQ(reason, TerminationReason::COMPLETED);
  ASSERT_GT(whole, plain + 4);
  EXPECT_EQ(countCalls(15.0, plain + 2, reason), plain + 2);
  EXPECT_EQ(reason, TerminationReason::STOPPED_BY_CALLER);
}

namespace
{
using LocalTopology = itk::DelaunayRefinementLocalTopology;
using FacetsType = LocalTopology::FacetsType;

/** Facets between region 1 and outside. */
FacetsType
MakeFacets(const std::vector<std::array<LocalTopology::IndexType, 3>> & triangles)
{
  FacetsType facets;
  for (const auto & triangle : triangles)
  {
    facets.Add(triangle, 1, 0);
    // From the other side.
    facets.Add({ triangle[2], triangle[0], triangle[1] }, 0, 1);
  }
  facets.Add({ 90, 91, 92 }, 1, 1);
  return facets;
}

bool
AreEqual(FacetsType before, FacetsType after, LocalTopology::IndexType vertex = 99, bool mayComeOrGo = false)
{
  return LocalTopology().AreEqual(before, after, vertex, mayComeOrGo);
}
} // namespace

TEST(DelaunayRefinementLocalTopology, EdgesMayFlip)
{
  FacetsType    before = MakeFacets({ { 1, 2, 3 }, { 1, 3, 4 } });
  FacetsType    after = MakeFacets({ { 1, 2, 4 }, { 2, 3, 4 } });
  LocalTopology topology;
  EXPECT_TRUE(topology.AreEqual(before, after, 99, false));
  // The new edge is to be looked at.
  EXPECT_EQ(topology.GetVerticesToAsk(), std::vector<LocalTopology::IndexType>{ 2 });
}

TEST(DelaunayRefinementLocalTopology, VerticesComeAndGoOnlyIfTheyMay)
{
  const FacetsType whole = MakeFacets({ { 1, 2, 3 } });
  const FacetsType split = MakeFacets({ { 1, 2, 5 }, { 2, 3, 5 }, { 3, 1, 5 } });
  EXPECT_FALSE(AreEqual(whole, split));
  EXPECT_TRUE(AreEqual(whole, split, 5, true));
  EXPECT_TRUE(AreEqual(split, whole, 5, true));
  EXPECT_FALSE(AreEqual(whole, split, 1, true));
}

TEST(DelaunayRefinementLocalTopology, RimsStay)
{
  EXPECT_FALSE(AreEqual(MakeFacets({ { 1, 2, 3 } }), MakeFacets({ { 1, 2, 4 } })));
  EXPECT_FALSE(AreEqual(MakeFacets({ { 1, 2, 3 } }), MakeFacets({})));
}

TEST(DelaunayRefinementLocalTopology, DisksAreNoTube)
{
  // Two triangles, or the sides of the prism between them: the same rims.
  const FacetsType disks = MakeFacets({ { 1, 2, 3 }, { 4, 5, 6 } });
  const FacetsType tube = MakeFacets({ { 1, 2, 4 }, { 2, 5, 4 }, { 2, 3, 5 }, { 3, 6, 5 }, { 3, 1, 6 }, { 1, 4, 6 } });
  EXPECT_TRUE(AreEqual(disks, disks));
  EXPECT_TRUE(AreEqual(tube, tube));
  EXPECT_FALSE(AreEqual(disks, tube));
  EXPECT_FALSE(AreEqual(tube, disks));
}

TEST(DelaunayRefinementLocalTopology, HandlesNeitherComeNorGo)
{
  // The torus with seven vertices, less a triangle, and a disk with the same rim through the same vertices.
  std::vector<std::array<LocalTopology::IndexType, 3>> torus;
  for (LocalTopology::IndexType i = 0; i < 7; ++i)
  {
    if (i > 0)
    {
      torus.push_back({ i, (i + 1) % 7, (i + 3) % 7 });
    }
    torus.push_back({ i, (i + 2) % 7, (i + 3) % 7 });
  }
  const std::vector<std::array<LocalTopology::IndexType, 3>> disk{ { 1, 3, 2 }, { 3, 0, 2 }, { 1, 2, 4 },
                                                                   { 2, 0, 4 }, { 1, 4, 5 }, { 4, 0, 5 },
                                                                   { 0, 1, 6 }, { 1, 5, 6 }, { 5, 0, 6 } };
  EXPECT_TRUE(AreEqual(MakeFacets(torus), MakeFacets(torus)));
  EXPECT_TRUE(AreEqual(MakeFacets(disk), MakeFacets(disk)));
  EXPECT_FALSE(AreEqual(MakeFacets(torus), MakeFacets(disk)));
  EXPECT_FALSE(AreEqual(MakeFacets(disk), MakeFacets(torus)));
}

TEST(DelaunayRefinementLocalTopology, OutsideCountsToo)
{
  // A tetrahedron on both sides of an interface that is left to outside: each region keeps its topology, outside does
  // not.
  FacetsType before;
  before.Add({ 1, 2, 3 }, 1, 2);
  before.Add({ 1, 2, 4 }, 1, 2);
  FacetsType after;
  after.Add({ 1, 2, 3 }, 0, 2);
  after.Add({ 1, 2, 4 }, 0, 2);
  after.Add({ 3, 4, 1 }, 1, 0);
  after.Add({ 3, 4, 2 }, 1, 0);
  EXPECT_FALSE(AreEqual(before, after));
}

TEST(DelaunayRefinementLocalTopology, SpheresNeitherComeNorGo)
{
  const FacetsType island = MakeFacets({ { 1, 2, 3 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 1, 4 } });
  EXPECT_FALSE(AreEqual(island, MakeFacets({})));
  EXPECT_FALSE(AreEqual(MakeFacets({}), island));
  EXPECT_TRUE(AreEqual(island, island));
}

TEST(DelaunayRefinementLocalTopology, SheetsDoNotChangePartnersAtAVertex)
{
  // Four edges of a rim meet in vertex 0; the sheets between them may join them in two ways.
  EXPECT_FALSE(AreEqual(MakeFacets({ { 0, 1, 2 }, { 0, 3, 4 }, { 5, 2, 3 }, { 5, 3, 2 }, { 5, 1, 4 } }),
                        MakeFacets({ { 0, 2, 3 }, { 0, 4, 1 }, { 5, 1, 2 }, { 5, 3, 4 } })));
  const FacetsType one = MakeFacets({ { 0, 1, 2 }, { 0, 3, 4 } });
  const FacetsType other = MakeFacets({ { 0, 1, 2 }, { 0, 3, 5 }, { 3, 4, 5 }, { 0, 5, 4 } });
  EXPECT_TRUE(AreEqual(one, other, 5, true));
  // Vertex 5 touches the second sheet.
  const FacetsType touching = MakeFacets({ { 0, 1, 2 }, { 0, 3, 4 }, { 0, 4, 2 } });
  EXPECT_FALSE(AreEqual(one, touching));
}

TEST(DelaunayRefinementLocalTopology, ThreeFacetsAtAnEdgeAreRefused)
{
  const FacetsType book = MakeFacets({ { 1, 2, 3 }, { 1, 2, 4 }, { 1, 2, 5 } });
  EXPECT_FALSE(AreEqual(book, book));
}

TEST(DelaunayRefinementLocalTopology, EachRegionCounts)
{
  // Region 2 takes the place of region 1 behind one of two facets.
  FacetsType before = MakeFacets({ { 1, 2, 3 }, { 1, 3, 4 } });
  FacetsType after;
  after.Add({ 1, 2, 3 }, 1, 0);
  after.Add({ 1, 3, 4 }, 2, 0);
  EXPECT_FALSE(AreEqual(before, after));
}
