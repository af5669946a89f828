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
using itk::DelaunayRefinementEngine;
using itk::DelaunayRefinementOracle;
using itk::DelaunayRefinementParameters;

namespace
{
const PointType origin{ 0.0, 0.0, 0.0 };

/** \class NothingOracle
 * \brief An empty object. */
class NothingOracle : public BallOracle
{
public:
  NothingOracle()
    : BallOracle(origin, 10.0)
  {}

  RegionType
  Classify(const PointType &) const override
  {
    return 0;
  }

  bool
  FindClosestSurfacePoint(const PointType &, double, PointType &) const override
  {
    return false;
  }

  bool
  FindFirstCrossing(const PointType &, const PointType &, PointType &) const override
  {
    return false;
  }

  bool
  MayIntersectBox(const BoundsType &) const override
  {
    return false;
  }

  SurfacePatches
  GetSurfacePatches() const override
  {
    return SurfacePatches();
  }

  bool
  FindPointOfPatch(const SurfacePatchIdentifier &, PointType &) const override
  {
    return false;
  }

  ComponentType
  GetNumberOfComponents() const override
  {
    return 0;
  }
};

bool
IsEmpty(const itk::DelaunayRefinementResult & result)
{
  return result.points.empty() && result.pointKinds.empty() && result.tetrahedra.empty() && result.regions.empty() &&
         result.boundaryTriangles.empty() && result.boundaryRegions.empty();
}
} // namespace

TEST(DelaunayRefinementEngine, SameMeshOnAnyNumberOfThreads)
{
  struct CaseType
  {
    double delta;
    bool   refineOutside;
    double minimumDihedralAngle;
    double cellSize;
  };
  const TorusOracle torus(origin, 10.0, 4.0);
  const double      unbounded = std::numeric_limits<double>::infinity();
  for (const CaseType & test : { CaseType{ 0.7, false, 0.0, unbounded },
                                 CaseType{ 1.0, true, 0.0, unbounded },
                                 CaseType{ 1.0, false, 8.0, unbounded },
                                 CaseType{ 1.2, false, 0.0, 0.5 } })
  {
    const auto makeHash = [&](unsigned int numberOfThreads) {
      auto parameters = MakeParameters(test.delta);
      parameters.refineOutside = test.refineOutside;
      parameters.minimumDihedralAngle = test.minimumDihedralAngle;
      parameters.cellSize = test.cellSize;
      parameters.numberOfThreads = numberOfThreads;
      const EngineRun run = RunEngine(torus, parameters);
      ExpectCompleted(run);
      return ComputeHash(run.result);
    };
    const std::uint64_t hash = makeHash(1);
    for (const unsigned int numberOfThreads : { 2u, 3u, 7u })
    {
      EXPECT_EQ(makeHash(numberOfThreads), hash) << numberOfThreads << " threads, delta " << test.delta;
    }
  }
}

TEST(DelaunayRefinementEngine, SameMeshTwice)
{
  // The torus needs most rules; symmetric sheets have flat tetrahedra, which are mended by chance.
  const TorusOracle      torus(origin, 10.0, 4.0);
  const HollowBallOracle shell(origin, 5.0, 10.0);
  const auto             makeHash = [&](bool isTorus, bool roundToFloat) {
    auto parameters = MakeParameters(isTorus ? 1.2 : 1.0);
    parameters.roundToFloat = roundToFloat;
    parameters.minimumDihedralAngle = isTorus ? 8.0 : 0.0;
    const EngineRun run = isTorus ? RunEngine(torus, parameters) : RunEngine(shell, parameters);
    return ComputeHash(run.result);
  };
  for (const bool isTorus : { false, true })
  {
    for (const bool roundToFloat : { false, true })
    {
      const std::uint64_t hash = makeHash(isTorus, roundToFloat);

      // Other addresses for whatever the engine allocates.
      std::vector<std::unique_ptr<char[]>> blocks;
      std::mt19937                         generator(1);
      for (unsigned int i = 0; i < 20000; ++i)
      {
        blocks.push_back(std::make_unique<char[]>(16 + generator() % 500));
      }
      for (std::size_t i = 0; i < blocks.size(); i += 2)
      {
        blocks[i].reset();
      }
      const BallOracle         other(origin, 5.0);
      DelaunayRefinementEngine between(other, MakeParameters(1.0));
      EXPECT_EQ(between.Run(), TerminationReason::COMPLETED);
      EXPECT_NE(ComputeHash(between.TakeResult()), hash);
      EXPECT_EQ(makeHash(isTorus, roundToFloat), hash);
    }
  }
}

TEST(DelaunayRefinementEngine, SameMeshForAnyNumberOfThreads)
{
  // Large against delta: the threads have many blocks of the surface to share.
  const HollowBallOracle shell(origin, 5.0, 10.0);
  const auto             makeHash = [&](unsigned int numberOfThreads) {
    auto parameters = MakeParameters(0.5);
    parameters.numberOfThreads = numberOfThreads;
    return ComputeHash(RunEngine(shell, parameters).result);
  };
  const std::uint64_t hash = makeHash(1);
  for (const unsigned int numberOfThreads : { 2u, 3u, 5u })
  {
    EXPECT_EQ(makeHash(numberOfThreads), hash) << numberOfThreads;
  }
}

