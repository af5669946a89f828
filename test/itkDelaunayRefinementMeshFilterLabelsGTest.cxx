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

#include "itkNearestNeighborInterpolateImageFunction.h"

#include <map>
#include <set>

using namespace itk::DelaunayRefinementTest;

namespace
{
constexpr PointType origin{ 0.0, 0.0, 0.0 };

using WideMeshType = itk::Mesh<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double, double, std::uint64_t>>;

/** A ball of radius 13 with three tissues that meet along the z axis. */
short
GetTissue(const PointType & point)
{
  const double angle = std::atan2(point[1], point[0]);
  return Norm(point) > 13.0 ? 0 : angle < -1.0 ? 3 : angle < 1.2 ? 200 : 17;
}

ShortImageType::Pointer
MakeTissues()
{
  return MakeImage<short>(MakeCubeGeometry(30), GetTissue);
}

std::map<double, double>
ComputeVolumes(const CheckedMesh & mesh)
{
  std::map<double, double> volumes;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
  {
    const auto & t = mesh.tetrahedra[i];
    volumes[mesh.tetrahedronLabels[i]] +=
      ComputeTetrahedronVolume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
  }
  return volumes;
}

std::set<double>
GetLabels(const CheckedMesh & mesh)
{
  return { mesh.tetrahedronLabels.begin(), mesh.tetrahedronLabels.end() };
}

/** The area of the triangles between two labels. */
double
ComputeInterfaceArea(const CheckedMesh & mesh, double larger, double smaller)
{
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (mesh.triangleLabels[i] == larger && mesh.triangleOtherLabels[i] == smaller)
    {
      const auto & t = mesh.triangles[i];
      area += 0.5 * static_cast<double>(Norm(Cross(LongDifference(mesh.points[t[1]], mesh.points[t[0]]),
                                                   LongDifference(mesh.points[t[2]], mesh.points[t[0]]))));
    }
  }
  return area;
}

template <typename TMesh = FloatMeshType, typename TImage>
CheckedMesh
MeshOf(const TImage * image, double delta)
{
  const auto filter = MakeFilter<TMesh>(image, delta);
  filter->Update();
  EXPECT_TRUE(filter->GetWarnings().empty());
  EXPECT_TRUE(filter->GetMissingLabels().empty());
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  return mesh;
}

