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
#include "itkDelaunayRefinementSurfaceSample.h"

#include "itkAnalyticOracles.h"
#include "itkEngineRun.h"

#include <thread>

using namespace itk::DelaunayRefinementTest;
using itk::DelaunayRefinementLocalDelta;
using itk::DelaunayRefinementOracle;
using itk::DelaunayRefinementSurfaceSample;
using itk::DelaunayRefinementThreads;

namespace
{
const PointType origin{ 0.0, 0.0, 0.0 };

constexpr double Delta = 0.4;

/** Large against delta: its patches make some dozens of blocks. */
const HollowBallOracle shell(origin, 5.0, 10.0);

std::vector<PointType>
Sample(const DelaunayRefinementOracle &          oracle,
       const itk::DelaunayRefinementParameters & parameters,
       unsigned int                              numberOfThreads)
{
  const DelaunayRefinementLocalDelta localDelta(oracle, parameters);
  DelaunayRefinementSurfaceSample    sample(oracle, localDelta, parameters.roundToFloat);
  DelaunayRefinementThreads          threads(numberOfThreads);
  std::vector<PointType>             points;
  EXPECT_TRUE(sample.Certify(points, threads, [] { return true; }));
  return points;
}
} // namespace

TEST(DelaunayRefinementSurfaceSample, SamePointsForAnyNumberOfThreads)
{
  for (const bool roundToFloat : { false, true })
  {
    auto parameters = MakeParameters(Delta);
    parameters.roundToFloat = roundToFloat;
    const auto points = Sample(shell, parameters, 1);
    for (const unsigned int numberOfThreads : { 1u, 2u, 3u, 5u })
    {
      EXPECT_EQ(Sample(shell, parameters, numberOfThreads), points) << numberOfThreads;
    }
  }
}

TEST(DelaunayRefinementSurfaceSample, SamePointsForAnyNumberOfThreadsWhereDeltaVaries)
{
  const TwoBallsOracle balls(origin, 6.0, 3.0, 1.0);
  auto                 parameters = MakeParameters(Delta);
  parameters.componentDelta = { Delta, 0.6 * Delta };
  const auto points = Sample(balls, parameters, 1);
  for (const unsigned int numberOfThreads : { 2u, 3u, 5u })
  {
    EXPECT_EQ(Sample(balls, parameters, numberOfThreads), points) << numberOfThreads;
  }
}

TEST(DelaunayRefinementSurfaceSample, CoversTheSurfaceAndKeepsADistance)
{
  const auto   points = Sample(shell, MakeParameters(Delta), 3);
  PointLocator locator(points);
  EXPECT_LE(ComputeMaximumDistance(SampleSurface(shell, 0.3 * Delta),
                                   [&locator](const PointType & sample) { return locator.FindDistance(sample); }),
            Delta);
  double shortest = Delta;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      shortest = std::min(shortest, Distance(points[i], points[j]));
    }
  }
  EXPECT_GT(shortest, 0.979 * Delta);
}

TEST(DelaunayRefinementSurfaceSample, OnlyTheCallingThreadIsAskedWhetherToGoOn)
{
  const auto                         parameters = MakeParameters(0.5 * Delta);
  const DelaunayRefinementLocalDelta localDelta(shell, parameters);
  DelaunayRefinementThreads          threads(3);
  for (const unsigned int lastCall : { 1u, 2u, 4u })
  {
    DelaunayRefinementSurfaceSample sample(shell, localDelta, false);
    std::vector<PointType>          points;
    unsigned int                    numberOfCalls = 0;
    const bool                      isDone = sample.Certify(points, threads, [&, caller = std::this_thread::get_id()] {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      return ++numberOfCalls < lastCall;
    });
    // The other threads may have left the calling one too little work to ask as often.
    EXPECT_EQ(isDone, numberOfCalls < lastCall);
    EXPECT_LE(numberOfCalls, lastCall);
  }
}
