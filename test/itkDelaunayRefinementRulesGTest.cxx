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

#include "itkDelaunayRefinementEngine.h"

#include "itkAnalyticOracles.h"
#include "itkEngineRun.h"

using namespace itk::DelaunayRefinementTest;

namespace
{
const PointType   origin{ 0.0, 0.0, 0.0 };
const TorusOracle torus(origin, 10.0, 4.0);

/** Runs on shapes of several kinds at several deltas: which rules a single run needs is its own affair. With R2 outside
 * too. */
const std::vector<EngineRun> &
GetRuns()
{
  static const std::vector<EngineRun> runs = [] {
    std::vector<EngineRun> made;
    for (const double delta : { 4.0, 2.0, 1.0 })
    {
      auto parameters = MakeParameters(delta);
      parameters.refineOutside = true;
      made.push_back(RunEngine(BallOracle(origin, 10.0), parameters));
      made.push_back(RunEngine(torus, parameters));
      made.push_back(RunEngine(TwoBallsOracle(origin, 6.0, 4.0, 1.0), parameters));
      made.push_back(RunEngine(PlateOracle(origin, { 10.0, 8.0, 3.0 }), parameters));
    }
    return made;
  }();
  return runs;
}

std::size_t
CountInsertions(RefinementRule rule)
{
  std::size_t count = 0;
  for (const EngineRun & run : GetRuns())
  {
    count += run.GetInsertions(rule);
  }
  return count;
}

std::size_t
GetNumberOfVertices(const EngineRun & run, VertexKind kind)
{
  return run.statistics.vertices[static_cast<std::size_t>(kind)];
}
} // namespace

TEST(DelaunayRefinementRules, R1SamplesTheSurface)
{
  // With the surface sampled at delta, a ball has at least its area over that of a disk of radius delta.
  const EngineRun run = RunEngine(BallOracle(origin, 10.0), MakeParameters(2.0));
  EXPECT_GE(run.GetInsertions(RefinementRule::R1), 100u);
  EXPECT_EQ(GetNumberOfVertices(run, VertexKind::FEATURE),
            run.GetInsertions(RefinementRule::R1) + run.GetInsertions(RefinementRule::R3));
}

TEST(DelaunayRefinementRules, R2FillsSpaceAroundTheSurface)
{
  EXPECT_GT(CountInsertions(RefinementRule::R2), 0u);
  const EngineRun run = RunEngine(torus, MakeParameters(2.0));
  EXPECT_GT(GetNumberOfVertices(run, VertexKind::FREE), 0u);
  // All tetrahedra of a torus this thin are intersecting.
  EXPECT_LT(ComputeMaximumCircumradius(MakeCheckedMesh(run.result)), 2.0 * 2.0);
}

TEST(DelaunayRefinementRules, R2BoundsTetrahedraAtTheSurface)
{
  // It lets tetrahedra grow that have no vertex on the surface.
  const double radius = 20.0;
  const double delta = 1.5;
  CheckedMesh  mesh = MakeCheckedMesh(RunEngine(BallOracle(origin, radius), MakeParameters(delta)).result);
  const auto   isOnSurface = [&](auto point) { return std::abs(Norm(mesh.points[point]) - radius) < 1e-6; };
  EXPECT_GT(ComputeMaximumCircumradius(mesh), 2.0 * delta);
  mesh.tetrahedra.erase(std::remove_if(mesh.tetrahedra.begin(),
                                       mesh.tetrahedra.end(),
                                       [&](const auto & t) { return std::none_of(t.begin(), t.end(), isOnSurface); }),
                        mesh.tetrahedra.end());
  EXPECT_FALSE(mesh.tetrahedra.empty());
  EXPECT_LT(ComputeMaximumCircumradius(mesh), 2.0 * delta * (1.0 + 1e-9));
}

TEST(DelaunayRefinementRules, R2OutsideAddsNothingToTheMesh)
{
  // The guarantees with R2 inside alone are measured in the other tests.
  auto            parameters = MakeParameters(2.0);
  const EngineRun inside = RunEngine(torus, parameters);
  parameters.refineOutside = true;
  const EngineRun everywhere = RunEngine(torus, parameters);
  EXPECT_GT(everywhere.GetInsertions(RefinementRule::R2), inside.GetInsertions(RefinementRule::R2));
  EXPECT_LE(ComputeCoverage(torus, everywhere.result, 0.1), parameters.delta);
  EXPECT_LE(ComputeCoverage(torus, inside.result, 0.1), parameters.delta);
  EXPECT_EQ(everywhere.result.boundaryTriangles.size(), inside.result.boundaryTriangles.size());
  ExpectGuarantees(MakeCheckedMesh(everywhere.result));
}

TEST(DelaunayRefinementRules, R3InsertsSurfaceCenters)
{
  // Where R1 has covered the surface, R3 is left with facets that have a vertex off it or edges below delta.
  auto parameters = MakeParameters(4.0);
  parameters.cellSize = 2.0;
  const EngineRun run = RunEngine(torus, parameters);
  EXPECT_GT(run.GetInsertions(RefinementRule::R3), 0u);
  EXPECT_EQ(GetNumberOfVertices(run, VertexKind::FEATURE),
            run.GetInsertions(RefinementRule::R1) + run.GetInsertions(RefinementRule::R3));
  for (const PointType & point : GetFeaturePoints(run.result))
  {
    EXPECT_NEAR(torus.ComputeSignedDistance(point), 0.0, 1e-6);
  }
}

