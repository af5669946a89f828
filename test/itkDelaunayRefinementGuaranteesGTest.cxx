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

#include <memory>

using namespace itk::DelaunayRefinementTest;

namespace
{
using OraclePointer = std::shared_ptr<const AnalyticOracle>;

const PointType origin{ 0.0, 0.0, 0.0 };

/** A shape that is sampled densely enough for a mesh of its topology. */
struct SmoothCase
{
  std::string      name;
  OraclePointer    oracle;
  double           delta;
  double           smallestRadius;
  ExpectedTopology topology;
};

std::ostream &
operator<<(std::ostream & out, const SmoothCase & value)
{
  return out << value.name << " at delta " << value.delta;
}

class SmoothShapes : public ::testing::TestWithParam<SmoothCase>
{};

/** A shape whose local feature size is 0 somewhere, or a delta that is large for it. */
struct HarshCase
{
  std::string   name;
  OraclePointer oracle;
  double        delta;
};

std::ostream &
operator<<(std::ostream & out, const HarshCase & value)
{
  return out << value.name << " at delta " << value.delta;
}

class HarshShapes : public ::testing::TestWithParam<HarshCase>
{};

/** The circumcenter of each tetrahedron is in its region (paper, section III: what the output is), but for those that
 * came in to make the boundary a manifold. */
void
ExpectCircumcentersInside(const EngineRun & run, const AnalyticOracle & oracle)
{
  const itk::DelaunayRefinementResult & result = run.result;
  std::size_t                           numberOutside = 0;
  for (std::size_t i = 0; i < result.tetrahedra.size(); ++i)
  {
    const auto &       t = result.tetrahedra[i];
    const PointType &  p = result.points[t[0]];
    const Circumsphere sphere = ComputeCircumsphere(p, result.points[t[1]], result.points[t[2]], result.points[t[3]]);
    const PointType    center{ p[0] + static_cast<double>(sphere.center[0]),
                            p[1] + static_cast<double>(sphere.center[1]),
                            p[2] + static_cast<double>(sphere.center[2]) };
    numberOutside += oracle.ComputeSignedDistance(center) > 1e-6 ? 1 : 0;
    EXPECT_EQ(result.regions[i], 1u);
  }
  EXPECT_LE(numberOutside, run.statistics.changedTetrahedra);
}

/** Rule R3: from inside, the dual of each boundary facet crosses the surface within delta of the facet's vertices. */
void
ExpectSmallSurfaceBalls(const CheckedMesh & mesh, const AnalyticOracle & oracle, double delta)
{
  for (const auto & triangle : mesh.triangles)
  {
    const PointType & a = mesh.points[triangle[0]];
    const PointType   ab = Subtract(mesh.points[triangle[1]], a);
    const PointType   ac = Subtract(mesh.points[triangle[2]], a);
    const PointType   normal = Cross(ab, ac);
    const PointType toCenter = Scale(Add(Scale(Cross(normal, ab), Dot(ac, ac)), Scale(Cross(ac, normal), Dot(ab, ab))),
                                     0.5 / Dot(normal, normal));
    const PointType center = Add(a, toCenter);
    const PointType reach = Scale(normal, delta / Norm(normal));
    PointType       crossing;
    ASSERT_TRUE(oracle.FindFirstCrossing(Subtract(center, reach), Add(center, reach), crossing));
    EXPECT_LT(Distance(crossing, a), delta);
  }
}
} // namespace

