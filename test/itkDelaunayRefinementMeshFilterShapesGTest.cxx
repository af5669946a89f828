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
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkImageDelaunayRefinementOracle.h"

#include "itkFilterRun.h"
#include "itkOracleChecks.h"

#include "itkBSplineInterpolateImageFunction.h"
#include "itkNearestNeighborInterpolateImageFunction.h"

using namespace itk::DelaunayRefinementTest;

namespace
{
const PointType origin{ 0.0, 0.0, 0.0 };

/** The mesh of a mask has its guarantees and about the volume of the voxels. */
template <typename TImage>
CheckedMesh
MeshMask(const TImage * image, double delta, double volumeTolerance)
{
  const auto filter = MakeFilter(image, delta);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_TRUE(filter->GetStatistics().missingComponents.empty());
  EXPECT_NEAR(ComputeVolume(mesh) / ComputeVoxelVolume(image), 1.0, volumeTolerance);
  return mesh;
}

/** The mesh of grey values is where the shape is. */
template <typename TMesh>
void
ExpectMeshOfShape(const ImageGeometry & geometry, const AnalyticOracle & shape, double delta, double largestDistance)
{
  const auto image = MakeDistanceImage(geometry, shape);
  const auto filter = MakeFilter<TMesh>(image.GetPointer(), delta);
  filter->SetIsoValue(0.0);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  ExpectManifoldBoundary(mesh);
  const BoxType meshBounds = ComputeBoundingBox(mesh.points);
  const auto    shapeBounds = shape.GetSurfaceBounds();
  for (unsigned int i = 0; i < 3; ++i)
  {
    ASSERT_GT(meshBounds.minimum[i], shapeBounds.minimum[i] - delta);
    ASSERT_LT(meshBounds.maximum[i], shapeBounds.maximum[i] + delta);
  }
  EXPECT_NEAR(ComputeVolume(mesh) / shape.ComputeVolume(), 1.0, 0.06);
  EXPECT_LT(ComputeMaximumDistance(SampleBoundary(mesh, delta / 4.0),
                                   [&](const PointType & p) { return std::abs(shape.ComputeSignedDistance(p)); }),
            largestDistance);
  EXPECT_LT(ComputeDistanceToBoundary(SampleSurface(shape, delta / 2.0), mesh), largestDistance);
}
} // namespace

TEST(DelaunayRefinementMeshFilterShapes, Ball)
{
  const BallOracle  ball(origin, 10.0);
  const auto        image = MakeMask(MakeCubeGeometry(24), ball);
  const CheckedMesh mesh = MeshMask(image.GetPointer(), 2.0, 0.05);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(mesh, { 1, 1, 2 });
  EXPECT_LT(Distance(ComputeCentroid(mesh), origin), 0.1);
  EXPECT_LT(ComputeMaximumDistance(SampleBoundary(mesh, 0.5),
                                   [&](const PointType & p) { return std::abs(ball.ComputeSignedDistance(p)); }),
            1.0);
}

TEST(DelaunayRefinementMeshFilterShapes, Torus)
{
  const auto        image = MakeMask(MakeCubeGeometry(32), TorusOracle(origin, 10.0, 4.0));
  const CheckedMesh mesh = MeshMask(image.GetPointer(), 1.5, 0.06);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(mesh, { 1, 1, 0 });
}

TEST(DelaunayRefinementMeshFilterShapes, HollowBall)
{
  const auto        image = MakeMask(MakeCubeGeometry(24), HollowBallOracle(origin, 5.0, 10.0));
  const CheckedMesh mesh = MeshMask(image.GetPointer(), 1.5, 0.03);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(mesh, { 1, 2, 4 });
}

TEST(DelaunayRefinementMeshFilterShapes, TwoBalls)
{
  const auto        image = MakeMask(MakeCubeGeometry(32), TwoBallsOracle(origin, 6.0, 4.0, 3.0));
  const CheckedMesh mesh = MeshMask(image.GetPointer(), 1.5, 0.08);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(mesh, { 2, 2, 4 });
}

TEST(DelaunayRefinementMeshFilterShapes, TouchingBalls)
{
  const auto image = MakeMask(MakeCubeGeometry(30), TwoBallsOracle(origin, 6.5, 4.5, 0.0));
  MeshMask(image.GetPointer(), 1.5, 0.07);
}

