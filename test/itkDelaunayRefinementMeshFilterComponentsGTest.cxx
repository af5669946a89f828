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

#include <random>
#include <sstream>

using namespace itk::DelaunayRefinementTest;

namespace
{
const PointType origin{ 0.0, 0.0, 0.0 };

LabelImageType::Pointer
MakeTwoBalls()
{
  return MakeMask(MakeCubeGeometry(32), TwoBallsOracle(origin, 6.0, 3.0, 4.0));
}
} // namespace

TEST(DelaunayRefinementMeshFilterComponents, AreDescribed)
{
  const auto image = MakeTwoBalls();
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  filter->Update();
  const auto & components = filter->GetComponents();
  ASSERT_EQ(components.size(), 2u);
  double volume = 0.0;
  for (const auto & component : components)
  {
    EXPECT_DOUBLE_EQ(component.volume, static_cast<double>(component.numberOfVoxels));
    volume += component.volume;
    itk::Index<3>             index;
    LabelImageType::PointType point;
    for (unsigned int i = 0; i < 3; ++i)
    {
      point[i] = component.firstVoxel[i];
    }
    ASSERT_TRUE(image->TransformPhysicalPointToIndex(point, index));
    EXPECT_EQ(image->GetPixel(index), 1);
  }
  EXPECT_DOUBLE_EQ(volume, ComputeVoxelVolume(image.GetPointer()));
  EXPECT_TRUE(filter->GetWarnings().empty());
}

TEST(DelaunayRefinementMeshFilterComponents, LargestOnly)
{
  const auto image = MakeTwoBalls();
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  filter->LargestComponentOnlyOn();
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  ExpectTopology(mesh, { 1, 1, 2 });
  EXPECT_LT(ComputeCentroid(mesh)[0], 0.0);
  EXPECT_NEAR(ComputeVolume(mesh) / BallOracle(origin, 6.0).ComputeVolume(), 1.0, 0.06);

  filter->LargestComponentOnlyOff();
  filter->Update();
  ExpectTopology(GetMesh(filter.GetPointer()), { 2, 2, 4 });
}

TEST(DelaunayRefinementMeshFilterComponents, MinimumSize)
{
  const auto image = MakeTwoBalls();
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  filter->Update();
  const auto & components = filter->GetComponents();
  ASSERT_EQ(components.size(), 2u);
  const auto smaller = std::min(components[0].numberOfVoxels, components[1].numberOfVoxels);
  const auto larger = std::max(components[0].numberOfVoxels, components[1].numberOfVoxels);

  filter->SetMinimumComponentSize(smaller);
  filter->Update();
  ExpectTopology(GetMesh(filter.GetPointer()), { 2, 2, 4 });

  filter->SetMinimumComponentSize(smaller + 1);
  filter->Update();
  ExpectTopology(GetMesh(filter.GetPointer()), { 1, 1, 2 });
  EXPECT_EQ(filter->GetComponents().size(), 1u);

  filter->SetMinimumComponentSize(larger + 1);
  ExpectError(filter.GetPointer(), { "MinimumComponentSize" });
}

TEST(DelaunayRefinementMeshFilterComponents, DeltaIsNotLoweredForAThinTip)
{
  // The first voxels are the tip of a needle that grows out of a block.
  std::vector<std::array<int, 3>> voxels{ { 9, 9, 2 }, { 9, 9, 3 } };
  for (int z = 4; z < 16; ++z)
  {
    for (int y = 3; y < 16; ++y)
    {
      for (int x = 3; x < 16; ++x)
      {
        voxels.push_back({ x, y, z });
      }
    }
  }
  const auto image = MakeVoxels(20, voxels);
  for (const double delta : { 1.0, 2.0 })
  {
    const auto filter = MakeFilter(image.GetPointer(), delta);
    filter->Update();
    EXPECT_TRUE(filter->GetWarnings().empty()) << filter->GetWarnings().front();
    EXPECT_GE(filter->GetComponents().front().inscribedRadius, delta);
  }
}

