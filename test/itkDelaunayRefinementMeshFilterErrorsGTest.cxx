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

#include "itkBSplineInterpolateImageFunction.h"

#include <functional>
#include <random>

using namespace itk::DelaunayRefinementTest;

namespace
{
const PointType  origin{ 0.0, 0.0, 0.0 };
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

LabelImageType::Pointer
MakeBall()
{
  return MakeMask(MakeCubeGeometry(12), BallOracle(origin, 4.0));
}

/** Labels 2 to the left, 5 to the right and 9 in the middle. */
ShortImageType::Pointer
MakeThreeLabels()
{
  return MakeImage<short>(MakeCubeGeometry(16), [](const PointType & point) {
    return Norm(point) > 6.0 ? 0 : (std::abs(point[0]) < 2.0 ? 9 : (point[0] < 0.0 ? 2 : 5));
  });
}

/** Lets a test damage the direction, which itk::Image does not. */
class SingularImage : public itk::Image<unsigned char, 3>
{
public:
  using Self = SingularImage;
  using Superclass = itk::Image<unsigned char, 3>;
  using Pointer = itk::SmartPointer<Self>;
  itkSimpleNewMacro(Self);

  void
  MakeSingular()
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Direction[i][2] = m_Direction[i][1];
      m_IndexToPhysicalPoint[i][2] = m_IndexToPhysicalPoint[i][1];
    }
  }
};

/** The filter refuses each value that is set, naming the parameter, and works with a good one afterwards. */
template <typename TSetter>
void
ExpectRefusedValues(const std::string & parameter, const std::vector<double> & bad, double good, const TSetter & set)
{
  const auto image = MakeBall();
  for (const double value : bad)
  {
    SCOPED_TRACE(parameter + " = " + std::to_string(value));
    const auto filter = MakeFilter(image.GetPointer(), 1.5);
    set(filter.GetPointer(), value);
    ExpectError(filter.GetPointer(), { parameter });
    set(filter.GetPointer(), good);
    EXPECT_EQ(GetError(filter.GetPointer()), "");
  }
}

using LabelFilterType = itk::DelaunayRefinementMeshFilter<LabelImageType, FloatMeshType>;
} // namespace

TEST(DelaunayRefinementMeshFilterErrors, BadDelta)
{
  ExpectRefusedValues("Delta", { 0.0, -1.0, infinity, -infinity, notANumber }, 1.5, [](auto * filter, double value) {
    filter->SetDelta(value);
  });
}

TEST(DelaunayRefinementMeshFilterErrors, BadRadiusEdgeRatioBound)
{
  ExpectRefusedValues("RadiusEdgeRatioBound",
                      { 0.99, 0.0, -2.0, infinity, notANumber },
                      1.0,
                      [](auto * filter, double value) { filter->SetRadiusEdgeRatioBound(value); });
}

TEST(DelaunayRefinementMeshFilterErrors, BadCellSize)
{
  ExpectRefusedValues(
    "CellSize", { 0.0, -1.0, notANumber }, 2.0, [](auto * filter, double value) { filter->SetCellSize(value); });
}

TEST(DelaunayRefinementMeshFilterErrors, BadMinimumDihedralAngle)
{
  ExpectRefusedValues("MinimumDihedralAngle",
                      { -1.0, 60.0, 90.0, infinity, notANumber },
                      5.0,
                      [](auto * filter, double value) { filter->SetMinimumDihedralAngle(value); });
}

TEST(DelaunayRefinementMeshFilterErrors, PaperSliversWithoutAnAngle)
{
  const auto image = MakeMask(MakeCubeGeometry(24), BallOracle(origin, 10.0));
  const auto filter = MakeFilter(image.GetPointer(), 3.0);
  filter->PaperSliversOn();
  ExpectError(filter.GetPointer(), { "PaperSlivers", "set MinimumDihedralAngle" });
  filter->SetMinimumDihedralAngle(10.0);
  filter->Update();
}

TEST(DelaunayRefinementMeshFilterErrors, SliversThatAreLeft)
{
  const auto image = MakeMask(MakeCubeGeometry(24), BallOracle(origin, 10.0));
  const auto filter = MakeFilter(image.GetPointer(), 4.0);
  filter->SetMinimumDihedralAngle(50.0);
  filter->Update();
  const std::size_t number = filter->GetStatistics().slivers.size();
  ASSERT_GT(number, 10u);
  ASSERT_EQ(filter->GetWarnings().size(), 1u);
  const std::string & warning = filter->GetWarnings().front();
  EXPECT_NE(warning.find("MinimumDihedralAngle 50 degrees is not kept by " + std::to_string(number)), std::string::npos)
    << warning;
  EXPECT_NE(warning.find(", ..."), std::string::npos) << warning;
  filter->StrictOn();
  ExpectError(filter.GetPointer(), { "MinimumDihedralAngle 50 degrees", "Strict" });
}