TEST(DelaunayRefinementMeshFilterShapes, OneVoxelThickPlate)
{
  const auto image = MakeMask(MakeCubeGeometry(25), PlateOracle(origin, { 9.9, 7.9, 0.4 }));
  MeshMask(image.GetPointer(), 0.7, 0.15);
}

TEST(DelaunayRefinementMeshFilterShapes, ObjectFillsTheImage)
{
  // The image's border closes it half a voxel beyond the outermost centers.
  const auto        image = MakeImage<unsigned char>(MakeCubeGeometry(12), [](const PointType &) { return 1; });
  const CheckedMesh mesh = MeshMask(image.GetPointer(), 1.0, 0.03);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(mesh, { 1, 1, 2 });
  const BoxType bounds = ComputeBoundingBox(mesh.points);
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(bounds.minimum[i], -6.0, 0.1);
    EXPECT_NEAR(bounds.maximum[i], 6.0, 0.1);
  }
}

TEST(DelaunayRefinementMeshFilterShapes, OneVoxelFillsTheImage)
{
  const auto image = MakeImage<unsigned char>(MakeCubeGeometry(1), [](const PointType &) { return 1; });
  const auto filter = MakeFilter(image.GetPointer(), 1.0);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_LT(Distance(ComputeCentroid(mesh), origin), 0.3);
}

TEST(DelaunayRefinementMeshFilterShapes, ObjectTouchesTheBorder)
{
  // Half of the ball is beyond the image.
  ImageGeometry geometry = MakeCubeGeometry(24);
  geometry.size[0] = 12;
  const auto        image = MakeMask(geometry, BallOracle(origin, 9.0));
  const CheckedMesh mesh = MeshMask(image.GetPointer(), 1.5, 0.06);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(mesh, { 1, 1, 2 });
  EXPECT_NEAR(ComputeVolume(mesh) / BallOracle(origin, 9.0).ComputeVolume(), 0.5, 0.03);
}

TEST(DelaunayRefinementMeshFilterShapes, GreyValuesFillTheImage)
{
  // Half a voxel beyond the border the surface is a plane that only rounding moves.
  const auto image = MakeImage<float>(MakeCubeGeometry(24), [](const PointType & point) {
    return 1.1 + 0.3 * std::sin(3.0 * point[0]) + 0.2 * std::sin(5.0 * point[1]) + 0.1 * std::sin(7.0 * point[2]);
  });
  for (const double delta : { 2.0, 1.3, 1.0 })
  {
    SCOPED_TRACE("delta " + std::to_string(delta));
    const auto filter = MakeFilter(image.GetPointer(), delta);
    filter->SetIsoValue(0.1);
    filter->Update();
    ExpectGuarantees(GetMesh(filter.GetPointer()));
  }
}

TEST(DelaunayRefinementMeshFilterShapes, EveryFillingOfABlock)
{
  // Components are 18-connected, and all of them are meshed however large delta is.
  for (const double delta : { 0.6, 2.0 })
  {
    for (unsigned int bits = 1; bits < 256; ++bits)
    {
      SCOPED_TRACE("filling " + std::to_string(bits) + " at delta " + std::to_string(delta));
      const auto image = MakeVoxels(4, MakeFilling(bits, { 1, 1, 1 }));
      const auto filter = MakeFilter(image.GetPointer(), delta);
      filter->Update();
      const CheckedMesh mesh = GetMesh(filter.GetPointer());
      ASSERT_NO_FATAL_FAILURE(ExpectGuarantees(mesh));
      EXPECT_TRUE(filter->GetStatistics().missingComponents.empty());
      const BoxType bounds = ComputeBoundingBox(mesh.points);
      for (unsigned int i = 0; i < 3; ++i)
      {
        EXPECT_GE(bounds.minimum[i], 0.4);
        EXPECT_LE(bounds.maximum[i], 2.6);
      }
    }
  }
}

TEST(DelaunayRefinementMeshFilterShapes, MeshLiesWhereTheImageIs)
{
  const PointType      center{ 25.0, -40.0, 120.0 };
  const TwoBallsOracle balls(center, 5.0, 3.0, 2.0);
  const TorusOracle    torus(center, 7.0, 3.0);
  for (const bool isLeftHanded : { false, true })
  {
    const ImageGeometry geometry = MakeObliqueGeometry(center, isLeftHanded);
    ExpectMeshOfShape<FloatMeshType>(geometry, balls, 0.9, 0.25);
    ExpectMeshOfShape<FloatMeshType>(geometry, torus, 0.9, 0.25);
  }
}

