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
#include "itkMeshTopologyChecks.h"

#include "itkNearestNeighborInterpolateImageFunction.h"

#include <random>

using namespace itk::DelaunayRefinementTest;

namespace
{
using TopologyType = itk::DelaunayRefinementTopology;

/** Measured on the mesh itself. */
TopologyType
MeasureTopology(const CheckedMesh & mesh)
{
  TopologyType topology;
  topology.isKnown = true;
  topology.components = static_cast<std::int64_t>(CountVolumeComponents(mesh));
  // Each component has one outer piece of boundary, each cavity one.
  topology.cavities = static_cast<std::int64_t>(CountBoundaryComponents(mesh)) - topology.components;
  topology.eulerCharacteristic = ComputeBoundaryEulerCharacteristic(mesh);
  return topology;
}

void
ExpectTopology(const TopologyType & topology, int components, int cavities, int genus)
{
  EXPECT_TRUE(topology.isKnown);
  EXPECT_EQ(topology.components, components);
  EXPECT_EQ(topology.cavities, cavities);
  EXPECT_EQ(topology.GetGenus(), genus);
}

/** Meshes with an expected topology, which the plain run with the same delta misses. */
template <typename TImage>
void
ExpectPreserved(const TImage * image, double delta, int components, int cavities, int genus)
{
  const auto filter = MakeFilter<DoubleMeshType>(image, delta);
  filter->SetNumberOfWorkUnits(2);
  if (std::is_floating_point<typename TImage::PixelType>::value)
  {
    filter->SetIsoValue(0.0);
  }
  filter->Update();
  EXPECT_FALSE(filter->GetStatistics().meshTopology.isKnown);
  const TopologyType plain = MeasureTopology(GetMesh(filter.GetPointer()));
  EXPECT_FALSE(plain.components == components && plain.cavities == cavities && plain.GetGenus() == genus);

  filter->PreserveTopologyOn();
  filter->StrictOn();
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  ExpectManifoldBoundary(mesh);
  ExpectTopology(MeasureTopology(mesh), components, cavities, genus);
  ExpectTopology(filter->GetStatistics().imageTopology, components, cavities, genus);
  ExpectTopology(filter->GetStatistics().meshTopology, components, cavities, genus);
}

/** Voxels of a block that a predicate has. */
template <typename TPredicate>
LabelImageType::Pointer
MakeBlock(int size, const TPredicate & isInside)
{
  std::vector<std::array<int, 3>> voxels;
  for (int z = 1; z < size - 1; ++z)
  {
    for (int y = 1; y < size - 1; ++y)
    {
      for (int x = 1; x < size - 1; ++x)
      {
        if (isInside(x, y, z))
        {
          voxels.push_back({ x, y, z });
        }
      }
    }
  }
  return MakeVoxels(static_cast<itk::SizeValueType>(size), voxels);
}

LabelImageType::Pointer
MakeRandomBlock(unsigned int seed)
{
  std::mt19937 random(seed);
  return MakeBlock(8, [&random](int, int, int) { return random() % 2 == 0; });
}
} // namespace

TEST(DelaunayRefinementMeshFilterTopology, SliverRemovalKeepsIt)
{
  // Coarse meshes of noise have thin parts, tunnels and islands of few tetrahedra.
  std::size_t numberOfMoves = 0;
  std::size_t numberOfSame = 0;
  for (unsigned int seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto image = MakeRandomBlock(seed);
    const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), seed % 2 == 0 ? 1.0 : 1.5);
    filter->Update();
    const auto         isOfR1 = static_cast<std::size_t>(itk::DelaunayRefinementEnums::RefinementRule::R1);
    const std::size_t  insertionsOfR1 = filter->GetStatistics().insertions[isOfR1];
    const TopologyType plain = MeasureTopology(GetMesh(filter.GetPointer()));
    filter->SetMinimumDihedralAngle(15.0);
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectManifoldBoundary(mesh);
    EXPECT_GE(ComputeDihedralAngles(mesh).minimum, 15.0);
    const bool isSame = MeasureTopology(mesh) == plain;
    // R1 may have needed a vertex that can't be had without a change.
    EXPECT_TRUE(isSame || filter->GetStatistics().insertions[isOfR1] > insertionsOfR1);
    numberOfSame += isSame ? 1 : 0;
    numberOfMoves += filter->GetStatistics().movedVertices;
  }
  EXPECT_GE(numberOfSame, 21u);
  EXPECT_GT(numberOfMoves, 100u);
}