TEST(DelaunayRefinementMeshFilterErrors, BadMaximumNumberOfVertices)
{
  ExpectRefusedValues("MaximumNumberOfVertices", { 0.0 }, 1e6, [](auto * filter, double value) {
    filter->SetMaximumNumberOfVertices(static_cast<itk::SizeValueType>(value));
  });
}

TEST(DelaunayRefinementMeshFilterErrors, BadObjectDefinitions)
{
  const auto image = MakeBall();
  const auto expectError = [&image](const std::function<void(LabelFilterType *)> & set,
                                    const std::vector<std::string> &               words) {
    const auto filter = MakeFilter(image.GetPointer(), 1.5);
    set(filter.GetPointer());
    ExpectError(filter.GetPointer(), words);
    filter->UnsetObjectDefinition();
    filter->MergeLabelsOff();
    EXPECT_EQ(GetError(filter.GetPointer()), "");
  };
  expectError([](auto * filter) { filter->SetIsoValue(notANumber); }, { "IsoValue" });
  expectError([](auto * filter) { filter->SetIsoValue(infinity); }, { "IsoValue" });
  expectError([](auto * filter) { filter->SetLowerThreshold(notANumber); }, { "LowerThreshold" });
  expectError([](auto * filter) { filter->SetUpperThreshold(notANumber); }, { "UpperThreshold" });
  expectError(
    [](auto * filter) {
      filter->SetLowerThreshold(2.0);
      filter->SetUpperThreshold(1.0);
    },
    { "LowerThreshold", "UpperThreshold" });
  expectError(
    [](auto * filter) {
      filter->SetIsoValue(0.5);
      filter->SetLowerThreshold(1.0);
    },
    { "IsoValue", "LowerThreshold" });
  expectError(
    [](auto * filter) {
      filter->SetIsoValue(0.5);
      filter->SetLabels({ 1 });
    },
    { "IsoValue", "Labels" });
  expectError(
    [](auto * filter) {
      filter->SetUpperThreshold(1.0);
      filter->SetLabels({ 1 });
    },
    { "UpperThreshold", "Labels" });
  expectError(
    [](auto * filter) {
      filter->SetIsoValue(0.5);
      filter->MergeLabelsOn();
    },
    { "IsoValue", "MergeLabels" });
}

TEST(DelaunayRefinementMeshFilterErrors, Labels)
{
  const auto image = MakeThreeLabels();
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  // The labels there are.
  filter->SetLabels({ 2, 7 });
  ExpectError(filter.GetPointer(), { "label 7", "2, 5, 9" });
  filter->MergeLabelsOn();
  ExpectError(filter.GetPointer(), { "label 7" });
  filter->SetLabels({ 0 });
  ExpectError(filter.GetPointer(), { "0" });
  filter->SetLabels({ 5 });
  filter->MergeLabelsOff();
  EXPECT_EQ(GetError(filter.GetPointer()), "");
  filter->SetLabels({ 2, 5 });
  filter->SetInterpolator(itk::BSplineInterpolateImageFunction<ShortImageType, double>::New());
  ExpectError(filter.GetPointer(), { "BSpline", "Interpolator", "MergeLabels" });
}

TEST(DelaunayRefinementMeshFilterErrors, FloatingPointValuesAreNoLabels)
{
  const auto image = MakeDistanceImage(MakeCubeGeometry(12), BallOracle(origin, 4.0));
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  ExpectError(filter.GetPointer(), { "IsoValue", "Threshold" });
}

TEST(DelaunayRefinementMeshFilterErrors, SpeckleIsCalledGreyValues)
{
  std::mt19937 generator(5);
  const auto   image = MakeImage<short>(
    MakeCubeGeometry(16), [&generator](const PointType &) { return static_cast<short>(generator() % 1000); });
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  ExpectError(filter.GetPointer(), { "grey values", "IsoValue" });
}