TEST_P(SmoothShapes, KeepAllGuarantees)
{
  const SmoothCase &     shape = GetParam();
  const AnalyticOracle & oracle = *shape.oracle;
  const double           delta = shape.delta;
  // No point of a facet of circumradius below delta is farther from the surface than this.
  const double largestDeviation =
    shape.smallestRadius - std::sqrt(shape.smallestRadius * shape.smallestRadius - delta * delta);

  for (const bool roundToFloat : { false, true })
  {
    auto parameters = MakeParameters(delta);
    parameters.roundToFloat = roundToFloat;
    const EngineRun run = RunEngine(oracle, parameters);
    ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
    const CheckedMesh mesh = MakeCheckedMesh(run.result);

    ExpectGuarantees(mesh);
    ExpectManifoldBoundary(mesh);
    ExpectTopology(mesh, shape.topology);
    EXPECT_EQ(run.statistics.changedTetrahedra, 0u);
    ExpectCircumcentersInside(run, oracle);
    ExpectSmallSurfaceBalls(mesh, oracle, delta);
    EXPECT_LT(ComputeCoverage(oracle, run.result, delta / 4.0), delta);
    EXPECT_GT(ComputeShortestEdge(run.result), 0.979 * delta);

    const double largestDistance = ComputeMaximumDistance(SampleBoundary(mesh, delta / 4.0), [&](const PointType & p) {
      return std::abs(oracle.ComputeSignedDistance(p));
    });
    EXPECT_LT(largestDistance, largestDeviation + 1e-5);
    EXPECT_LT(ComputeDistanceToBoundary(SampleSurface(oracle, delta / 2.5), mesh), largestDeviation + 1e-5);
    EXPECT_NEAR(ComputeVolume(mesh) / oracle.ComputeVolume(), 1.0, 3.0 * largestDeviation / shape.smallestRadius);
  }
}