TEST(DelaunayRefinementRules, R4SplitsSkinnyTetrahedra)
{
  auto parameters = MakeParameters(2.0);
  parameters.radiusEdgeRatioBound = 1.0;
  const EngineRun run = RunEngine(torus, parameters);
  EXPECT_GT(run.GetInsertions(RefinementRule::R4), 0u);

  parameters.radiusEdgeRatioBound = 100.0;
  const EngineRun loose = RunEngine(torus, parameters);
  EXPECT_EQ(loose.GetInsertions(RefinementRule::R4), 0u);
  EXPECT_GT(ComputeMaximumRadiusEdgeRatio(MakeCheckedMesh(loose.result)), 1.0);
}

TEST(DelaunayRefinementRules, R4PrimeRemovesSlivers)
{
  auto            parameters = MakeParameters(2.0);
  const EngineRun off = RunEngine(torus, parameters);
  EXPECT_EQ(off.GetInsertions(RefinementRule::R4_PRIME), 0u);

  parameters.minimumDihedralAngle = 10.0;
  parameters.paperSlivers = true;
  const EngineRun run = RunEngine(torus, parameters);
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  EXPECT_GT(run.GetInsertions(RefinementRule::R4_PRIME), 0u);
  EXPECT_EQ(run.GetInsertions(RefinementRule::SLIVER), 0u);
  EXPECT_EQ(run.statistics.movedVertices, 0u);
  const CheckedMesh mesh = MakeCheckedMesh(run.result);
  ExpectGuarantees(mesh);
  EXPECT_LT(ComputeDihedralAngles(MakeCheckedMesh(off.result)).minimum, 10.0);
  EXPECT_GE(ComputeDihedralAngles(mesh).minimum, 10.0);
  // It is stopped where new edges would be shorter.
  EXPECT_GT(ComputeShortestEdge(run.result), 0.249 * parameters.delta);
}

TEST(DelaunayRefinementRules, R4PrimeEndsForEveryAngle)
{
  auto parameters = MakeParameters(3.0);
  parameters.minimumDihedralAngle = 59.0;
  parameters.paperSlivers = true;
  const EngineRun run = RunEngine(BallOracle(origin, 5.0), parameters);
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  ExpectGuarantees(MakeCheckedMesh(run.result));
  EXPECT_GT(ComputeShortestEdge(run.result), 0.249 * parameters.delta);
}

TEST(DelaunayRefinementRules, CellSizeSplitsLargeTetrahedra)
{
  auto parameters = MakeParameters(2.0);
  EXPECT_EQ(RunEngine(torus, parameters).GetInsertions(RefinementRule::CELL_SIZE), 0u);
  parameters.cellSize = 2.0;
  EXPECT_GT(RunEngine(torus, parameters).GetInsertions(RefinementRule::CELL_SIZE), 0u);
}

TEST(DelaunayRefinementRules, ShapeReplacesVerticesOfFlatTetrahedra)
{
  // Four points of two concentric spheres are at times nearly coplanar.
  std::size_t insertions = 0;
  for (const double delta : { 0.9, 0.85, 0.8, 0.75 })
  {
    const EngineRun run = RunEngine(HollowBallOracle(origin, 5.0, 10.0), MakeParameters(delta));
    insertions += run.GetInsertions(RefinementRule::SHAPE);
    EXPECT_GT(ComputeMinimumRelativeVolume(MakeCheckedMesh(run.result)), MinimumRelativeVolume);
  }
  EXPECT_GT(insertions, 0u);
}

TEST(DelaunayRefinementRules, FreeVerticesMakeRoomForFeatureVertices)
{
  auto parameters = MakeParameters(2.0);
  parameters.cellSize = 2.0;
  const EngineRun run = RunEngine(torus, parameters);
  EXPECT_GT(run.statistics.removals, 0u);
}

TEST(DelaunayRefinementRules, EveryEncroachmentCaseFires)
{
  constexpr std::size_t boxCorners = 8;
  EngineRun             sum{};
  for (const EngineRun & run : GetRuns())
  {
    for (std::size_t i = 0; i < sum.statistics.encroachments.size(); ++i)
    {
      sum.statistics.encroachments[i] += run.statistics.encroachments[i];
    }
    // E1 and E3 put vertices on edges of the box, where nothing removes them; E2 on its faces.
    EXPECT_EQ(GetNumberOfVertices(run, VertexKind::BOX_EDGE),
              boxCorners + run.GetEncroachments(EncroachmentCase::E1) + run.GetEncroachments(EncroachmentCase::E3));
    EXPECT_LE(GetNumberOfVertices(run, VertexKind::BOX), run.GetEncroachments(EncroachmentCase::E2));
  }
  EXPECT_GT(sum.GetEncroachments(EncroachmentCase::E1), 0u);
  EXPECT_GT(sum.GetEncroachments(EncroachmentCase::E2), 0u);
  EXPECT_GT(sum.GetEncroachments(EncroachmentCase::E3), 0u);
}

TEST(DelaunayRefinementRules, ThinPartsDoNotMakeShortEdges)
{
  // Parts thinner than delta, sampled by R1 and R3 in turns.
  for (const double delta : { 1.0, 1.5, 2.0, 3.0 })
  {
    const EngineRun rod = RunEngine(PlateOracle(origin, { 10.0, 1.0, 1.0 }), MakeParameters(delta));
    const EngineRun ring = RunEngine(TorusOracle(origin, 10.0, 0.8), MakeParameters(delta));
    for (const EngineRun * run : { &rod, &ring })
    {
      ASSERT_NO_FATAL_FAILURE(ExpectCompleted(*run));
      const auto & lowered = run->statistics.loweredDeltas;
      EXPECT_GT(ComputeShortestEdge(run->result), 0.249 * (lowered.empty() ? delta : lowered[0].second))
        << "at delta " << delta;
    }
  }
}