TEST(DelaunayRefinementMeshFilterComponents, NoneOfEightVoxelsIsLost)
{
  // 27 blocks of 2 x 2 x 2 voxels, a bar and a large block, at a delta larger than all of them.
  std::vector<std::array<int, 3>> voxels;
  std::vector<PointType>          centers;
  for (int z = 0; z < 3; ++z)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int x = 0; x < 3; ++x)
      {
        const auto block = MakeFilling(255, { 2 + 6 * x, 3 + 7 * y, 4 + 8 * z });
        voxels.insert(voxels.end(), block.begin(), block.end());
        centers.push_back({ 2.5 + 6 * x, 3.5 + 7 * y, 4.5 + 8 * z });
      }
    }
  }
  for (int i = 0; i < 8; ++i)
  {
    voxels.push_back({ 20, 10 + i, 27 });
    for (int j = 0; j < 64; ++j)
    {
      voxels.push_back({ 20 + i, 20 + j / 8, 10 + j % 8 });
    }
  }
  centers.push_back({ 20.0, 13.5, 27.0 });
  centers.push_back({ 23.5, 23.5, 13.5 });
  const auto image = MakeVoxels(32, voxels);
  for (const double delta : { 60.0, 4.0, 1.0 })
  {
    const auto filter = MakeFilter(image.GetPointer(), delta);
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    EXPECT_EQ(filter->GetComponents().size(), centers.size());
    EXPECT_GE(CountVolumeComponents(mesh), centers.size());
    EXPECT_TRUE(filter->GetStatistics().missingComponents.empty());
    const PointLocator points(mesh.points);
    for (const PointType & center : centers)
    {
      EXPECT_LT(points.FindDistance(center), 4.5);
    }
    // Where delta was lowered, it is said.
    EXPECT_EQ(filter->GetWarnings().empty(), filter->GetStatistics().loweredDeltas.empty());
    if (delta == 60.0)
    {
      EXPECT_FALSE(filter->GetWarnings().empty());
    }
    EXPECT_EQ(filter->GetEffectiveDelta(), delta);
  }
}

TEST(DelaunayRefinementMeshFilterComponents, SmallOnesAreMeshedOrNamed)
{
  std::vector<std::array<int, 3>> voxels = MakeFilling(255, { 2, 2, 2 });
  voxels.push_back({ 10, 10, 10 });
  voxels.push_back({ 15, 4, 8 });
  voxels.push_back({ 16, 4, 8 });
  const auto image = MakeVoxels(20, voxels);
  for (const double delta : { 0.5, 3.0, 20.0 })
  {
    const auto filter = MakeFilter(image.GetPointer(), delta);
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ASSERT_EQ(filter->GetComponents().size(), 3u);
    const auto &       missing = filter->GetStatistics().missingComponents;
    const PointLocator points(mesh.points);
    for (std::uint32_t i = 0; i < 3; ++i)
    {
      const bool isMissing = std::find(missing.begin(), missing.end(), i) != missing.end();
      EXPECT_EQ(points.FindDistance(filter->GetComponents()[i].firstVoxel) > 2.5, isMissing) << "component " << i;
    }
    std::string warnings;
    for (const std::string & warning : filter->GetWarnings())
    {
      warnings += warning;
    }
    EXPECT_EQ(warnings.find("missing") != std::string::npos, !missing.empty()) << warnings;
    for (const std::uint32_t number : missing)
    {
      const auto &       component = filter->GetComponents()[number];
      std::ostringstream place;
      place << " at (" << component.firstVoxel[0] << ", " << component.firstVoxel[1] << ", " << component.firstVoxel[2];
      EXPECT_NE(warnings.find(place.str()), std::string::npos) << place.str() << " is not in: " << warnings;
    }
  }
}

TEST(DelaunayRefinementMeshFilterComponents, SmallOnesAloneAreMeshed)
{
  // Each may be left out beside larger ones, but not if there is nothing else.
  for (const double delta : { 0.5, 2.0, 20.0 })
  {
    for (const double bound : { 0.0, 1.0 })
    {
      const auto filter = MakeFilter(MakeVoxels(8, { { 4, 4, 4 } }).GetPointer(), delta);
      filter->SetHausdorffBound(bound);
      filter->Update();
      ExpectGuarantees(GetMesh(filter.GetPointer()));
      EXPECT_TRUE(filter->GetStatistics().missingComponents.empty());
    }
    const auto labels = MakeVoxels(12, { { 2, 2, 2 }, { 9, 9, 9 } });
    labels->SetPixel({ { 9, 9, 9 } }, 2);
    const auto filter = MakeFilter(labels.GetPointer(), delta);
    filter->Update();
    ExpectGuarantees(GetMesh(filter.GetPointer()));
    EXPECT_TRUE(filter->GetMissingLabels().empty());
  }
}