TEST(DelaunayRefinementMeshFilterErrors, NaN)
{
  const auto image = MakeDistanceImage(MakeCubeGeometry(12), BallOracle(origin, 4.0));
  image->SetPixel({ { 3, 4, 5 } }, std::numeric_limits<float>::quiet_NaN());
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  filter->SetIsoValue(0.0);
  ExpectError(filter.GetPointer(), { "NaN" });
  filter->UnsetObjectDefinition();
  filter->SetLowerThreshold(0.0);
  ExpectError(filter.GetPointer(), { "NaN" });
}

TEST(DelaunayRefinementMeshFilterErrors, InfiniteValuesAreValues)
{
  const auto image = MakeDistanceImage(MakeCubeGeometry(12), BallOracle(origin, 4.0));
  image->SetPixel({ { 6, 6, 6 } }, std::numeric_limits<float>::infinity());
  image->SetPixel({ { 0, 0, 0 } }, -std::numeric_limits<float>::infinity());
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  filter->SetIsoValue(0.0);
  filter->Update();
  ExpectGuarantees(GetMesh(filter.GetPointer()));
}

TEST(DelaunayRefinementMeshFilterErrors, NoObject)
{
  const auto nothing = MakeImage<unsigned char>(MakeCubeGeometry(8), [](const PointType &) { return 0; });
  const auto filter = MakeFilter(nothing.GetPointer(), 1.5);
  ExpectError(filter.GetPointer(), { "no object" });
  filter->MergeLabelsOn();
  ExpectError(filter.GetPointer(), { "no object" });
  filter->MergeLabelsOff();
  filter->SetLowerThreshold(1.0);
  ExpectError(filter.GetPointer(), { "no object", "LowerThreshold" });
  filter->UnsetObjectDefinition();
  filter->SetIsoValue(3.0);
  ExpectError(filter.GetPointer(), { "no object", "IsoValue" });
}

TEST(DelaunayRefinementMeshFilterErrors, NoInput)
{
  const auto filter = LabelFilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(DelaunayRefinementMeshFilterErrors, ImageWithoutVoxels)
{
  ImageGeometry geometry;
  geometry.size = { { 0, 4, 4 } };
  const auto image = MakeEmptyImage<unsigned char>(geometry);
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(DelaunayRefinementMeshFilterErrors, TwoDimensions)
{
  using FlatImageType = itk::Image<unsigned char, 2>;
  auto image = FlatImageType::New();
  image->SetRegions(FlatImageType::SizeType{ { 8, 8 } });
  image->Allocate();
  image->FillBuffer(1);
  const auto filter = MakeFilter(image.GetPointer(), 1.5);
  ExpectError(filter.GetPointer(), { "dimension 2", "dimension 3" });
}

TEST(DelaunayRefinementMeshFilterErrors, SingularDirection)
{
  auto image = SingularImage::New();
  image->SetRegions(SingularImage::SizeType{ { 8, 8, 8 } });
  image->Allocate();
  image->FillBuffer(1);
  image->MakeSingular();
  const auto filter = MakeFilter<FloatMeshType, LabelImageType>(image.GetPointer(), 1.5);
  ExpectError(filter.GetPointer(), { "direction" });
}

TEST(DelaunayRefinementMeshFilterErrors, VertexLimitKeepsStatistics)
{
  const auto image = MakeBall();
  const auto filter = MakeFilter(image.GetPointer(), 0.5);
  filter->SetMaximumNumberOfVertices(300);
  ExpectError(filter.GetPointer(), { "MaximumNumberOfVertices", "300", "Delta" });
  EXPECT_EQ(filter->GetStatistics().terminationReason, itk::DelaunayRefinementEnums::TerminationReason::VERTEX_LIMIT);
  EXPECT_EQ(filter->GetComponents().size(), 1u);

  filter->SetMaximumNumberOfVertices(1000000);
  EXPECT_EQ(GetError(filter.GetPointer()), "");
  EXPECT_EQ(filter->GetStatistics().terminationReason, itk::DelaunayRefinementEnums::TerminationReason::COMPLETED);
}

TEST(DelaunayRefinementMeshFilterErrors, FarTooSmallDeltaIsRefusedAtOnce)
{
  // Without an estimate, this would go on until memory ends.
  const auto image = MakeBall();
  for (const double delta : { 1e-3, 1e-6, 1e-300 })
  {
    const auto filter = MakeFilter(image.GetPointer(), delta);
    ExpectError(filter.GetPointer(), { "Delta" });
  }
  const auto filter = MakeFilter(image.GetPointer(), 1.0);
  filter->SetCellSize(1e-4);
  ExpectError(filter.GetPointer(), { "CellSize" });
}
