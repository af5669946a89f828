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

#include <random>

using namespace itk::DelaunayRefinementTest;

namespace
{
std::size_t
CountNonManifoldPlaces(const CheckedMesh & mesh)
{
  return CountNonManifoldEdges(mesh) + CountNonManifoldVertices(mesh);
}

/** Voxels set at random touch in edges and corners everywhere. */
LabelImageType::Pointer
MakeRandomVoxels(unsigned int seed)
{
  std::mt19937                    random(seed);
  std::vector<std::array<int, 3>> voxels;
  for (int z = 1; z < 7; ++z)
  {
    for (int y = 1; y < 7; ++y)
    {
      for (int x = 1; x < 7; ++x)
      {
        if (random() % 2 == 0)
        {
          voxels.push_back({ x, y, z });
        }
      }
    }
  }
  return MakeVoxels(8, voxels);
}
} // namespace

TEST(DelaunayRefinementMeshFilterSurface, BoundaryIsAManifoldWhereVoxelsTouch)
{
  std::size_t placesWithout = 0;
  for (const double delta : { 0.7, 1.5, 3.0 })
  {
    for (unsigned int seed = 0; seed < 8; ++seed)
    {
      const auto image = MakeRandomVoxels(seed);
      const auto filter = MakeFilter(image.GetPointer(), delta);
      filter->Update();
      const CheckedMesh mesh = GetMesh(filter.GetPointer());
      ExpectGuarantees(mesh);
      EXPECT_EQ(CountNonManifoldPlaces(mesh), 0u) << delta << ' ' << seed;
      EXPECT_EQ(filter->GetStatistics().nonManifoldVertices, 0u);
      filter->ManifoldOff();
      filter->Update();
      EXPECT_EQ(filter->GetStatistics().changedTetrahedra, 0u);
      placesWithout += CountNonManifoldPlaces(GetMesh(filter.GetPointer()));
    }
  }
  EXPECT_GT(placesWithout, 0u);
}

TEST(DelaunayRefinementMeshFilterSurface, HausdorffBoundIsKept)
{
  // A tube so thin against delta that without a bound much of it is lost.
  const TorusOracle      torus({ 0.0, 0.0, 0.0 }, 10.0, 3.0);
  const auto             image = MakeDistanceImage(CenterAt(MakeCubeGeometry(32), { 0.0, 0.0, 0.0 }), torus);
  std::vector<PointType> samples;
  constexpr double       fullTurn = 6.283185307179586;
  for (unsigned int i = 0; i < 200; ++i)
  {
    for (unsigned int j = 0; j < 60; ++j)
    {
      const double around = fullTurn * i / 200.0;
      const double across = fullTurn * j / 60.0;
      const double radius = 10.0 + 3.0 * std::cos(across);
      samples.push_back({ radius * std::cos(around), radius * std::sin(around), 3.0 * std::sin(across) });
    }
  }
  const auto measure = [&](const CheckedMesh & mesh) {
    const double fromMesh = ComputeMaximumDistance(
      SampleBoundary(mesh, 0.1), [&](const PointType & point) { return std::abs(torus.ComputeSignedDistance(point)); });
    return std::array<double, 2>{ fromMesh, ComputeDistanceToBoundary(samples, mesh) };
  };
  const auto filter = MakeFilter(image.GetPointer(), 8.0);
  filter->SetIsoValue(0.0);
  filter->Update();
  const auto without = measure(GetMesh(filter.GetPointer()));
  EXPECT_GT(std::max(without[0], without[1]), 1.0);
  EXPECT_LT(filter->GetStatistics().meshToSurface.distance, 0.0);

  filter->SetHausdorffBound(0.6);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  ExpectManifoldBoundary(mesh);
  // The interpolated surface differs from the torus by less than this.
  constexpr double interpolation = 0.05;
  const auto       with = measure(mesh);
  EXPECT_LT(with[0], 0.6 + interpolation);
  EXPECT_LT(with[1], 0.6 + interpolation);
  EXPECT_NEAR(filter->GetStatistics().meshToSurface.distance, with[0], 0.06 + interpolation);
  EXPECT_NEAR(filter->GetStatistics().surfaceToMesh.distance, with[1], 0.06 + interpolation);
  for (const std::string & warning : filter->GetWarnings())
  {
    EXPECT_EQ(warning.find("HausdorffBound"), std::string::npos) << warning;
  }
}

TEST(DelaunayRefinementMeshFilterSurface, HausdorffBoundMustBeALength)
{
  const auto image = MakeRandomVoxels(1);
  const auto filter = MakeFilter(image.GetPointer(), 1.0);
  for (const double bound : { -1.0, std::numeric_limits<double>::infinity(), std::nan(""), 0.2 })
  {
    filter->SetHausdorffBound(bound);
    ExpectError(filter.GetPointer(), { "HausdorffBound" });
  }
}