TEST(DelaunayRefinementMeshFilterComponents, EachOfManyIsFoundOrNamed)
{
  // A block, and around it more components than bits fit into a word: single voxels and cubes of eight in turn.
  constexpr int                   size = 40;
  std::vector<std::array<int, 3>> voxels;
  const auto                      add = [&voxels](int x, int y, int z, int edge) {
    for (int i = 0; i < edge * edge * edge; ++i)
    {
      voxels.push_back({ x + i % edge, y + i / edge % edge, z + i / (edge * edge) });
    }
  };
  add(2, 2, 20, 18);
  std::size_t numberOfSingles = 0;
  std::size_t numberOfCubes = 0;
  for (int y = 2; y + 4 < size; y += 5)
  {
    for (int x = 2; x + 4 < size; x += 5)
    {
      for (int z = 2; z < 16; z += 5)
      {
        const bool isCube = (x + y + z) % 2 == 0;
        add(x, y, z, isCube ? 2 : 1);
        numberOfCubes += isCube ? 1 : 0;
        numberOfSingles += isCube ? 0 : 1;
      }
    }
  }
  constexpr double delta = 4.0;
  const auto       filter = MakeFilter(MakeVoxels(size, voxels).GetPointer(), delta);
  filter->Update();
  EXPECT_EQ(filter->GetComponents().size(), 1 + numberOfCubes + numberOfSingles);
  EXPECT_GT(numberOfCubes, 64u);
  const auto &       missing = filter->GetStatistics().missingComponents;
  const PointLocator points(GetMesh(filter.GetPointer()).points);
  for (std::uint32_t i = 0; i < filter->GetComponents().size(); ++i)
  {
    const bool isMissing = std::find(missing.begin(), missing.end(), i) != missing.end();
    // A corner of the block may be as far as delta from all points.
    const auto & component = filter->GetComponents()[i];
    const double nearby = component.numberOfVoxels > 8 ? delta : 2.0;
    EXPECT_EQ(points.FindDistance(component.firstVoxel) > nearby, isMissing) << "component " << i;
  }
  EXPECT_GT(missing.size(), 0u);
  EXPECT_LE(missing.size(), numberOfSingles);
}

TEST(DelaunayRefinementMeshFilterComponents, VoxelsThatShareAnEdgeAreOne)
{
  const auto atEdge = MakeVoxels(5, { { 1, 1, 1 }, { 2, 2, 1 } });
  const auto atCorner = MakeVoxels(5, { { 1, 1, 1 }, { 2, 2, 2 } });
  const auto countComponents = [](const LabelImageType * image) {
    const auto filter = MakeFilter(image, 0.7);
    filter->Update();
    return filter->GetComponents().size();
  };
  EXPECT_EQ(countComponents(atEdge), 1u);
  EXPECT_EQ(countComponents(atCorner), 2u);
}