TEST(DelaunayRefinementMeshFilterShapes, CentroidOfAMaskIsItsShapes)
{
  const PointType center{ 25.0, -40.0, 120.0 };
  for (const bool isLeftHanded : { false, true })
  {
    const auto image = MakeMask(MakeObliqueGeometry(center, isLeftHanded), TwoBallsOracle(center, 5.0, 3.0, 2.0));
    const CheckedMesh mesh = MeshMask(image.GetPointer(), 1.0, 0.08);
    ExpectTopology(mesh, { 2, 2, 4 });
    // Balls of radii 5 and 3, with centers 6 to the left and 4 to the right.
    const double offset = (-6.0 * 125.0 + 4.0 * 27.0) / (125.0 + 27.0);
    EXPECT_LT(Distance(ComputeCentroid(mesh), Add(center, PointType{ offset, 0.0, 0.0 })), 0.25);
  }
}

TEST(DelaunayRefinementMeshFilterShapes, FarFromTheOrigin)
{
  const PointType center{ 1e5, -1e5, 1e5 };
  for (const bool isLeftHanded : { false, true })
  {
    const ImageGeometry geometry = MakeObliqueGeometry(center, isLeftHanded);
    ExpectMeshOfShape<FloatMeshType>(geometry, TorusOracle(center, 7.0, 3.0), 0.9, 0.25);
    ExpectMeshOfShape<DoubleMeshType>(geometry, TorusOracle(center, 7.0, 3.0), 0.9, 0.25);
  }
}

TEST(DelaunayRefinementMeshFilterShapes, DeltaIsTinyAgainstTheImage)
{
  // Single precision, in which patches are compared, does not tell places apart here that are delta apart.
  ImageGeometry geometry;
  geometry.size = { { 50000, 4, 4 } };
  const auto image = MakeImage<unsigned char>(geometry, [](const PointType & point) {
    const bool isNearAnEnd = (point[0] > 0.5 && point[0] < 2.5) || (point[0] > 49996.5 && point[0] < 49998.5);
    return isNearAnEnd && std::max(std::abs(point[1] - 1.5), std::abs(point[2] - 1.5)) < 1.0 ? 1 : 0;
  });
  const itk::ImageDelaunayRefinementOracle<itk::Image<unsigned char, 3>> oracle(image, {});
  itk::DelaunayRefinementParameters                                      parameters;
  parameters.delta = 0.05;
  itk::DelaunayRefinementEngine engine(oracle, parameters);
  ASSERT_EQ(engine.Run(), itk::DelaunayRefinementEnums::TerminationReason::COMPLETED);
  EXPECT_GT(engine.TakeResult().tetrahedra.size(), 10000u);
}

TEST(DelaunayRefinementMeshFilterShapes, DeltasDifferGreatly)
{
  const auto image = MakeMask(MakeCubeGeometry(24), BallOracle(origin, 9.0));
  const itk::ImageDelaunayRefinementOracle<itk::Image<unsigned char, 3>> oracle(image, {});
  itk::DelaunayRefinementParameters                                      parameters;
  parameters.delta = 1e6;
  parameters.componentDelta = { 2.0 };
  itk::DelaunayRefinementEngine engine(oracle, parameters);
  ASSERT_EQ(engine.Run(), itk::DelaunayRefinementEnums::TerminationReason::COMPLETED);
  EXPECT_EQ(engine.CountFiringRules()[0], 0u);
  EXPECT_GT(engine.TakeResult().tetrahedra.size(), 200u);
}

TEST(DelaunayRefinementMeshFilterShapes, DoubleCoordinatesAreNotRounded)
{
  const auto image = MakeMask(MakeCubeGeometry(16), BallOracle(origin, 6.0));
  const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), 1.5);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_TRUE(std::any_of(
    mesh.points.begin(), mesh.points.end(), [](const PointType & point) { return point != RoundToFloat(point); }));
}

