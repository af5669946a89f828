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

#include "itkBinaryThresholdImageFilter.h"
#include "itkCommand.h"
#include "itkTetrahedronCell.h"

#include <fstream>
#include <functional>
#include <memory>
#include <regex>
#include <sstream>
#include <thread>

// Compiles every member.
template class itk::DelaunayRefinementMeshFilter<itk::Image<short, 3>, itk::Mesh<float, 3>>;

using namespace itk::DelaunayRefinementTest;

namespace
{
const PointType origin{ 0.0, 0.0, 0.0 };

using LabelFilterType = itk::DelaunayRefinementMeshFilter<LabelImageType, FloatMeshType>;

LabelImageType::Pointer
MakeBall(unsigned char label = 1)
{
  return MakeMask<unsigned char>(MakeCubeGeometry(24), BallOracle(origin, 10.0), label);
}

/** Counts how often the filter does its work. */
template <typename TFilter>
std::shared_ptr<unsigned int>
CountRuns(TFilter * filter)
{
  auto count = std::make_shared<unsigned int>(0);
  filter->AddObserver(itk::StartEvent(), [count](const itk::EventObject &) { ++*count; });
  return count;
}
} // namespace

TEST(DelaunayRefinementMeshFilter, Defaults)
{
  const auto filter = LabelFilterType::New();
  EXPECT_STREQ(filter->GetNameOfClass(), "DelaunayRefinementMeshFilter");
  EXPECT_EQ(filter->GetDelta(), 0.0);
  EXPECT_EQ(filter->GetRadiusEdgeRatioBound(), 2.0);
  EXPECT_EQ(filter->GetCellSize(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(filter->GetMinimumDihedralAngle(), 0.0);
  EXPECT_FALSE(filter->GetPaperSlivers());
  EXPECT_FALSE(filter->GetRefineOutside());
  EXPECT_TRUE(filter->GetManifold());
  EXPECT_EQ(filter->GetHausdorffBound(), 0.0);
  EXPECT_FALSE(filter->GetPreserveTopology());
  EXPECT_EQ(filter->GetMinimumDelta(), 0.0);
  EXPECT_EQ(filter->GetSizeField(), nullptr);
  EXPECT_EQ(filter->GetMaximumNumberOfVertices(), itk::NumericTraits<itk::SizeValueType>::max());
  EXPECT_TRUE(filter->GetLabels().empty());
  EXPECT_EQ(filter->GetLowerThreshold(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(filter->GetUpperThreshold(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(filter->GetMergeLabels());
  EXPECT_FALSE(filter->GetLargestComponentOnly());
  EXPECT_EQ(filter->GetMinimumComponentSize(), 1u);
  EXPECT_STREQ(filter->GetModifiableInterpolator()->GetNameOfClass(), "LinearInterpolateImageFunction");
  EXPECT_EQ(filter->GetEffectiveDelta(), 0.0);
  EXPECT_TRUE(filter->GetComponents().empty());
  EXPECT_TRUE(filter->GetWarnings().empty());
  ASSERT_NE(filter->GetOutput(), nullptr);
  ASSERT_NE(filter->GetBoundaryOutput(), nullptr);
}

TEST(DelaunayRefinementMeshFilter, PrintsEveryMember)
{
  const auto filter = LabelFilterType::New();
  filter->SetDelta(1.25);
  filter->SetLabels({ 3, 200 });
  std::ostringstream text;
  filter->Print(text);
  for (const char * const line : { "\n  Delta: 1.25\n",
                                   "\n  CellSize: inf\n",
                                   "\n  LowerThreshold: -inf\n",
                                   "\n  Labels: 3 200\n",
                                   "\n  MergeLabels: Off\n",
                                   "NO_SURFACE_FOUND; insertions" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }

  // Each member of the class, in the order of its declaration.
  std::ifstream     file(MESH_FILTER_HEADER);
  const std::string header{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  const std::regex  declaration(" m_(\\w+)\\{");
  std::size_t       numberOfMembers = 0;
  std::size_t       position = 0;
  for (std::sregex_iterator it(header.begin(), header.end(), declaration); it != std::sregex_iterator(); ++it)
  {
    const std::string name = (*it)[1];
    const std::size_t found = text.str().find("\n  " + name + ":", position);
    ASSERT_NE(found, std::string::npos) << name << " is not printed, or not in its place";
    position = found;
    ++numberOfMembers;
  }
  EXPECT_GT(numberOfMembers, 20u);
}

TEST(DelaunayRefinementMeshFilter, SettersModifyOnlyWhenTheyChange)
{
  const auto filter = LabelFilterType::New();
  const auto expectModified = [&filter](const std::function<void()> & set) {
    auto before = filter->GetMTime();
    set();
    EXPECT_GT(filter->GetMTime(), before);
    before = filter->GetMTime();
    set();
    EXPECT_EQ(filter->GetMTime(), before);
  };
  expectModified([&] { filter->SetDelta(0.0); });
  expectModified([&] { filter->SetDelta(2.0); });
  expectModified([&] { filter->UnsetDelta(); });
  expectModified([&] { filter->SetIsoValue(0.0); });
  expectModified([&] { filter->SetLowerThreshold(-std::numeric_limits<double>::infinity()); });
  expectModified([&] { filter->SetUpperThreshold(4.0); });
  expectModified([&] { filter->SetLabels({ 1, 2 }); });
  expectModified([&] { filter->SetCellSize(4.0); });
  expectModified([&] { filter->RefineOutsideOn(); });
  expectModified([&] { filter->ManifoldOff(); });
  expectModified([&] { filter->SetHausdorffBound(1.0); });
  expectModified([&] { filter->PreserveTopologyOn(); });
  expectModified([&] { filter->SetMinimumDelta(1.0); });
  const auto field = itk::Image<float, 3>::New();
  expectModified([&] { filter->SetSizeField(field); });
  expectModified([&] { filter->SetMergeLabels(true); });
}

TEST(DelaunayRefinementMeshFilter, CellDataIsTheLabel)
{
  const auto image = MakeBall(7);
  const auto filter = MakeFilter(image.GetPointer(), 3.0);
  filter->Update();
  ExpectLabel(GetMesh(filter.GetPointer()), 7.0);
  filter->SetLabels({ 7 });
  filter->Update();
  ExpectLabel(GetMesh(filter.GetPointer()), 7.0);
  filter->MergeLabelsOn();
  filter->Update();
  ExpectLabel(GetMesh(filter.GetPointer()), 1.0);
  filter->MergeLabelsOff();
  filter->UnsetObjectDefinition();
  filter->SetLowerThreshold(7.0);
  filter->Update();
  ExpectLabel(GetMesh(filter.GetPointer()), 1.0);
  filter->UnsetObjectDefinition();
  filter->SetIsoValue(3.5);
  filter->Update();
  ExpectLabel(GetMesh(filter.GetPointer()), 1.0);
}

TEST(DelaunayRefinementMeshFilter, ChosenLabelsAreMeshed)
{
  // Label 5 is the left half of a ball, 300 the right half, 2 a layer around it.
  const auto image = MakeImage<short>(MakeCubeGeometry(28), [](const PointType & point) {
    const double radius = Norm(point);
    return radius > 12.0 ? 0 : (radius > 10.0 ? 2 : (point[0] < 0.0 ? 5 : 300));
  });
  const auto meshOf = [&image](const std::vector<short> & labels) {
    const auto filter = MakeFilter(image.GetPointer(), 2.0);
    filter->SetLabels(labels);
    filter->SetMergeLabels(labels.size() != 1);
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectLabel(mesh, labels.size() == 1 ? labels.front() : 1.0);
    return mesh;
  };
  const auto ballVolume = [](double radius) { return BallOracle(origin, radius).ComputeVolume(); };
  EXPECT_NEAR(ComputeVolume(meshOf({ 300 })) / ballVolume(10.0), 0.5, 0.03);
  EXPECT_GT(ComputeCentroid(meshOf({ 300 }))[0], 3.0);
  EXPECT_LT(ComputeCentroid(meshOf({ 5 }))[0], -3.0);
  EXPECT_NEAR(ComputeVolume(meshOf({ 300, 5, 300 })) / ballVolume(10.0), 1.0, 0.05);
  EXPECT_NEAR(ComputeVolume(meshOf({})) / ballVolume(12.0), 1.0, 0.05);
  EXPECT_NEAR(ComputeVolume(meshOf({ 2 })) / (ballVolume(12.0) - ballVolume(10.0)), 1.0, 0.1);
}

TEST(DelaunayRefinementMeshFilter, RunsAgainOnlyAfterAChange)
{
  const auto image = MakeBall();
  const auto filter = MakeFilter(image.GetPointer(), 3.0);
  const auto count = CountRuns(filter.GetPointer());
  filter->Update();
  const CheckedMesh coarse = GetMesh(filter.GetPointer());
  filter->Update();
  filter->SetDelta(3.0);
  filter->Update();
  EXPECT_EQ(*count, 1u);

  filter->SetDelta(2.0);
  filter->Update();
  EXPECT_EQ(*count, 2u);
  const CheckedMesh fine = GetMesh(filter.GetPointer());
  ExpectGuarantees(fine);
  EXPECT_GT(fine.tetrahedra.size(), coarse.tetrahedra.size());

  filter->SetDelta(3.0);
  filter->Update();
  EXPECT_TRUE(GetMesh(filter.GetPointer()).points == coarse.points);

  // Another input, and the first one changed.
  const auto torus = MakeMask(MakeCubeGeometry(32), TorusOracle(origin, 10.0, 4.0));
  filter->SetInput(torus);
  filter->SetDelta(1.5);
  filter->Update();
  ExpectTopology(GetMesh(filter.GetPointer()), { 1, 1, 0 });
  torus->FillBuffer(0);
  torus->SetPixel({ { 16, 16, 16 } }, 1);
  torus->Modified();
  filter->Update();
  EXPECT_LT(ComputeVolume(GetMesh(filter.GetPointer())), 1.0);
  EXPECT_EQ(filter->GetComponents().size(), 1u);
}

TEST(DelaunayRefinementMeshFilter, EqualRunsMakeEqualMeshes)
{
  const auto image = MakeBall();
  const auto meshOf = [&image] {
    const auto filter = MakeFilter(image.GetPointer(), 1.5);
    filter->Update();
    return GetMesh(filter.GetPointer());
  };
  const CheckedMesh one = meshOf();
  const CheckedMesh two = meshOf();
  EXPECT_TRUE(one.points == two.points);
  EXPECT_TRUE(one.tetrahedra == two.tetrahedra);
  EXPECT_TRUE(one.triangles == two.triangles);
}

TEST(DelaunayRefinementMeshFilter, TwoRunInTwoThreads)
{
  const auto                 image = MakeBall();
  const auto                 torus = MakeMask(MakeCubeGeometry(32), TorusOracle(origin, 10.0, 4.0));
  const LabelImageType *     images[] = { image, torus };
  std::array<CheckedMesh, 2> alone;
  std::array<CheckedMesh, 2> together;
  const auto                 run = [&images](unsigned int i, std::array<CheckedMesh, 2> & meshes) {
    const auto filter = MakeFilter(images[i], 1.5);
    filter->Update();
    meshes[i] = GetMesh(filter.GetPointer());
  };
  run(0, alone);
  run(1, alone);
  std::thread first([&] { run(0, together); });
  std::thread second([&] { run(1, together); });
  first.join();
  second.join();
  for (unsigned int i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(together[i].points == alone[i].points);
    EXPECT_TRUE(together[i].tetrahedra == alone[i].tetrahedra);
  }
}

TEST(DelaunayRefinementMeshFilter, ProgressGrows)
{
  const auto         image = MakeBall();
  const auto         filter = MakeFilter(image.GetPointer(), 1.0);
  std::vector<float> shares;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { shares.push_back(filter->GetProgress()); });
  filter->Update();
  ASSERT_GT(shares.size(), 3u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0.0f);
  EXPECT_FLOAT_EQ(shares.back(), 1.0f);
}

TEST(DelaunayRefinementMeshFilter, AbortEndsTheRunAndTheFilterIsUsableAgain)
{
  const auto    image = MakeBall();
  const auto    filter = MakeFilter(image.GetPointer(), 0.8);
  unsigned int  numberOfEvents = 0;
  unsigned long aborts = 0;
  const auto    tag = filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (++numberOfEvents == 3)
    {
      filter->AbortGenerateDataOn();
    }
  });
  filter->AddObserver(itk::AbortEvent(), [&aborts](const itk::EventObject &) { ++aborts; });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
  EXPECT_EQ(aborts, 1u);
  EXPECT_EQ(numberOfEvents, 3u);
  EXPECT_EQ(filter->GetStatistics().terminationReason,
            itk::DelaunayRefinementEnums::TerminationReason::STOPPED_BY_CALLER);

  filter->RemoveObserver(tag);
  filter->Update();
  ExpectGuarantees(GetMesh(filter.GetPointer()));
}

TEST(DelaunayRefinementMeshFilter, ChainsAfterAnImageFilter)
{
  const auto grey = MakeDistanceImage(MakeCubeGeometry(24), BallOracle(origin, 8.0));
  auto       threshold = itk::BinaryThresholdImageFilter<FloatImageType, LabelImageType>::New();
  threshold->SetInput(grey);
  threshold->SetLowerThreshold(0.0f);
  threshold->SetInsideValue(3);
  threshold->SetOutsideValue(0);

  // A part of the image alone is no input for a mesh: the filter asks for all of it.
  FloatImageType::RegionType part = grey->GetLargestPossibleRegion();
  part.SetSize(2, 5);
  threshold->GetOutput()->SetRequestedRegion(part);
  threshold->Update();
  ASSERT_EQ(threshold->GetOutput()->GetBufferedRegion(), part);

  const auto filter = MakeFilter<FloatMeshType, LabelImageType>(threshold->GetOutput(), 1.5);
  filter->Update();
  CheckedMesh mesh = GetMesh(filter.GetPointer());
  ExpectGuarantees(mesh);
  ExpectLabel(mesh, 3.0);
  EXPECT_NEAR(ComputeVolume(mesh) / BallOracle(origin, 8.0).ComputeVolume(), 1.0, 0.05);

  threshold->SetLowerThreshold(3.0f);
  filter->Update();
  mesh = GetMesh(filter.GetPointer());
  EXPECT_NEAR(ComputeVolume(mesh) / BallOracle(origin, 5.0).ComputeVolume(), 1.0, 0.06);
}

TEST(DelaunayRefinementMeshFilter, OutputsOutliveTheFilter)
{
  FloatMeshType::Pointer volume;
  FloatMeshType::Pointer boundary;
  {
    const auto image = MakeBall();
    const auto filter = MakeFilter(image.GetPointer(), 3.0);
    filter->Update();
    volume = filter->GetOutput();
    boundary = filter->GetBoundaryOutput();
    volume->DisconnectPipeline();
  }
  ExpectGuarantees(MakeCheckedMesh(*volume, *boundary));
  // The boundary has no other points than its own.
  EXPECT_LT(boundary->GetNumberOfPoints(), volume->GetNumberOfPoints());
  CheckedMesh alone = MakeCheckedMesh(*boundary, *boundary);
  alone.tetrahedra.clear();
  std::set<std::uint32_t> used;
  for (const auto & triangle : alone.triangles)
  {
    used.insert(triangle.begin(), triangle.end());
  }
  EXPECT_EQ(used.size(), boundary->GetNumberOfPoints());
}

TEST(DelaunayRefinementMeshFilter, CellsMayBeSharedReplacedAndAdded)
{
  // Memory checkers tell whether each cell is deleted once.
  auto       mesh = FloatMeshType::New();
  const auto image = MakeBall();
  const auto setCell = [&mesh](itk::IdentifierType number) {
    FloatMeshType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TetrahedronCell<FloatMeshType::CellType>);
    for (int i = 0; i < 4; ++i)
    {
      cell->SetPointId(i, static_cast<itk::IdentifierType>(i));
    }
    mesh->SetCell(number, cell);
  };
  const auto filter = MakeFilter(image.GetPointer(), 3.0);
  filter->Update();
  const auto numberOfCells = filter->GetOutput()->GetNumberOfCells();
  mesh->SetPoints(filter->GetOutput()->GetPoints());
  mesh->SetCells(filter->GetOutput()->GetCells());
  filter->SetDelta(4.0);
  filter->Update();
  EXPECT_EQ(mesh->GetNumberOfCells(), numberOfCells);
  EXPECT_LT(filter->GetOutput()->GetNumberOfCells(), numberOfCells);

  setCell(numberOfCells);
  EXPECT_EQ(mesh->GetNumberOfCells(), numberOfCells + 1);
  delete mesh->GetCells()->GetElement(0);
  setCell(0);
  FloatMeshType::CellAutoPointer first;
  ASSERT_TRUE(mesh->GetCell(0, first));
  EXPECT_EQ(first->PointIdsBegin()[3], 3u);
}

TEST(DelaunayRefinementMeshFilter, TimesAndStatisticsAreThoseOfTheLastRun)
{
  const auto image = MakeBall();
  const auto filter = MakeFilter(image.GetPointer(), 2.0);
  filter->Update();
  EXPECT_EQ(filter->GetStatistics().terminationReason, itk::DelaunayRefinementEnums::TerminationReason::COMPLETED);
  EXPECT_GT(filter->GetPreparationSeconds(), 0.0);
  EXPECT_GT(filter->GetCopySeconds(), 0.0);
  const auto insertions = filter->GetStatistics().insertions;
  filter->SetDelta(4.0);
  filter->Update();
  EXPECT_LT(filter->GetStatistics().insertions[0], insertions[0]);

  // A refused run leaves nothing of the one before.
  filter->SetLabels({ 9 });
  EXPECT_NE(GetError(filter.GetPointer()), "");
  EXPECT_EQ(filter->GetStatistics().insertions[0], 0u);
  EXPECT_TRUE(filter->GetComponents().empty());
}
