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

#include "itkDelaunayRefinementMeshFilter.h"

#include "itkFilterRun.h"
#include "itkMeshDistanceChecks.h"
#include "itkMeshTopologyChecks.h"

using namespace itk::DelaunayRefinementTest;

namespace
{
const PointType origin{ 0.0, 0.0, 0.0 };

using SizeFieldType = itk::Image<float, 3>;

/** Lengths on a grid that is not that of the image: 2 at one end of a ball of radius 12, growing to 7 at the other. */
double
ComputeSize(const PointType & point)
{
  return 2.0 + 0.2 * (point[0] + 13.0);
}

SizeFieldType::Pointer
MakeSizeField()
{
  return MakeImage<float>(MakeObliqueGeometry(origin, true), [](const PointType & point) {
    return static_cast<float>(std::max(2.0, ComputeSize(point)));
  });
}

/** The longest edges of the boundary triangles with their first vertex in a range of x. */
double
ComputeMeanLongestEdge(const CheckedMesh & mesh, double low, double high)
{
  double      sum = 0.0;
  std::size_t number = 0;
  for (const auto & triangle : mesh.triangles)
  {
    if (low <= mesh.points[triangle[0]][0] && mesh.points[triangle[0]][0] <= high)
    {
      double longest = 0.0;
      for (unsigned int i = 0; i < 3; ++i)
      {
        longest = std::max(longest, Distance(mesh.points[triangle[i]], mesh.points[triangle[(i + 1) % 3]]));
      }
      sum += longest;
      ++number;
    }
  }
  return sum / static_cast<double>(number);
}
} // namespace

TEST(DelaunayRefinementMeshFilterSizes, SizeFieldBoundsDelta)
{
  const auto image = MakeMask(MakeCubeGeometry(32), BallOracle(origin, 12.0));
  const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), 6.0);
  filter->Update();
  const CheckedMesh plain = GetMesh(filter.GetPointer());
  const auto        field = MakeSizeField();
  filter->SetSizeField(field);
  filter->Update();
  EXPECT_EQ(filter->GetEffectiveDelta(), 6.0);
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  ExpectManifoldBoundary(mesh);
  EXPECT_NEAR(ComputeMeanLongestEdge(plain, -13.0, -8.0), ComputeMeanLongestEdge(plain, 8.0, 13.0), 1.5);
  EXPECT_LT(1.6 * ComputeMeanLongestEdge(mesh, -13.0, -8.0), ComputeMeanLongestEdge(mesh, 8.0, 13.0));

  // Every boundary vertex on the sphere has another one so near as the field asks for.
  std::vector<PointType> vertices;
  for (const auto & triangle : mesh.triangles)
  {
    for (const std::uint32_t vertex : triangle)
    {
      vertices.push_back(mesh.points[vertex]);
    }
  }
  for (const auto & triangle : mesh.triangles)
  {
    const PointType & a = mesh.points[triangle[0]];
    const PointType & b = mesh.points[triangle[1]];
    const PointType & c = mesh.points[triangle[2]];
    const PointType   middle{ (a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0, (a[2] + b[2] + c[2]) / 3.0 };
    double            nearest = std::numeric_limits<double>::infinity();
    for (const PointType & vertex : vertices)
    {
      nearest = std::min(nearest, Distance(middle, vertex));
    }
    // The field's own steps and the chord's distance from the sphere make a little more.
    EXPECT_LT(nearest, 1.25 * std::min(6.0, ComputeSize(middle)) + 0.5);
  }
}

TEST(DelaunayRefinementMeshFilterSizes, ASheetOfSmallSizesIsSeen)
{
  const auto image = MakeMask(MakeCubeGeometry(32), BallOracle(origin, 12.0));
  const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), 8.0);
  filter->Update();
  const std::size_t plain = filter->GetOutput()->GetNumberOfCells();
  for (const double shift : { 0.0, 0.3, 0.5, 0.8 })
  {
    // One pixel thick.
    auto geometry = MakeCubeGeometry(40);
    geometry.origin[0] += shift;
    const auto field = MakeImage<float>(
      geometry, [shift](const PointType & point) { return std::abs(point[0] - shift - 0.5) < 0.1 ? 1.0f : 8.0f; });
    filter->SetSizeField(field);
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 20 * plain) << shift;
  }
}

TEST(DelaunayRefinementMeshFilterSizes, SizeFieldLiesWhereTheObjectIs)
{
  const auto image = MakeMask(MakeCubeGeometry(32), BallOracle(origin, 12.0));
  const auto filter = MakeFilter(image.GetPointer(), 8.0);
  const auto elsewhere = CenterAt(MakeCubeGeometry(32), { 0.0, 500.0, 0.0 });
  filter->SetSizeField(MakeImage<float>(elsewhere, [](const PointType &) { return 2.0f; }));
  ExpectError(filter.GetPointer(), { "SizeField", "origin" });
}

