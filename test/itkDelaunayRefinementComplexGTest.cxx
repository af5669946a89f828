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
#include "itkDelaunayRefinementComplex.h"

#include "itkAnalyticOracles.h"
#include "itkEngineRun.h"

#include <random>

using namespace itk::DelaunayRefinementTest;
using itk::DelaunayRefinementComplex;
using itk::DelaunayRefinementThreads;

TEST(DelaunayRefinementComplex, FindsFreeVerticesWhereverTheyAre)
{
  using IndexType = DelaunayRefinementComplex::IndexType;
  const BallOracle          ball({ 0.0, 0.0, 0.0 }, 10.0);
  DelaunayRefinementComplex complex(ball, false, { { -40.0, -40.0, -40.0 }, { 40.0, 40.0, 40.0 } });
  DelaunayRefinementThreads threads(1);
  // Vertices 9 and 10, then 11.
  ASSERT_TRUE(complex.Start(
    { { 10.0, 0.0, 0.0 }, { 0.0, 10.0, 0.0 } }, { 1.0, 1.0 }, { { 5.0, 0.5, 0.25 } }, threads, [] { return true; }));
  constexpr IndexType feature = 9;
  constexpr IndexType seed = 11;
  const auto          find = [&complex](IndexType vertex, double radius) {
    std::vector<IndexType> found{ 1 };
    complex.FindFreeVerticesWithin(vertex, radius, found);
    return found;
  };
  EXPECT_EQ(find(feature, 6.0), std::vector<IndexType>{ seed });
  EXPECT_TRUE(find(feature, 4.0).empty());

  // One that is inserted later, and one that moves.
  const IndexType later = complex.Insert({ -5.0, 0.5, 0.25 }, VertexKind::FREE, 0.0, complex.GetNewCells().front());
  EXPECT_EQ(find(feature, 16.0).size(), 2u);
  const auto move = [&complex](IndexType vertex, const PointType & point) {
    complex.Remove(vertex);
    return complex.Reinsert(vertex, point, 0.0, complex.GetNewCells().front());
  };
  ASSERT_TRUE(move(later, { 9.0, 0.5, 0.25 }));
  EXPECT_EQ(find(feature, 2.0), std::vector<IndexType>{ later });

  // Where one was is no reason to find it.
  complex.Remove(later);
  EXPECT_TRUE(find(feature, 2.0).empty());
}

TEST(DelaunayRefinementComplex, FindsFreeVerticesHoweverManyThereAre)
{
  using IndexType = DelaunayRefinementComplex::IndexType;
  const BallOracle          ball({ 0.0, 0.0, 0.0 }, 10.0);
  DelaunayRefinementComplex complex(ball, false, { { -40.0, -40.0, -40.0 }, { 40.0, 40.0, 40.0 } });
  DelaunayRefinementThreads threads(1);
  ASSERT_TRUE(complex.Start({ { 10.0, 0.0, 0.0 } }, { 1.0 }, {}, threads, [] { return true; }));
  constexpr IndexType    feature = 9;
  std::mt19937           random(1);
  std::vector<IndexType> frees;
  for (unsigned int i = 0; i < 500; ++i)
  {
    PointType point;
    for (double & coordinate : point)
    {
      coordinate = static_cast<double>(random() % 20000) * 1e-3 - 10.0;
    }
    frees.push_back(complex.Insert(point, VertexKind::FREE, 0.0, complex.GetNewCells().front()));
    std::vector<IndexType> found;
    complex.FindFreeVerticesWithin(feature, 5.0, found);
    std::sort(found.begin(), found.end());
    std::vector<IndexType> expected;
    std::copy_if(frees.begin(), frees.end(), std::back_inserter(expected), [&complex](IndexType vertex) {
      return Distance(complex.GetPoint(vertex), complex.GetPoint(feature)) < 5.0;
    });
    ASSERT_EQ(found, expected) << i;
  }
}