TEST(DelaunayRefinementMeshFilterShapes, IsoValueIsTheLevel)
{
  const BallOracle ball(origin, 9.0);
  const auto       image = MakeDistanceImage(MakeCubeGeometry(24), ball);
  for (const double level : { -1.0, 0.0, 2.5 })
  {
    const auto filter = MakeFilter(image.GetPointer(), 1.0);
    filter->SetIsoValue(level);
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectLabel(mesh, 1.0);
    EXPECT_NEAR(ComputeVolume(mesh) / BallOracle(origin, 9.0 - level).ComputeVolume(), 1.0, 0.04);
  }
}

TEST(DelaunayRefinementMeshFilterShapes, ThresholdIncludesBothEnds)
{
  // Shells of values by distance: 0 to 3 is the core, 4 to 7 the shell around it.
  const auto image =
    MakeImage<short>(MakeCubeGeometry(22), [](const PointType & point) { return std::floor(Norm(point)) - 4.0; });
  const auto meshOf = [&image](double lower, double upper) {
    const auto filter = MakeFilter(image.GetPointer(), 1.0);
    if (std::isfinite(lower))
    {
      filter->SetLowerThreshold(lower);
    }
    if (std::isfinite(upper))
    {
      filter->SetUpperThreshold(upper);
    }
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectLabel(mesh, 1.0);
    return mesh;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const auto   ballVolume = [](double radius) { return BallOracle(origin, radius).ComputeVolume(); };
  EXPECT_NEAR(ComputeVolume(meshOf(-4.0, -1.0)) / ballVolume(4.0), 1.0, 0.08);
  EXPECT_NEAR(ComputeVolume(meshOf(0.0, 3.0)) / (ballVolume(8.0) - ballVolume(4.0)), 1.0, 0.05);
  EXPECT_NEAR(ComputeVolume(meshOf(-infinity, 3.0)) / ballVolume(8.0), 1.0, 0.05);
  const double whole = 22.0 * 22.0 * 22.0;
  EXPECT_NEAR(ComputeVolume(meshOf(0.0, infinity)) / (whole - ballVolume(4.0)), 1.0, 0.02);
}

TEST(DelaunayRefinementMeshFilterShapes, OtherInterpolators)
{
  const BallOracle ball(origin, 8.0);
  const auto       image = MakeMask<float>(MakeCubeGeometry(20), ball, 1.0f);
  const auto       nearest = itk::NearestNeighborInterpolateImageFunction<FloatImageType, double>::New();
  const auto       spline = itk::BSplineInterpolateImageFunction<FloatImageType, double>::New();
  for (const bool isNearest : { true, false })
  {
    const auto filter = MakeFilter(image.GetPointer(), 1.5);
    filter->SetLowerThreshold(0.5);
    if (isNearest)
    {
      filter->SetInterpolator(nearest);
    }
    else
    {
      filter->SetInterpolator(spline);
    }
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    EXPECT_NEAR(ComputeVolume(mesh) / ball.ComputeVolume(), 1.0, 0.05);
  }
}

TEST(DelaunayRefinementMeshFilterShapes, ParametersReachTheEngine)
{
  const auto image = MakeMask(MakeCubeGeometry(24), BallOracle(origin, 10.0));
  const auto filter = MakeFilter(image.GetPointer(), 3.0);
  filter->SetCellSize(1.5);
  filter->SetRadiusEdgeRatioBound(1.2);
  filter->SetMinimumDihedralAngle(5.0);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh, 1.2);
  EXPECT_LE(ComputeMaximumCircumradius(mesh), 1.5 * (1.0 + 1e-6));
  EXPECT_GE(ComputeDihedralAngles(mesh).minimum, 5.0);
}

TEST(DelaunayRefinementMeshFilterShapes, DefaultDeltaSuitsTheImage)
{
  const auto image = MakeMask(MakeCubeGeometry(24), BallOracle(origin, 10.0));
  const auto filter = MakeFilter(image.GetPointer(), 1.0);
  filter->UnsetDelta();
  filter->Update();
  EXPECT_EQ(filter->GetDelta(), 0.0);
  EXPECT_GT(filter->GetEffectiveDelta(), 0.2);
  EXPECT_LT(filter->GetEffectiveDelta(), 5.0);
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_LT(mesh.tetrahedra.size(), 300000u);
  EXPECT_GT(mesh.tetrahedra.size(), 100u);
}