TEST(DelaunayRefinementEngine, OtherParametersMakeAnotherMesh)
{
  const BallOracle ball(origin, 10.0);
  auto             parameters = MakeParameters(2.0);
  const auto       hash = ComputeHash(RunEngine(ball, parameters).result);
  parameters.roundToFloat = true;
  EXPECT_NE(ComputeHash(RunEngine(ball, parameters).result), hash);
}

TEST(DelaunayRefinementEngine, ProgressGrowsFromZeroToOne)
{
  std::vector<double> shares;
  auto                parameters = MakeParameters(0.7);
  parameters.progress = [&shares](double share) {
    shares.push_back(share);
    return true;
  };
  ExpectCompleted(RunEngine(BallOracle(origin, 10.0), parameters));
  ASSERT_GT(shares.size(), 5u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_LT(shares.front(), 0.5);
  EXPECT_LE(shares.back(), 1.0);
  EXPECT_GT(shares.back(), shares.front());
}

TEST(DelaunayRefinementEngine, StopsWhenTheCallerSaysSo)
{
  const BallOracle ball(origin, 10.0);
  for (const unsigned int lastCall : { 1u, 2u, 3u, 5u })
  {
    unsigned int numberOfCalls = 0;
    auto         parameters = MakeParameters(0.7);
    parameters.progress = [&numberOfCalls, lastCall](double) { return ++numberOfCalls < lastCall; };
    const EngineRun run = RunEngine(ball, parameters);
    EXPECT_EQ(run.reason, TerminationReason::STOPPED_BY_CALLER);
    EXPECT_TRUE(IsEmpty(run.result));
    EXPECT_EQ(numberOfCalls, lastCall);
  }
}

TEST(DelaunayRefinementEngine, StopsAtTheVertexLimit)
{
  const BallOracle ball(origin, 10.0);
  auto             parameters = MakeParameters(1.0);
  const EngineRun  whole = RunEngine(ball, parameters);
  ExpectCompleted(whole);
  const auto &      vertices = whole.statistics.vertices;
  const std::size_t numberOfVertices = vertices[0] + vertices[1] + vertices[2] + vertices[3];
  ASSERT_GT(numberOfVertices, whole.result.points.size());

  for (const std::size_t limit : { std::size_t{ 1 }, std::size_t{ 100 }, numberOfVertices - 1 })
  {
    parameters.maximumNumberOfVertices = limit;
    const EngineRun run = RunEngine(ball, parameters);
    EXPECT_EQ(run.reason, TerminationReason::VERTEX_LIMIT) << limit;
    EXPECT_TRUE(IsEmpty(run.result));
    const auto & stopped = run.statistics.vertices;
    EXPECT_LE(stopped[0] + stopped[1] + stopped[2] + stopped[3], limit);
  }

  parameters.maximumNumberOfVertices = 2 * numberOfVertices;
  EXPECT_EQ(ComputeHash(RunEngine(ball, parameters).result), ComputeHash(whole.result));
}

TEST(DelaunayRefinementEngine, FindsNoSurfaceOfNothing)
{
  const EngineRun run = RunEngine(NothingOracle(), MakeParameters(1.0));
  EXPECT_EQ(run.reason, TerminationReason::NO_SURFACE_FOUND);
  EXPECT_TRUE(IsEmpty(run.result));
}

TEST(DelaunayRefinementEngine, StatisticsAddUp)
{
  auto parameters = MakeParameters(1.0);
  parameters.minimumDihedralAngle = 5.0;
  const EngineRun run = RunEngine(TorusOracle(origin, 10.0, 4.0), parameters);
  ExpectCompleted(run);
  std::size_t insertions = 0;
  for (const std::size_t count : run.statistics.insertions)
  {
    insertions += count;
  }
  const auto &          vertices = run.statistics.vertices;
  constexpr std::size_t boxCorners = 8;
  // A vertex of rule SHAPE replaces another; one of cases E1 to E3 counts as one of R2.
  EXPECT_EQ(vertices[0] + vertices[1] + vertices[2] + vertices[3] + run.statistics.removals +
              run.statistics.encroachmentRemovals + run.GetInsertions(RefinementRule::SHAPE),
            insertions + boxCorners);
  EXPECT_EQ(run.GetEncroachments(EncroachmentCase::NONE), 0u);
  EXPECT_GE(vertices[static_cast<std::size_t>(VertexKind::FEATURE)], GetFeaturePoints(run.result).size());
  EXPECT_GE(vertices[static_cast<std::size_t>(VertexKind::BOX_EDGE)], boxCorners);
  EXPECT_TRUE(run.statistics.missingComponents.empty());
  EXPECT_TRUE(run.statistics.loweredDeltas.empty());
  EXPECT_GE(run.statistics.samplingSeconds, 0.0);
  EXPECT_GT(run.statistics.refinementSeconds, 0.0);
}

TEST(DelaunayRefinementEngine, SecondResultIsEmpty)
{
  const BallOracle         ball(origin, 10.0);
  DelaunayRefinementEngine engine(ball, MakeParameters(3.0));
  ASSERT_EQ(engine.Run(), TerminationReason::COMPLETED);
  EXPECT_FALSE(IsEmpty(engine.TakeResult()));
  EXPECT_TRUE(IsEmpty(engine.TakeResult()));
}
