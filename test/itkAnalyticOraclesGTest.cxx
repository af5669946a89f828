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

#include "itkAnalyticOracles.h"
#include "itkOracleChecks.h"

#include <gtest/gtest.h>

#include <memory>

using namespace itk::DelaunayRefinementTest;

namespace
{
struct Shape
{
  std::string                           name;
  std::shared_ptr<const AnalyticOracle> oracle;
};

std::ostream &
operator<<(std::ostream & out, const Shape & shape)
{
  return out << shape.name;
}

const PointType shapeCenter{ 1.5, -20.25, 7.0 };

class AnalyticOracles : public ::testing::TestWithParam<Shape>
{};
} // namespace

TEST_P(AnalyticOracles, AgreeWithClassify)
{
  const AnalyticOracle & oracle = *GetParam().oracle;
  const auto             surface = SampleSurfaceByClassify(oracle, 40);
  const auto             queries = MakeRandomPoints(MakeRoomyBox(oracle), 500, 1);
  ASSERT_GT(surface.size(), 500u);

  for (const PointType & point : surface)
  {
    ASSERT_NEAR(oracle.ComputeSignedDistance(point), 0.0, 1e-9);
  }
  ExpectClosestSurfacePoints(oracle, queries, surface, 1e-9, 1e-8);
  ExpectFirstCrossings(oracle, queries, 2000, 1e-8);
  ExpectPatchesCoverSurface(oracle, surface, 1e-9);
  ExpectBoxBound(oracle, surface);
}

TEST_P(AnalyticOracles, SamplesAreDenseAndOnTheSurface)
{
  const AnalyticOracle & oracle = *GetParam().oracle;
  const PointLocator     samples(SampleSurface(oracle, 0.8));
  for (const PointType & point : SampleSurfaceByClassify(oracle, 30))
  {
    EXPECT_LE(samples.FindDistance(point), 0.8);
  }
  for (const PointType & point : SampleSurface(oracle, 0.8))
  {
    EXPECT_NEAR(oracle.ComputeSignedDistance(point), 0.0, 1e-9);
  }
}

TEST_P(AnalyticOracles, VolumeAgreesWithClassify)
{
  const AnalyticOracle & oracle = *GetParam().oracle;
  const BoxType          box = MakeRoomyBox(oracle);
  const PointType        size = Subtract(box.maximum, box.minimum);
  constexpr std::size_t  count = 200000;
  std::size_t            inside = 0;
  for (const PointType & point : MakeRandomPoints(box, count, 2))
  {
    inside += oracle.Classify(point);
  }
  const double boxVolume = size[0] * size[1] * size[2];
  const double share = oracle.ComputeVolume() / boxVolume;
  EXPECT_NEAR(static_cast<double>(inside) / count, share, 5.0 * std::sqrt(share * (1.0 - share) / count));
}

INSTANTIATE_TEST_SUITE_P(
  Shapes,
  AnalyticOracles,
  ::testing::Values(Shape{ "Ball", std::make_shared<BallOracle>(shapeCenter, 10.0) },
                    Shape{ "Torus", std::make_shared<TorusOracle>(shapeCenter, 10.0, 4.0) },
                    Shape{ "HollowBall", std::make_shared<HollowBallOracle>(shapeCenter, 5.0, 10.0) },
                    Shape{ "TouchingBalls", std::make_shared<TwoBallsOracle>(shapeCenter, 6.0, 4.0, 0.0) },
                    Shape{ "SeparateBalls", std::make_shared<TwoBallsOracle>(shapeCenter, 4.0, 6.0, 3.0) },
                    Shape{ "Plate", std::make_shared<PlateOracle>(shapeCenter, PointType{ 10.0, 8.0, 2.0 }) }),
  [](const auto & test) { return test.param.name; });

TEST(AnalyticOracleComponents, AreCountedAndFound)
{
  const TwoBallsOracle separate(shapeCenter, 4.0, 6.0, 3.0);
  EXPECT_EQ(separate.GetNumberOfComponents(), 2u);
  EXPECT_EQ(separate.FindComponent(Add(shapeCenter, PointType{ -3.0, 0.0, 0.0 })), 0u);
  EXPECT_EQ(separate.FindComponent(Add(shapeCenter, PointType{ 3.0, 0.0, 0.0 })), 1u);

  const TwoBallsOracle touching(shapeCenter, 4.0, 6.0, 0.0);
  EXPECT_EQ(touching.GetNumberOfComponents(), 1u);
  EXPECT_EQ(touching.FindComponent(Add(shapeCenter, PointType{ 3.0, 0.0, 0.0 })), 0u);
}