TEST(DelaunayRefinementMeshFilterComponents, CavitiesAreWhatNoWayLeadsOutOf)
{
  constexpr int size = 16;
  std::mt19937  random(2);
  for (const unsigned int percentInside : { 60u, 80u, 95u })
  {
    SCOPED_TRACE(percentInside);
    std::vector<std::array<int, 3>> voxels;
    std::vector<int>                state(size * size * size, 0); // 1 inside, 2 has a way out
    const auto at = [&state](int x, int y, int z) -> int & { return state[(z * size + y) * size + x]; };
    for (int i = 0; i < size * size * size; ++i)
    {
      if (random() % 100 < percentInside)
      {
        state[i] = 1;
        voxels.push_back({ i % size, i / size % size, i / (size * size) });
      }
    }
    // By going over all voxels until nothing changes.
    for (bool isChanged = true; isChanged;)
    {
      isChanged = false;
      for (int i = 0; i < size * size * size; ++i)
      {
        const int  x = i % size;
        const int  y = i / size % size;
        const int  z = i / (size * size);
        const bool isBorder = std::min({ x, y, z }) == 0 || std::max({ x, y, z }) == size - 1;
        if (state[i] == 0 && (isBorder || at(x - 1, y, z) == 2 || at(x + 1, y, z) == 2 || at(x, y - 1, z) == 2 ||
                              at(x, y + 1, z) == 2 || at(x, y, z - 1) == 2 || at(x, y, z + 1) == 2))
        {
          state[i] = 2;
          isChanged = true;
        }
      }
    }
    const auto enclosed = static_cast<std::size_t>(std::count(state.begin(), state.end(), 0));
    const auto filter = MakeFilter(MakeVoxels(size, voxels).GetPointer(), 4.0);
    filter->Update();
    std::size_t numberOfVoxels = 0;
    for (const auto & cavity : filter->GetCavities())
    {
      numberOfVoxels += cavity.numberOfVoxels;
      EXPECT_EQ(cavity.volume, static_cast<double>(cavity.numberOfVoxels));
      const auto & place = cavity.firstVoxel;
      EXPECT_EQ(at(static_cast<int>(place[0]), static_cast<int>(place[1]), static_cast<int>(place[2])), 0);
    }
    EXPECT_EQ(numberOfVoxels, enclosed);
    EXPECT_GT(filter->GetCavities().size(), 10u);
  }
}

TEST(DelaunayRefinementMeshFilterComponents, CavitiesAreFoundOrNamed)
{
  // A block with a cavity of 216 voxels, one of 8, and one of a single voxel.
  constexpr int                   size = 30;
  std::vector<std::array<int, 3>> voxels;
  const auto                      isIn = [](int i, int first, int edge) { return i >= first && i < first + edge; };
  for (int i = 0; i < size * size * size; ++i)
  {
    const int  x = i % size;
    const int  y = i / size % size;
    const int  z = i / (size * size);
    const auto isInCube = [&](int first, int edge) {
      return isIn(x, first, edge) && isIn(y, first, edge) && isIn(z, first, edge);
    };
    if (isInCube(2, 26) && !isInCube(5, 6) && !isInCube(16, 2) && !isInCube(23, 1))
    {
      voxels.push_back({ x, y, z });
    }
  }
  for (const double delta : { 0.5, 2.0, 3.0 })
  {
    SCOPED_TRACE(delta);
    const auto filter = MakeFilter(MakeVoxels(size, voxels).GetPointer(), delta);
    filter->Update();
    ASSERT_EQ(filter->GetCavities().size(), 3u);
    const auto &      missing = filter->GetStatistics().missingCavities;
    const std::size_t found = 3 - missing.size();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectTopology(mesh, { 1, 1 + found, 2 * static_cast<int>(1 + found) });
    std::string warnings;
    for (const std::string & warning : filter->GetWarnings())
    {
      warnings += warning;
    }
    const bool isSingleMissing = std::find(missing.begin(), missing.end(), 2u) != missing.end();
    EXPECT_EQ(warnings.find("1 voxel at (23, 23, 23)") != std::string::npos, isSingleMissing) << warnings;
    filter->StrictOn();
    if (missing.empty())
    {
      filter->Update();
    }
    else
    {
      ExpectError(filter.GetPointer(), { "Strict", "cavit" });
    }
    EXPECT_LT(missing.size(), 3u);
    EXPECT_EQ(missing.empty(), delta < 2.0);
  }
}

TEST(DelaunayRefinementMeshFilterComponents, ACavityAtTheOriginIsNamedAsAnyOther)
{
  const auto image =
    MakeImage<unsigned char>(MakeCubeGeometry(33), [](const PointType & point) { return Norm(point) < 12.0 ? 1 : 0; });
  image->SetPixel({ { 16, 16, 16 } }, 0);
  const auto filter = MakeFilter(image.GetPointer(), 6.0);
  filter->Update();
  ASSERT_EQ(filter->GetCavities().size(), 1u);
  EXPECT_EQ(Norm(filter->GetCavities()[0].firstVoxel), 0.0);
  ExpectTopology(GetMesh(filter.GetPointer()), { 1, 1, 2 });
  EXPECT_EQ(filter->GetStatistics().missingCavities.size(), 1u);
}