TEST(DelaunayRefinementMeshFilterSizes, ACoarseSizeFieldLeavesOtherBoundsLocal)
{
  // Large pixels of a length that changes nothing.
  const TorusOracle torus({ 0.0, 0.0, 0.0 }, 10.0, 3.0);
  const auto filter = MakeFilter<DoubleMeshType>(MakeDistanceImage(MakeCubeGeometry(32), torus).GetPointer(), 8.0);
  filter->SetIsoValue(0.0);
  filter->SetHausdorffBound(0.6);
  filter->Update();
  const std::size_t without = filter->GetOutput()->GetNumberOfCells();
  auto              geometry = MakeCubeGeometry(2);
  geometry.spacing.Fill(40.0);
  filter->SetSizeField(MakeImage<float>(CenterAt(geometry, origin), [](const PointType &) { return 8.0f; }));
  filter->Update();
  EXPECT_LT(filter->GetOutput()->GetNumberOfCells(), 2 * without);
}

TEST(DelaunayRefinementMeshFilterSizes, MinimumDeltaLeavesTheHausdorffBoundInForce)
{
  // Lengths that single precision rounds up.
  const TorusOracle torus({ 0.0, 0.0, 0.0 }, 10.0, 3.0);
  const auto filter = MakeFilter<DoubleMeshType>(MakeDistanceImage(MakeCubeGeometry(32), torus).GetPointer(), 6.0);
  filter->SetIsoValue(0.0);
  filter->SetHausdorffBound(0.5);
  for (const double least : { 2.2, 2.4, 2.7, 4.1 })
  {
    filter->SetMinimumDelta(least);
    filter->Update();
    EXPECT_LT(filter->GetStatistics().meshToSurface.distance, 0.5) << least;
    EXPECT_LT(filter->GetStatistics().surfaceToMesh.distance, 0.5) << least;
  }
}

TEST(DelaunayRefinementMeshFilterSizes, GreatestSizeIsTheDefaultDelta)
{
  const auto image = MakeMask(MakeCubeGeometry(32), BallOracle(origin, 12.0));
  const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), 1.0);
  const auto field = MakeImage<float>(MakeCubeGeometry(32), [](const PointType &) { return 4.0f; });
  filter->UnsetDelta();
  filter->SetSizeField(field);
  filter->Update();
  EXPECT_EQ(filter->GetEffectiveDelta(), 4.0);
  // The same everywhere: as if it were Delta.
  const auto other = MakeFilter<DoubleMeshType>(image.GetPointer(), 4.0);
  other->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfCells()),
              static_cast<double>(other->GetOutput()->GetNumberOfCells()),
              0.2 * static_cast<double>(other->GetOutput()->GetNumberOfCells()));
}

TEST(DelaunayRefinementMeshFilterSizes, SizesMustBeLengths)
{
  const auto image = MakeMask(MakeCubeGeometry(32), BallOracle(origin, 12.0));
  const auto filter = MakeFilter(image.GetPointer(), 4.0);
  for (const float wrong : { 0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::nanf("") })
  {
    const auto field = MakeSizeField();
    field->SetPixel({ { 1, 12, 4 } }, wrong);
    filter->SetSizeField(field);
    ExpectError(filter.GetPointer(), { "SizeField", "(1, 12, 4)" });
  }
  const auto tiny = MakeImage<float>(MakeCubeGeometry(32), [](const PointType &) { return 1e-4f; });
  filter->SetSizeField(tiny);
  ExpectError(filter.GetPointer(), { "memory" });
  filter->SetSizeField(nullptr);
  EXPECT_EQ(GetError(filter.GetPointer()), "");
}

TEST(DelaunayRefinementMeshFilterSizes, MinimumDeltaIsForBends)
{
  // An ellipsoid five times as long as wide, with its ends at x = -25 and 25.
  const auto image = MakeImage<float>(MakeCubeGeometry(60), [](const PointType & point) {
    return static_cast<float>(5.0 - std::sqrt(0.04 * point[0] * point[0] + point[1] * point[1] + point[2] * point[2]));
  });
  const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), 5.0);
  filter->SetIsoValue(0.0);
  filter->SetMinimumDelta(0.5);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  ExpectManifoldBoundary(mesh);
  EXPECT_LT(1.5 * ComputeMeanLongestEdge(mesh, 22.0, 26.0), ComputeMeanLongestEdge(mesh, -5.0, 5.0));
  const auto & statistics = filter->GetStatistics();
  EXPECT_GT(statistics.meshToSurface.distance, 0.0);
  EXPECT_LT(statistics.meshToSurface.distance, 0.15 * 5.0);
  EXPECT_LT(statistics.surfaceToMesh.distance, 0.15 * 5.0);
}

TEST(DelaunayRefinementMeshFilterSizes, MinimumDeltaMustBeALengthUpToDelta)
{
  const auto image = MakeMask(MakeCubeGeometry(32), BallOracle(origin, 12.0));
  const auto filter = MakeFilter(image.GetPointer(), 4.0);
  for (const double wrong : { -1.0, std::numeric_limits<double>::infinity(), std::nan(""), 4.5 })
  {
    filter->SetMinimumDelta(wrong);
    ExpectError(filter.GetPointer(), { "MinimumDelta" });
  }
  filter->SetMinimumDelta(4.0);
  EXPECT_EQ(GetError(filter.GetPointer()), "");
}