/** Blocks of voxels with a label each. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeBlocks(int blocks, int voxels, const std::function<TPixel(int, int, int)> & label)
{
  ImageGeometry geometry;
  geometry.size.Fill(blocks * voxels + 2);
  return MakeImage<TPixel>(geometry, [&](const PointType & point) {
    std::array<int, 3> block;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const int voxel = static_cast<int>(std::lround(point[i])) - 1;
      if (voxel < 0 || voxel >= blocks * voxels)
      {
        return TPixel{ 0 };
      }
      block[i] = voxel / voxels;
    }
    return label(block[0], block[1], block[2]);
  });
}
} // namespace

TEST(DelaunayRefinementMeshFilterLabels, TissuesShareTheirInterfaces)
{
  const auto  image = MakeTissues();
  CheckedMesh mesh = MeshOf(image.GetPointer(), 1.5);
  const auto  volumes = ComputeVolumes(mesh);
  ASSERT_EQ(volumes.size(), 3u);
  std::map<double, double> voxels;
  for (itk::ImageRegionConstIteratorWithIndex<ShortImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd();
       ++it)
  {
    voxels[it.Get()] += 1.0;
  }
  for (const auto & [label, volume] : volumes)
  {
    EXPECT_NEAR(volume / voxels[label], 1.0, 0.03) << label;
  }
  // Each pair meets in half a disk.
  const double halfDisk = 0.5 * 3.14159 * 13.0 * 13.0;
  EXPECT_NEAR(ComputeInterfaceArea(mesh, 17.0, 3.0) / halfDisk, 1.0, 0.1);
  EXPECT_NEAR(ComputeInterfaceArea(mesh, 200.0, 3.0) / halfDisk, 1.0, 0.1);
  EXPECT_NEAR(ComputeInterfaceArea(mesh, 200.0, 17.0) / halfDisk, 1.0, 0.1);

  // The checks see a wrong label.
  ASSERT_EQ(CountTriangleLabelMismatches(mesh), 0u);
  mesh.tetrahedronLabels.front() = mesh.tetrahedronLabels.front() == 3.0 ? 17.0 : 3.0;
  EXPECT_GT(CountBoundaryMismatches(mesh) + CountTriangleLabelMismatches(mesh), 0u);
}

TEST(DelaunayRefinementMeshFilterLabels, TheOuterBoundaryIsThatOfTheMergedObject)
{
  const auto filter = MakeFilter(MakeTissues().GetPointer(), 2.0);
  filter->Update();
  const CheckedMesh apart = GetMesh(filter.GetPointer());
  filter->MergeLabelsOn();
  filter->Update();
  const CheckedMesh merged = GetMesh(filter.GetPointer());
  ExpectGuarantees(merged);
  ExpectLabel(merged, 1.0);
  EXPECT_NEAR(ComputeVolume(apart) / ComputeVolume(merged), 1.0, 0.01);
  double area = 0.0;
  for (const double label : { 3.0, 17.0, 200.0 })
  {
    area += ComputeInterfaceArea(apart, label, 0.0);
  }
  EXPECT_NEAR(area / ComputeInterfaceArea(merged, 1.0, 0.0), 1.0, 0.03);
}

TEST(DelaunayRefinementMeshFilterLabels, EdgesFollowTheLinesWhereTissuesMeet)
{
  for (const double delta : { 0.9, 1.5, 2.0, 3.0, 4.0 })
  {
    const CheckedMesh mesh = MeshOf(MakeTissues().GetPointer(), delta);

    // Vertices and edges with three labels around them.
    std::vector<std::set<double>>                            labelsOf(mesh.points.size());
    std::map<std::array<std::uint32_t, 2>, std::set<double>> labelsOfEdges;
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
    {
      const auto t = MakeSorted(mesh.tetrahedra[i]);
      for (unsigned int j = 0; j < 4; ++j)
      {
        labelsOf[t[j]].insert(mesh.tetrahedronLabels[i]);
        for (unsigned int k = 0; k < j; ++k)
        {
          labelsOfEdges[{ t[k], t[j] }].insert(mesh.tetrahedronLabels[i]);
        }
      }
    }
    double farthest = 0.0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      if (labelsOf[i].size() == 3)
      {
        farthest = std::max(farthest, std::hypot(mesh.points[i][0], mesh.points[i][1]));
      }
    }
    double length = 0.0;
    for (const auto & [edge, labels] : labelsOfEdges)
    {
      length += labels.size() == 3 ? Distance(mesh.points[edge[0]], mesh.points[edge[1]]) : 0.0;
    }
    // The voxels' steps are half a voxel high.
    EXPECT_LT(farthest, 0.3 * delta + 0.5) << delta;
    EXPECT_GT(length / 26.0, 0.95) << delta;
    EXPECT_LT(length / 26.0, 1.1) << delta;
  }
}

TEST(DelaunayRefinementMeshFilterLabels, ADeltaForALabel)
{
  const auto filter = MakeFilter(MakeTissues().GetPointer(), 3.0);
  filter->SetLabelDelta(17, 1.0);
  EXPECT_EQ(filter->GetLabelDelta(17), 1.0);
  EXPECT_EQ(filter->GetLabelDelta(3), 3.0);
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_TRUE(filter->GetWarnings().empty());
  std::map<double, double> longest;
  std::map<double, double> sum;
  std::map<double, double> number;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto & t = mesh.triangles[i];
    // Boundary of 17, of 3 without 17.
    const double key = mesh.triangleLabels[i] == 17.0 || mesh.triangleOtherLabels[i] == 17.0 ? 17.0 : 3.0;
    sum[key] += Distance(mesh.points[t[0]], mesh.points[t[1]]);
    number[key] += 1.0;
  }
  EXPECT_LT(sum[17.0] / number[17.0], 1.6);
  EXPECT_GT(sum[3.0] / number[3.0], 2.0);

  filter->SetLabelDelta(5, 1.0);
  ExpectError(filter.GetPointer(), { "LabelDelta", "5", "3, 17, 200" });
  filter->UnsetLabelDeltas();
  filter->SetLabelDelta(3, 0.0);
  ExpectError(filter.GetPointer(), { "LabelDelta", "positive" });
}

TEST(DelaunayRefinementMeshFilterLabels, ABallSmoothedIsRound)
{
  const BallOracle ball(origin, 20.0);
  const auto       image = MakeMask(MakeCubeGeometry(48), ball);
  const auto       measure = [&](double width) {
    const auto filter = MakeFilter(image.GetPointer(), 1.0);
    filter->SetSmoothing(width);
    filter->Update();
    EXPECT_TRUE(filter->GetWarnings().empty());
    EXPECT_TRUE(filter->GetLoweredSmoothings().empty());
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectLabel(mesh, 1.0);
    EXPECT_NEAR(ComputeVolume(mesh) / ball.ComputeVolume(), 1.0, 0.02);
    double distance = 0.0;
    double deviation = 0.0;
    double area = 0.0;
    for (const auto & t : mesh.triangles)
    {
      const auto      normal = Cross(LongDifference(mesh.points[t[1]], mesh.points[t[0]]),
                                LongDifference(mesh.points[t[2]], mesh.points[t[0]]));
      const PointType center = Scale(Add(Add(mesh.points[t[0]], mesh.points[t[1]]), mesh.points[t[2]]), 1.0 / 3.0);
      const double    size = static_cast<double>(Norm(normal));
      distance += size * std::abs(Norm(center) - 20.0);
      deviation += size * ComputeAngle(normal, LongDifference(origin, center));
      area += size;
    }
    return std::make_pair(distance / area, deviation / area);
  };
  const auto rough = measure(0.0);
  const auto smooth = measure(0.8);
  EXPECT_LT(smooth.first, 0.5 * rough.first);
  EXPECT_LT(smooth.second, rough.second / 3.0);
}

TEST(DelaunayRefinementMeshFilterLabels, SmoothingKeepsVolumesAndSmallComponents)
{
  // A rod of 2 x 2 voxels and single voxels beside tissues.
  const auto image = MakeTissues();
  for (int z = 8; z < 22; ++z)
  {
    for (int i = 0; i < 4; ++i)
    {
      image->SetPixel({ { 8 + (i & 1), 14 + (i >> 1), z } }, 40);
    }
  }
  image->SetPixel({ { 20, 20, 20 } }, 41);
  const auto volumesOf = [&image](double width, std::size_t numberOfLowered) {
    const auto filter = MakeFilter(image.GetPointer(), 1.0);
    filter->SetSmoothing(width);
    filter->StrictOn();
    filter->Update();
    EXPECT_EQ(filter->GetLoweredSmoothings().size(), numberOfLowered);
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    return ComputeVolumes(mesh);
  };
  const auto rough = volumesOf(0.0, 0);
  const auto smooth = volumesOf(1.0, 2);
  ASSERT_EQ(smooth.size(), 5u);
  for (const double label : { 3.0, 17.0, 200.0 })
  {
    EXPECT_NEAR(smooth.at(label) / rough.at(label), 1.0, 0.02) << label;
  }
  EXPECT_NEAR(smooth.at(40.0) / rough.at(40.0), 1.0, 0.15);
}

TEST(DelaunayRefinementMeshFilterLabels, SmoothedShellsAndObjectsAtTheBorderAreClosed)
{
  // A core in a shell of 8 voxels: far from it the core still has a part in the sum of all weights.
  const auto shell = MakeImage<short>(MakeCubeGeometry(52), [](const PointType & point) {
    const double radius = Norm(point);
    return radius > 22.0 ? 0 : radius > 14.0 ? 2 : 1;
  });
  // A column of two labels through the first and the last slice.
  const auto column = MakeImage<short>(MakeCubeGeometry(28), [](const PointType & point) {
    return std::hypot(point[0], point[1]) > 8.0 ? 0 : point[0] < 0.0 ? 1 : 2;
  });
  for (const auto & image : { shell, column })
  {
    const auto filter = MakeFilter(image.GetPointer(), 1.5);
    filter->SetSmoothing(2.0);
    filter->Update();
    const CheckedMesh apart = GetMesh(filter.GetPointer());
    ExpectGuarantees(apart);
    filter->MergeLabelsOn();
    filter->Update();
    const CheckedMesh merged = GetMesh(filter.GetPointer());
    // Halves are thinner, and may be smoothed by less.
    EXPECT_NEAR(ComputeVolume(apart) / ComputeVolume(merged), 1.0, 0.03);
    EXPECT_NEAR((ComputeInterfaceArea(apart, 1.0, 0.0) + ComputeInterfaceArea(apart, 2.0, 0.0)) /
                  ComputeInterfaceArea(merged, 1.0, 0.0),
                1.0,
                0.02);
  }
}

TEST(DelaunayRefinementMeshFilterLabels, LabelsThatTheMeshWouldStoreWrongly)
{
  using ShortMeshType = itk::Mesh<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double, double, short>>;
  const auto words = MakeBlocks<unsigned short>(2, 4, [](int x, int, int) { return x == 0 ? 1 : 40000; });
  ExpectError(MakeFilter<ShortMeshType>(words.GetPointer(), 1.5).GetPointer(), { "40000", "cell data" });
}

TEST(DelaunayRefinementMeshFilterLabels, SmoothingOfWhatHasNoSteps)
{
  const auto image = MakeTissues();
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  filter->SetSmoothing(-1.0);
  ExpectError(filter.GetPointer(), { "Smoothing" });
  filter->SetSmoothing(std::numeric_limits<double>::quiet_NaN());
  ExpectError(filter.GetPointer(), { "Smoothing" });
  filter->SetSmoothing(7.0);
  ExpectError(filter.GetPointer(), { "Smoothing is 7", "6 times the least spacing" });
  filter->SetSmoothing(1.0);
  filter->SetInterpolator(itk::NearestNeighborInterpolateImageFunction<ShortImageType, double>::New());
  ExpectError(filter.GetPointer(), { "Smoothing", "NearestNeighbor" });
  filter->SetInterpolator(nullptr);
  filter->SetIsoValue(1.0);
  ExpectError(filter.GetPointer(), { "Smoothing", "IsoValue" });
}

TEST(DelaunayRefinementMeshFilterLabels, ChosenLabelsAreTissues)
{
  const auto filter = MakeFilter(MakeTissues().GetPointer(), 1.5);
  filter->SetLabels({ 200, 3 });
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_EQ(GetLabels(mesh), (std::set<double>{ 3.0, 200.0 }));
  EXPECT_EQ(filter->GetRegionLabels(), (std::vector<short>{ 3, 200 }));
  EXPECT_GT(ComputeInterfaceArea(mesh, 200.0, 3.0), 0.0);
}

TEST(DelaunayRefinementMeshFilterLabels, AnyGeometry)
{
  for (const bool isLeftHanded : { false, true })
  {
    const auto        image = MakeImage<short>(MakeObliqueGeometry(origin, isLeftHanded), GetTissue);
    const CheckedMesh mesh = MeshOf(image.GetPointer(), 1.5);
    EXPECT_EQ(GetLabels(mesh), (std::set<double>{ 3.0, 17.0, 200.0 }));
    const double ball = BallOracle(origin, 13.0).ComputeVolume();
    EXPECT_NEAR(ComputeVolume(mesh) / ball, 1.0, 0.03);
  }
}

TEST(DelaunayRefinementMeshFilterLabels, NearestNeighbors)
{
  const auto image = MakeBlocks<short>(2, 4, [](int x, int y, int z) { return 1 + x + 2 * y + 4 * z; });
  const auto filter = MakeFilter(image.GetPointer(), 1.0);
  filter->SetInterpolator(itk::NearestNeighborInterpolateImageFunction<ShortImageType, double>::New());
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  const auto volumes = ComputeVolumes(mesh);
  ASSERT_EQ(volumes.size(), 8u);
  for (const auto & [label, volume] : volumes)
  {
    EXPECT_NEAR(volume / 64.0, 1.0, 0.1) << label;
  }
}

TEST(DelaunayRefinementMeshFilterLabels, ValuesAtTheLimitsOfTheirType)
{
  const auto expectValues = [](const auto * image, const std::set<double> & labels) {
    EXPECT_EQ(GetLabels(MeshOf<WideMeshType>(image, 1.5)), labels);
  };
  const auto bytes = MakeBlocks<unsigned char>(2, 4, [](int x, int, int) { return x == 0 ? 1 : 255; });
  expectValues(bytes.GetPointer(), { 1.0, 255.0 });
  const auto shorts = MakeBlocks<short>(2, 4, [](int x, int, int) { return x == 0 ? 1 : 32767; });
  expectValues(shorts.GetPointer(), { 1.0, 32767.0 });
  const auto words = MakeBlocks<unsigned int>(2, 4, [](int x, int, int) { return x == 0 ? 16777217u : 4294967295u; });
  expectValues(words.GetPointer(), { 16777217.0, 4294967295.0 });

  // Floats would not tell it from its neighbor.
  const auto filter = MakeFilter(words.GetPointer(), 1.5);
  ExpectError(filter.GetPointer(), { "16777217", "cell data" });
}

TEST(DelaunayRefinementMeshFilterLabels, NegativeValuesAreRefused)
{
  const auto image = MakeBlocks<short>(2, 4, [](int x, int, int) { return x == 0 ? 1 : -1; });
  ExpectError(MakeFilter(image.GetPointer(), 1.5).GetPointer(), { "negative" });
}

TEST(DelaunayRefinementMeshFilterLabels, ALabelOfOneVoxelIsMeshedOrNamed)
{
  // A voxel within another label, and one by itself.
  const auto image = MakeBlocks<short>(1, 16, [](int, int, int) { return 7; });
  image->SetPixel({ { 6, 6, 6 } }, 9);
  const auto fine = MakeFilter(image.GetPointer(), 1.0);
  fine->StrictOn();
  fine->Update();
  ExpectGuarantees(GetMesh(fine.GetPointer()));
  EXPECT_EQ(GetLabels(GetMesh(fine.GetPointer())), (std::set<double>{ 7.0, 9.0 }));

  const auto coarse = MakeFilter(image.GetPointer(), 6.0);
  coarse->Update();
  const CheckedMesh mesh = GetMesh(coarse.GetPointer());
  ExpectGuarantees(mesh);
  const bool isThere = GetLabels(mesh).count(9.0) > 0;
  EXPECT_EQ(coarse->GetMissingLabels(), isThere ? std::vector<short>{} : std::vector<short>{ 9 });
  ASSERT_FALSE(isThere) << "a smaller delta was used for a single voxel";
  ASSERT_EQ(coarse->GetWarnings().size(), 2u);
  for (const std::string word : { "1 of 2 labels", "9", "1 mm^3", "6, 6, 6" })
  {
    EXPECT_NE(coarse->GetWarnings()[0].find(word), std::string::npos) << coarse->GetWarnings()[0];
  }
  EXPECT_NE(coarse->GetWarnings()[1].find("label 9 with 1 voxel at (6, 6, 6)"), std::string::npos)
    << coarse->GetWarnings()[1];
  coarse->StrictOn();
  ExpectError(coarse.GetPointer(), { "Strict", "9" });
}

TEST(DelaunayRefinementMeshFilterLabels, SmallTissuesGetASmallerDelta)
{
  // Eight voxels each, far smaller than delta.
  const auto image = MakeBlocks<short>(1, 24, [](int, int, int) { return 1; });
  for (int i = 0; i < 8; ++i)
  {
    image->SetPixel({ { 6 + (i & 1), 6 + (i >> 1 & 1), 6 + (i >> 2) } }, 2);
    image->SetPixel({ { 14 + (i & 1), 15 + (i >> 1 & 1), 16 + (i >> 2) } }, 3);
  }
  const auto filter = MakeFilter(image.GetPointer(), 6.0);
  filter->StrictOn();
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_EQ(GetLabels(mesh), (std::set<double>{ 1.0, 2.0, 3.0 }));
  EXPECT_EQ(filter->GetStatistics().loweredDeltas.size(), 2u);
}

TEST(DelaunayRefinementMeshFilterLabels, LabelsThatTouchInAnEdgeOrACorner)
{
  for (const bool isEdge : { true, false })
  {
    const auto        image = MakeBlocks<short>(2, 4, [isEdge](int x, int y, int z) {
      const bool isDiagonal = isEdge ? x == y : x == y && y == z;
      return static_cast<short>(!isDiagonal || (isEdge && z == 1) ? 0 : x == 0 ? 4 : 8);
    });
    const CheckedMesh mesh = MeshOf(image.GetPointer(), 1.0);
    EXPECT_EQ(GetLabels(mesh), (std::set<double>{ 4.0, 8.0 }));
  }
}

TEST(DelaunayRefinementMeshFilterLabels, ACheckerboardOf343Labels)
{
  // In no order in space.
  const auto label = [](int x, int y, int z) { return static_cast<short>(1 + (x + 7 * y + 49 * z) * 100 % 343); };
  const auto image = MakeBlocks<short>(7, 4, label);
  const CheckedMesh mesh = MeshOf(image.GetPointer(), 1.0);
  const auto        volumes = ComputeVolumes(mesh);
  EXPECT_EQ(volumes.size(), 343u);
  for (const auto & [number, volume] : volumes)
  {
    EXPECT_NEAR(volume / 64.0, 1.0, 0.25) << number;
  }
}

TEST(DelaunayRefinementMeshFilterLabels, TheLargestComponentHasAllItsLabels)
{
  const auto image = MakeBlocks<short>(3, 4, [](int x, int, int) { return static_cast<short>(x == 1 ? 0 : x + 1); });
  // Label 1 gets a neighbor, label 3 a part that is left out with it.
  image->SetPixel({ { 1, 1, 1 } }, 2);
  const auto filter = MakeFilter(image.GetPointer(), 1.0);
  filter->LargestComponentOnlyOn();
  filter->Update();
  const CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  EXPECT_LT(ComputeCentroid(mesh)[0], 6.0);
  EXPECT_EQ(GetLabels(mesh), (std::set<double>{ 1.0, 2.0 }));
  EXPECT_EQ(filter->GetMissingLabels(), (std::vector<short>{ 3 }));
}

TEST(DelaunayRefinementMeshFilterLabels, SameMeshOnAnyNumberOfThreads)
{
  const auto image = MakeTissues();
  const auto meshOn = [&image](unsigned int threads) {
    const auto filter = MakeFilter(image.GetPointer(), 0.8);
    filter->SetNumberOfWorkUnits(threads);
    filter->Update();
    return GetMesh(filter.GetPointer());
  };
  const CheckedMesh one = meshOn(1);
  const CheckedMesh two = meshOn(2);
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.tetrahedra, two.tetrahedra);
  EXPECT_EQ(one.tetrahedronLabels, two.tetrahedronLabels);
  EXPECT_EQ(one.triangles, two.triangles);
  EXPECT_EQ(one.triangleOtherLabels, two.triangleOtherLabels);
}
