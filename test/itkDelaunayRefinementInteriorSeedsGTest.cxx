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
#include "itkDelaunayRefinementInteriorSeeds.h"

#include "itkAnalyticOracles.h"
#include "itkEngineRun.h"

using namespace itk::DelaunayRefinementTest;
using itk::DelaunayRefinementOracle;
using itk::DelaunayRefinementThreads;

namespace
{
const PointType origin{ 0.0, 0.0, 0.0 };

/** Points of the surface within delta of all of it. */
std::vector<PointType>
MakeFeatures(const AnalyticOracle & oracle, double delta)
{
  return GetFeaturePoints(RunEngine(oracle, MakeParameters(delta)).result);
}

std::vector<PointType>
FindSeeds(const DelaunayRefinementOracle & oracle,
          const std::vector<PointType> &   features,
          double                           delta,
          unsigned int                     numberOfThreads = 1,
          bool                             roundToFloat = false)
{
  DelaunayRefinementThreads threads(numberOfThreads);
  return itk::FindDelaunayRefinementInteriorSeeds(oracle, features, delta, roundToFloat, threads, [] { return true; });
}

void
ExpectRoom(const AnalyticOracle &         oracle,
           const std::vector<PointType> & features,
           const std::vector<PointType> & seeds,
           double                         delta)
{
  const PointLocator locator(features);
  EXPECT_GT(seeds.size(), 20u);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    EXPECT_LT(oracle.ComputeSignedDistance(seeds[i]), 0.0);
    EXPECT_GE(locator.FindDistance(seeds[i]), 2.0 * delta);
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GE(Distance(seeds[i], seeds[j]), 2.0 * delta);
    }
  }
}
} // namespace

TEST(DelaunayRefinementInteriorSeeds, AreInsideAndKeepTwoDeltasFromAllOthers)
{
  constexpr double       delta = 1.0;
  const HollowBallOracle shell({ 3.0, -7.0, 11.0 }, 4.0, 15.0);
  const TorusOracle      torus(origin, 12.0, 5.0);
  const auto             featuresOfShell = MakeFeatures(shell, delta);
  ExpectRoom(shell, featuresOfShell, FindSeeds(shell, featuresOfShell, delta), delta);
  const auto featuresOfTorus = MakeFeatures(torus, delta);
  ExpectRoom(torus, featuresOfTorus, FindSeeds(torus, featuresOfTorus, delta), delta);
}

TEST(DelaunayRefinementInteriorSeeds, KeepTheirDistanceInSinglePrecision)
{
  // A float there has steps of an eighth of delta.
  constexpr double delta = 1.0;
  const BallOracle ball({ 2097152.0, -2097152.0, 1048576.0 }, 15.0);
  auto             parameters = MakeParameters(delta);
  parameters.roundToFloat = true;
  const auto features = GetFeaturePoints(RunEngine(ball, parameters).result);
  const auto seeds = FindSeeds(ball, features, delta, 1, true);
  ExpectRoom(ball, features, seeds, delta);
  for (const PointType & seed : seeds)
  {
    for (const double coordinate : seed)
    {
      EXPECT_EQ(coordinate, static_cast<double>(static_cast<float>(coordinate)));
    }
  }
}

TEST(DelaunayRefinementInteriorSeeds, NoneOnceTheRunIsToEnd)
{
  const BallOracle          ball({ 0.0, 0.0, 0.0 }, 15.0);
  const auto                features = MakeFeatures(ball, 1.0);
  DelaunayRefinementThreads threads(2);
  EXPECT_TRUE(
    itk::FindDelaunayRefinementInteriorSeeds(ball, features, 1.0, false, threads, [] { return false; }).empty());
}

TEST(DelaunayRefinementInteriorSeeds, LeaveR2LittleToDo)
{
  // There is room for none deep inside, where R2 has nothing to do.
  constexpr double delta = 1.0;
  constexpr double radius = 15.0;
  const BallOracle ball(origin, radius);
  const auto       features = MakeFeatures(ball, delta);
  for (const PointType & seed : FindSeeds(ball, features, delta))
  {
    EXPECT_GT(Norm(seed), radius - 4.0 * delta);
  }
  const EngineRun run = RunEngine(ball, MakeParameters(delta));
  EXPECT_GT(run.statistics.seeds, run.GetInsertions(RefinementRule::R2) / 2);
  EXPECT_LE(run.statistics.seeds, run.GetInsertions(RefinementRule::R2));
}

TEST(DelaunayRefinementInteriorSeeds, NoneWhereThereIsNoRoom)
{
  constexpr double  delta = 1.0;
  const PlateOracle plate(origin, { 10.0, 8.0, 1.5 });
  EXPECT_TRUE(FindSeeds(plate, MakeFeatures(plate, delta), delta).empty());
}

TEST(DelaunayRefinementInteriorSeeds, NoneWhereTheLatticeWouldBeVeryLarge)
{
  const BallOracle ball(origin, 10.0);
  const auto       features = MakeFeatures(ball, 2.0);
  EXPECT_FALSE(FindSeeds(ball, features, 2.0).empty());
  EXPECT_TRUE(FindSeeds(ball, features, 1e-3).empty());
  EXPECT_TRUE(FindSeeds(ball, features, 1e-300).empty());
}

TEST(DelaunayRefinementInteriorSeeds, TheSameOnAnyNumberOfThreads)
{
  const TorusOracle torus(origin, 12.0, 5.0);
  const auto        features = MakeFeatures(torus, 0.5);
  const auto        seeds = FindSeeds(torus, features, 0.5);
  for (const unsigned int numberOfThreads : { 2u, 3u, 5u })
  {
    EXPECT_EQ(FindSeeds(torus, features, 0.5, numberOfThreads), seeds) << numberOfThreads;
  }
}