TEST_P(SmoothShapes, HaveBoundaryVerticesOnTheSurface)
{
  const SmoothCase & shape = GetParam();
  for (const bool roundToFloat : { false, true })
  {
    auto parameters = MakeParameters(shape.delta);
    parameters.roundToFloat = roundToFloat;
    const EngineRun run = RunEngine(*shape.oracle, parameters);
    ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));

    // Half a unit in the last place of coordinates below 32, in each direction.
    const double tolerance = roundToFloat ? std::sqrt(3.0) * std::ldexp(1.0, -20) : 1e-6;
    for (const auto & triangle : run.result.boundaryTriangles)
    {
      for (const std::uint32_t vertex : triangle)
      {
        EXPECT_EQ(run.result.pointKinds[vertex], VertexKind::FEATURE);
      }
    }
    for (const PointType & point : GetFeaturePoints(run.result))
    {
      EXPECT_NEAR(shape.oracle->ComputeSignedDistance(point), 0.0, tolerance);
    }
    if (roundToFloat)
    {
      for (const PointType & point : run.result.points)
      {
        EXPECT_EQ(point, RoundToFloat(point));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Shapes,
  SmoothShapes,
  ::testing::Values(
    SmoothCase{ "BallCoarse", std::make_shared<BallOracle>(origin, 10.0), 4.0, 10.0, { 1, 1, 2 } },
    SmoothCase{ "Ball", std::make_shared<BallOracle>(PointType{ 1.0, -2.0, 3.0 }, 10.0), 2.0, 10.0, { 1, 1, 2 } },
    SmoothCase{ "BallFine", std::make_shared<BallOracle>(origin, 10.0), 0.8, 10.0, { 1, 1, 2 } },
    SmoothCase{ "Torus", std::make_shared<TorusOracle>(origin, 10.0, 4.0), 1.5, 4.0, { 1, 1, 0 } },
    SmoothCase{ "TorusFine", std::make_shared<TorusOracle>(origin, 10.0, 4.0), 0.9, 4.0, { 1, 1, 0 } },
    SmoothCase{ "HollowBall", std::make_shared<HollowBallOracle>(origin, 5.0, 10.0), 1.5, 5.0, { 1, 2, 4 } },
    SmoothCase{ "HollowBallFine", std::make_shared<HollowBallOracle>(origin, 5.0, 10.0), 0.9, 5.0, { 1, 2, 4 } },
    SmoothCase{ "SeparateBalls", std::make_shared<TwoBallsOracle>(origin, 6.0, 4.0, 3.0), 1.2, 4.0, { 2, 2, 4 } }),
  [](const auto & test) { return test.param.name; });

TEST_P(HarshShapes, KeepValidityAndQuality)
{
  const HarshCase &      shape = GetParam();
  const AnalyticOracle & oracle = *shape.oracle;
  for (const bool roundToFloat : { false, true })
  {
    auto parameters = MakeParameters(shape.delta);
    parameters.roundToFloat = roundToFloat;
    const EngineRun run = RunEngine(oracle, parameters);
    ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
    const CheckedMesh mesh = MakeCheckedMesh(run.result);
    ExpectGuarantees(mesh);
    ExpectManifoldBoundary(mesh);
    ExpectCircumcentersInside(run, oracle);
    EXPECT_LT(ComputeMaximumDistance(SampleBoundary(mesh, shape.delta / 4.0),
                                     [&](const PointType & p) { return std::abs(oracle.ComputeSignedDistance(p)); }),
              shape.delta);
    EXPECT_TRUE(run.statistics.missingComponents.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(
  Shapes,
  HarshShapes,
  ::testing::Values(
    HarshCase{ "BallVeryCoarse", std::make_shared<BallOracle>(origin, 10.0), 12.0 },
    HarshCase{ "TouchingBalls", std::make_shared<TwoBallsOracle>(origin, 6.0, 4.0, 0.0), 2.0 },
    HarshCase{ "TouchingBallsFine", std::make_shared<TwoBallsOracle>(origin, 6.0, 4.0, 0.0), 1.0 },
    HarshCase{ "NearBalls", std::make_shared<TwoBallsOracle>(origin, 5.0, 5.0, 0.1), 1.0 },
    HarshCase{ "ThickPlate", std::make_shared<PlateOracle>(origin, PointType{ 10.0, 8.0, 2.0 }), 1.5 },
    HarshCase{ "Plate", std::make_shared<PlateOracle>(origin, PointType{ 10.0, 8.0, 1.0 }), 1.0 },
    HarshCase{ "ThinPlateCoarse", std::make_shared<PlateOracle>(origin, PointType{ 10.0, 8.0, 0.5 }), 3.0 },
    HarshCase{ "ThinPlate", std::make_shared<PlateOracle>(origin, PointType{ 6.0, 5.0, 0.5 }), 0.5 },
    HarshCase{ "ThinTorus", std::make_shared<TorusOracle>(origin, 10.0, 1.0), 1.2 },
    HarshCase{ "ThinShell", std::make_shared<HollowBallOracle>(origin, 9.0, 10.0), 1.5 }),
  [](const auto & test) { return test.param.name; });

TEST(DelaunayRefinementGuarantees, PlateThickerThanDeltaHasNoHoles)
{
  const PlateOracle plate(origin, { 10.0, 8.0, 1.0 });
  const EngineRun   run = RunEngine(plate, MakeParameters(0.8));
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  const CheckedMesh mesh = MakeCheckedMesh(run.result);
  ExpectTopology(mesh, { 1, 1, 2 });
  EXPECT_LT(ComputeCoverage(plate, run.result, 0.2), 0.8);
  EXPECT_NEAR(ComputeVolume(mesh) / plate.ComputeVolume(), 1.0, 0.1);
}

TEST(DelaunayRefinementGuarantees, RadiusEdgeRatioIsBelowEachBound)
{
  const TorusOracle torus(origin, 10.0, 4.0);
  for (const double bound : { 1.0, 1.3, 1.6, 2.0, 3.0 })
  {
    auto parameters = MakeParameters(1.5);
    parameters.radiusEdgeRatioBound = bound;
    const EngineRun run = RunEngine(torus, parameters);
    ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
    const CheckedMesh mesh = MakeCheckedMesh(run.result);
    ExpectGuarantees(mesh, bound);
    // The bound is felt: without it, some tetrahedra are above.
    EXPECT_GT(ComputeMaximumRadiusEdgeRatio(mesh), std::min(0.9 * bound, 1.5));
  }
}

TEST(DelaunayRefinementGuarantees, CircumradiiAreWithinCellSize)
{
  const BallOracle ball(origin, 10.0);
  const EngineRun  free = RunEngine(ball, MakeParameters(1.5));
  for (const double cellSize : { 2.0, 1.2, 0.9 })
  {
    auto parameters = MakeParameters(1.5);
    parameters.cellSize = cellSize;
    const EngineRun run = RunEngine(ball, parameters);
    ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
    const CheckedMesh mesh = MakeCheckedMesh(run.result);
    ExpectGuarantees(mesh);
    EXPECT_LE(ComputeMaximumCircumradius(mesh), cellSize * (1.0 + 1e-6));
    EXPECT_GT(run.result.tetrahedra.size(), free.result.tetrahedra.size());
  }
}

TEST(DelaunayRefinementGuarantees, ComponentDeltaHoldsForItsComponent)
{
  // The left ball is component 0.
  const double         coarse = 3.0;
  const double         fine = 0.8;
  const TwoBallsOracle balls(origin, 8.0, 8.0, 4.0);
  auto                 parameters = MakeParameters(coarse);
  parameters.componentDelta = { coarse, fine };
  const EngineRun run = RunEngine(balls, parameters);
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  const CheckedMesh mesh = MakeCheckedMesh(run.result);
  ExpectGuarantees(mesh);
  ExpectTopology(mesh, { 2, 2, 4 });

  const PointLocator features(GetFeaturePoints(run.result));
  for (const PointType & sample : SampleSurface(balls, 0.3))
  {
    EXPECT_LT(features.FindDistance(sample), sample[0] > 0.0 ? fine : coarse);
  }
  std::array<std::size_t, 2> numbersOfTriangles{};
  for (const auto & triangle : mesh.triangles)
  {
    ++numbersOfTriangles[mesh.points[triangle[0]][0] > 0.0 ? 1 : 0];
  }
  EXPECT_GT(numbersOfTriangles[1], 5 * numbersOfTriangles[0]);
}

TEST(DelaunayRefinementGuarantees, DeltaIsLoweredForSmallComponentsAlone)
{
  const TwoBallsOracle balls(origin, 10.0, 0.8, 6.0);
  const EngineRun      run = RunEngine(balls, MakeParameters(5.0));
  ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
  const CheckedMesh mesh = MakeCheckedMesh(run.result);
  ExpectGuarantees(mesh);
  ExpectTopology(mesh, { 2, 2, 4 });
  EXPECT_TRUE(run.statistics.missingComponents.empty());
  ASSERT_EQ(run.statistics.loweredDeltas.size(), 1u);
  EXPECT_EQ(run.statistics.loweredDeltas[0].first, 1u);
  EXPECT_LT(run.statistics.loweredDeltas[0].second, 5.0);
  EXPECT_GT(run.statistics.loweredDeltas[0].second, 0.1);
}

TEST(DelaunayRefinementGuarantees, HoldFarFromTheOrigin)
{
  const PointType center{ 1e5, -1e5, 1e5 };
  for (const double delta : { 2.0, 0.5 })
  {
    const double radius = 5.0 * delta;
    for (const OraclePointer & oracle :
         { OraclePointer(std::make_shared<BallOracle>(center, radius)),
           OraclePointer(std::make_shared<TorusOracle>(center, 1.5 * radius, 0.8 * radius)) })
    {
      for (const bool roundToFloat : { false, true })
      {
        auto parameters = MakeParameters(delta);
        parameters.roundToFloat = roundToFloat;
        const EngineRun run = RunEngine(*oracle, parameters);
        ASSERT_NO_FATAL_FAILURE(ExpectCompleted(run));
        const CheckedMesh mesh = MakeCheckedMesh(run.result);
        ExpectGuarantees(mesh);
        if (roundToFloat)
        {
          // What a mesh of floats stores is what the engine judged.
          CheckedMesh stored = mesh;
          for (PointType & point : stored.points)
          {
            point = RoundToFloat(point);
          }
          EXPECT_TRUE(stored.points == mesh.points);
          ExpectGuarantees(stored);
        }
        EXPECT_NEAR(ComputeVolume(mesh) / oracle->ComputeVolume(), 1.0, 0.15);
        EXPECT_LT(ComputeCoverage(*oracle, run.result, delta / 4.0), delta + (roundToFloat ? 0.01 : 0.0));
      }
    }
  }
}