TEST(DelaunayRefinementMeshFilterTopology, HandlesAreThere)
{
  // A plate with four narrow holes.
  const auto image = MakeBlock(26, [](int x, int y, int z) {
    const auto isInHole = [](int place) { return place == 8 || place == 17; };
    return z > 9 && z < 16 && !(isInHole(x) && isInHole(y));
  });
  ExpectPreserved(image.GetPointer(), 6.0, 1, 0, 4);
}

TEST(DelaunayRefinementMeshFilterTopology, CavitiesAreThere)
{
  const auto image = MakeBlock(20, [](int x, int y, int z) {
    return !(y == 9 && z == 9 && (x == 5 || x == 10)) && !(x > 12 && x < 16 && y > 3 && y < 7 && z > 11 && z < 14);
  });
  ExpectPreserved(image.GetPointer(), 5.0, 1, 3, 0);
}

TEST(DelaunayRefinementMeshFilterTopology, ComponentsStayApart)
{
  const auto image = MakeBlock(20, [](int x, int, int) { return x % 6 != 0; });
  ExpectPreserved(image.GetPointer(), 6.0, 3, 0, 0);
}

TEST(DelaunayRefinementMeshFilterTopology, GreyShapesToo)
{
  // A ring with a narrow hole.
  const TorusOracle torus({ 0.0, 0.0, 0.0 }, 8.0, 6.8);
  ExpectPreserved(MakeDistanceImage(MakeCubeGeometry(40), torus).GetPointer(), 8.0, 1, 0, 1);
}

TEST(DelaunayRefinementMeshFilterTopology, VoxelsThatTouchInAnEdgeAreJoined)
{
  // Four cubes that edges join to a ring, and one that touches in a corner, and stays apart.
  const auto image = MakeBlock(16, [](int x, int y, int z) {
    const auto isCube = [&](int a, int b, int c) {
      return x >= a && x < a + 3 && y >= b && y < b + 3 && z >= c && z < c + 3;
    };
    return isCube(1, 4, 1) || isCube(4, 1, 1) || isCube(7, 4, 1) || isCube(4, 7, 1) || isCube(10, 7, 4);
  });
  for (const double delta : { 1.0, 3.0 })
  {
    const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), delta);
    filter->PreserveTopologyOn();
    filter->StrictOn();
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectManifoldBoundary(mesh);
    ExpectTopology(MeasureTopology(mesh), 2, 0, 1);
  }
}

TEST(DelaunayRefinementMeshFilterTopology, IsThatOfTheSmoothedObject)
{
  // The smallest cavity is filled by it, the larger one is not.
  const auto image = MakeBlock(20, [](int x, int y, int z) {
    return !(x == 5 && y == 5 && z == 5) && !(x > 9 && x < 15 && y > 9 && y < 15 && z > 9 && z < 15);
  });
  const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), 8.0);
  filter->SetSmoothing(0.8);
  filter->PreserveTopologyOn();
  filter->Update();
  ExpectTopology(filter->GetStatistics().imageTopology, 1, 1, 0);
  ExpectTopology(MeasureTopology(GetMesh(filter.GetPointer())), 1, 1, 0);
}

TEST(DelaunayRefinementMeshFilterTopology, RandomVoxelsHaveTheirTopology)
{
  // Two counts that know nothing of each other: in the image, and on the mesh.
  for (unsigned int seed = 0; seed < 12; ++seed)
  {
    const auto image = MakeRandomBlock(seed);
    const auto filter = MakeFilter<DoubleMeshType>(image.GetPointer(), 2.0);
    filter->PreserveTopologyOn();
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectManifoldBoundary(mesh);
    EXPECT_TRUE(MeasureTopology(mesh) == filter->GetStatistics().imageTopology)
      << seed << ": " << MeasureTopology(mesh) << " instead of " << filter->GetStatistics().imageTopology;
  }
}

TEST(DelaunayRefinementMeshFilterTopology, IsForOneManifoldObject)
{
  const auto image = MakeRandomBlock(1);
  const auto filter = MakeFilter(image.GetPointer(), 1.0);
  filter->PreserveTopologyOn();
  filter->ManifoldOff();
  ExpectError(filter.GetPointer(), { "PreserveTopology", "Manifold" });
  filter->ManifoldOn();
  image->SetPixel({ { 4, 4, 4 } }, 7);
  ExpectError(filter.GetPointer(), { "PreserveTopology", "MergeLabels" });
  filter->MergeLabelsOn();
  EXPECT_EQ(GetError(filter.GetPointer()), "");
  filter->SetInterpolator(itk::NearestNeighborInterpolateImageFunction<LabelImageType, double>::New());
  ExpectError(filter.GetPointer(), { "PreserveTopology", "Interpolator" });
}
