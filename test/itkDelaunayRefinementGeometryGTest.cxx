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
#include "itkDelaunayRefinementGeometry.h"

#include "itkOracleChecks.h"
#include "itkTestGeometry.h"

#include <gtest/gtest.h>

using namespace itk::DelaunayRefinementTest;
using Geometry = itk::DelaunayRefinementGeometry;

namespace
{
/** Points of which each four are a tetrahedron, far enough from flat for a formula in double precision. */
std::vector<std::array<PointType, 4>>
MakeTetrahedra()
{
  const auto points = MakeRandomPoints({ { -20.0, 30.0, 5.0 }, { -10.0, 40.0, 15.0 } }, 4000, 1);
  std::vector<std::array<PointType, 4>> tetrahedra;
  for (std::size_t i = 0; i + 3 < points.size(); i += 4)
  {
    const std::array<PointType, 4> candidate{ points[i], points[i + 1], points[i + 2], points[i + 3] };
    if (std::abs(ComputeTetrahedronVolume(candidate[0], candidate[1], candidate[2], candidate[3])) > 1.0)
    {
      tetrahedra.push_back(candidate);
    }
  }
  return tetrahedra;
}
} // namespace

TEST(DelaunayRefinementGeometry, TetrahedraAgreeWithLongArithmetic)
{
  const auto tetrahedra = MakeTetrahedra();
  ASSERT_GT(tetrahedra.size(), 500u);
  for (const auto & [a, b, c, d] : tetrahedra)
  {
    EXPECT_NEAR(Geometry::Determinant(a, b, c, d), 6.0 * ComputeTetrahedronVolume(a, b, c, d), 1e-9);

    const Circumsphere expected = ComputeCircumsphere(a, b, c, d);
    const auto         sphere = Geometry::ComputeCircumsphere(a, b, c, d);
    const auto         radius = static_cast<double>(expected.radius);
    EXPECT_NEAR(std::sqrt(sphere.squaredRadius), radius, 1e-9 * radius);
    for (const PointType & point : { a, b, c, d })
    {
      EXPECT_NEAR(Geometry::Distance(sphere.center, point), radius, 1e-9 * radius);
    }

    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    for (const auto & [from, to] : { std::make_pair(a, b),
                                     std::make_pair(a, c),
                                     std::make_pair(a, d),
                                     std::make_pair(b, c),
                                     std::make_pair(b, d),
                                     std::make_pair(c, d) })
    {
      shortest = std::min(shortest, Distance(from, to));
      longest = std::max(longest, Distance(from, to));
    }
    EXPECT_NEAR(std::sqrt(Geometry::ComputeSquaredShortestEdge(a, b, c, d)), shortest, 1e-12);
    EXPECT_NEAR(std::sqrt(Geometry::ComputeSquaredLongestEdge(a, b, c, d)), longest, 1e-12);
  }
}

TEST(DelaunayRefinementGeometry, CircumsphereOfNearlyFlatPointsIsPrecise)
{
  // Four corners of a square, one of them lifted by h along an axis through the center: that moves the center by h / 2.
  // Without exact arithmetic, the last of these would be off by the radius.
  constexpr double tolerance = 1e-8;
  for (const double lift : { 1e-3, 1e-7, 1e-11, 1e-15 })
  {
    const auto sphere =
      Geometry::ComputeCircumsphere({ 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, -1.0, lift });
    EXPECT_NEAR(sphere.center[0], 0.0, tolerance);
    EXPECT_NEAR(sphere.center[1], 0.0, tolerance);
    EXPECT_NEAR(sphere.center[2], 0.5 * lift, tolerance);
    EXPECT_NEAR(sphere.squaredRadius, 1.0 + 0.25 * lift * lift, tolerance);
  }
}

TEST(DelaunayRefinementGeometry, CircumsphereOfATriangleIsTheSmallest)
{
  for (const auto & [a, b, c, unused] : MakeTetrahedra())
  {
    (void)unused;
    const auto   sphere = Geometry::ComputeCircumsphere(a, b, c);
    const double radius = std::sqrt(sphere.squaredRadius);
    for (const PointType & point : { a, b, c })
    {
      EXPECT_NEAR(Distance(sphere.center, point), radius, 1e-7 * radius);
    }
    // In the triangle's plane.
    const PointType normal = Cross(Subtract(b, a), Subtract(c, a));
    EXPECT_NEAR(Dot(Subtract(sphere.center, a), normal) / Norm(normal), 0.0, 1e-7 * radius);
  }
}

TEST(DelaunayRefinementGeometry, DihedralCosineIsThatOfTheSmallestAngle)
{
  for (const auto & [a, b, c, d] : MakeTetrahedra())
  {
    const std::array<PointType, 4> p{ a, b, c, d };
    double                         smallest = 180.0;
    for (unsigned int i = 0; i < 4; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
      {
        const unsigned int   k = i != 0 && j != 0 ? 0 : (i != 1 && j != 1 ? 1 : 2);
        const unsigned int   l = 6 - i - j - k;
        const LongVectorType edge = LongDifference(p[i], p[j]);
        smallest = std::min(
          smallest, ComputeAngle(Cross(edge, LongDifference(p[i], p[k])), Cross(edge, LongDifference(p[i], p[l]))));
      }
    }
    const double cosine = Geometry::ComputeLargestDihedralCosine(a, b, c, d);
    EXPECT_NEAR(std::acos(cosine) * 180.0 / Pi, smallest, 1e-5);
    EXPECT_NEAR(Geometry::ComputeLargestDihedralCosine(b, a, c, d), cosine, 1e-9);
  }
}

TEST(DelaunayRefinementGeometry, RoundingToFloatIsNotOptimizedAway)
{
  for (const PointType & point : MakeRandomPoints({ { 9e4, -1e5, 1e5 }, { 1e5, -9e4, 2e5 } }, 500, 2))
  {
    const PointType rounded{ Geometry::RoundToFloat(point[0]),
                             Geometry::RoundToFloat(point[1]),
                             Geometry::RoundToFloat(point[2]) };
    EXPECT_EQ(rounded, RoundToFloat(point));
    for (unsigned int i = 0; i < 3; ++i)
    {
      // Floats from 2^16 to 2^18 are multiples of 2^-7.
      EXPECT_EQ(rounded[i] * 128.0, std::floor(rounded[i] * 128.0));
      EXPECT_NEAR(rounded[i], point[i], 1.0 / 128.0);
    }
  }
}
