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
// Whatever is shared by threads comes out the same for any number of them.
#include "itkDelaunayRefinementThreads.h"

#include "itkDelaunayRefinementFirstUses.h"
#include "itkDelaunayRefinementImageCensus.h"
#include "itkFilterRun.h"

#include <random>

using namespace itk::DelaunayRefinementTest;

namespace
{
using ThreadsType = itk::DelaunayRefinementThreads;
using OracleType = itk::ImageDelaunayRefinementOracle<LabelImageType>;

constexpr unsigned int NumbersOfThreads[] = { 1, 2, 3, 5 };

/** Two balls, one of which touches the border, in an image with specks: rows of three words, none of them full. */
LabelImageType::Pointer
MakeOddImage()
{
  ImageGeometry geometry;
  geometry.size = { { 131, 77, 53 } };
  geometry.spacing[2] = 1.7;
  std::mt19937 random(7);
  return MakeImage<unsigned char>(geometry, [&random](const PointType & point) {
    const bool isSpeck = std::uniform_int_distribution<int>(0, 299)(random) == 0;
    return isSpeck || Distance(point, { 40.0, 40.0, 40.0 }) < 25.0 || Distance(point, { 110.0, 30.0, 10.0 }) < 20.0;
  });
}

LabelImageType::Pointer
MakeSmallImage()
{
  return MakeMask<unsigned char>(MakeCubeGeometry(12), BallOracle({ 0.0, 0.0, 0.0 }, 4.0));
}

void
ExpectSameOracle(const OracleType & oracle, const OracleType & expected)
{
  const auto components = oracle.ComputeComponents(5.0);
  const auto expectedComponents = expected.ComputeComponents(5.0);
  ASSERT_EQ(components.size(), expectedComponents.size());
  for (std::uint32_t i = 0; i < components.size(); ++i)
  {
    EXPECT_EQ(components[i].numberOfVoxels, expectedComponents[i].numberOfVoxels);
    EXPECT_EQ(components[i].volume, expectedComponents[i].volume);
    EXPECT_EQ(components[i].firstVoxel, expectedComponents[i].firstVoxel);
    EXPECT_EQ(components[i].inscribedRadius, expectedComponents[i].inscribedRadius);
    EXPECT_EQ(oracle.GetComponentBounds(i).minimum, expected.GetComponentBounds(i).minimum);
    EXPECT_EQ(oracle.GetComponentBounds(i).maximum, expected.GetComponentBounds(i).maximum);
  }
  EXPECT_EQ(oracle.EstimateSurfaceArea(), expected.EstimateSurfaceArea());
  EXPECT_EQ(oracle.ComputeDefaultDelta(), expected.ComputeDefaultDelta());
  EXPECT_EQ(oracle.GetSurfaceBounds().minimum, expected.GetSurfaceBounds().minimum);
  EXPECT_EQ(oracle.GetSurfaceBounds().maximum, expected.GetSurfaceBounds().maximum);
  EXPECT_EQ(oracle.GetSurfacePatches().GetSize(), expected.GetSurfacePatches().GetSize());

  std::mt19937                           random(3);
  std::uniform_real_distribution<double> share(-0.05, 1.05);
  const auto                             bounds = expected.GetSurfaceBounds();
  for (unsigned int i = 0; i < 2000; ++i)
  {
    PointType point;
    for (unsigned int j = 0; j < 3; ++j)
    {
      point[j] = bounds.minimum[j] + share(random) * (bounds.maximum[j] - bounds.minimum[j]);
    }
    EXPECT_EQ(oracle.Classify(point), expected.Classify(point));
    EXPECT_EQ(oracle.FindComponent(point), expected.FindComponent(point));
  }
}

void
ExpectSameMesh(const LabelImageType * image, double delta)
{
  CheckedMesh expected;
  for (const unsigned int numberOfThreads : NumbersOfThreads)
  {
    SCOPED_TRACE(numberOfThreads);
    auto filter = MakeFilter<DoubleMeshType>(image, delta);
    filter->GetMultiThreader()->SetMaximumNumberOfThreads(numberOfThreads);
    filter->SetNumberOfWorkUnits(numberOfThreads);
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    if (numberOfThreads == 1)
    {
      expected = mesh;
      ASSERT_FALSE(mesh.tetrahedra.empty());
    }
    EXPECT_TRUE(mesh.points == expected.points);
    EXPECT_TRUE(mesh.tetrahedra == expected.tetrahedra);
    EXPECT_TRUE(mesh.triangles == expected.triangles);
    EXPECT_TRUE(mesh.tetrahedronLabels == expected.tetrahedronLabels);
  }
}
} // namespace

TEST(DelaunayRefinementParallel, PiecesCoverAllOnce)
{
  for (const unsigned int numberOfThreads : NumbersOfThreads)
  {
    ThreadsType       threads(numberOfThreads);
    const std::size_t length = ThreadsType::ChoosePieceLength(&threads, 1000, 7);
    std::vector<int>  visits(1000, 0);
    ThreadsType::RunPieces(&threads, visits.size(), length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      EXPECT_EQ(begin, piece * length);
      EXPECT_TRUE(end == begin + length || end == visits.size());
      for (std::size_t i = begin; i < end; ++i)
      {
        ++visits[i];
      }
    });
    EXPECT_TRUE(visits == std::vector<int>(visits.size(), 1));
  }
}

TEST(DelaunayRefinementParallel, FirstUsesAreNumberedInOrder)
{
  constexpr std::uint32_t    numberOfIndexes = 30000;
  std::mt19937               random(11);
  std::vector<std::uint32_t> indexes(200000);
  for (std::uint32_t & index : indexes)
  {
    index = 2 * std::uniform_int_distribution<std::uint32_t>(0, numberOfIndexes / 2 - 1)(random);
  }
  for (const unsigned int numberOfThreads : NumbersOfThreads)
  {
    ThreadsType                            threads(numberOfThreads);
    const itk::DelaunayRefinementFirstUses uses(indexes.data(), indexes.size(), numberOfIndexes, &threads);
    EXPECT_EQ(uses.GetNumber(1), itk::DelaunayRefinementFirstUses::None);
    std::uint32_t next = 0;
    for (const std::uint32_t index : indexes)
    {
      ASSERT_LE(uses.GetNumber(index), next);
      next += uses.GetNumber(index) == next ? 1 : 0;
    }
    EXPECT_EQ(uses.GetNumberOfUsed(), next);
  }
}

TEST(DelaunayRefinementParallel, LabelsAreFound)
{
  // More than one piece; many labels are cut off at the same one.
  std::vector<int> pixels(6000000);
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    pixels[i] = static_cast<int>(i / 20) - 5;
  }
  std::vector<short>  few(pixels.size(), 3);
  std::vector<double> real(pixels.size(), 0.5);
  few.back() = -7;
  std::vector<int> expected;
  for (const unsigned int numberOfThreads : NumbersOfThreads)
  {
    ThreadsType                                   threads(numberOfThreads);
    const itk::DelaunayRefinementImageCensus<int> census(pixels.data(), pixels.size(), 1000, &threads);
    const auto                                    labels = census.FindLabels();
    expected = expected.empty() ? labels : expected;
    EXPECT_GE(labels.size(), 100000u);
    EXPECT_TRUE(labels == expected);
    EXPECT_DOUBLE_EQ(census.ComputeSpeckle(),
                     itk::DelaunayRefinementImageCensus<int>(pixels.data(), pixels.size(), 1000).ComputeSpeckle());

    const itk::DelaunayRefinementImageCensus<short> censusOfFew(few.data(), few.size(), 1000, &threads);
    EXPECT_EQ(censusOfFew.FindLabels(), (std::vector<short>{ -7, 3 }));

    const itk::DelaunayRefinementImageCensus<double> censusOfReal(real.data(), real.size(), 1000, &threads);
    real.back() = 0.0;
    EXPECT_FALSE(censusOfReal.HasNaN());
    real.back() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(censusOfReal.HasNaN());
  }
}

TEST(DelaunayRefinementParallel, OraclesAreTheSame)
{
  for (const auto & image : { MakeSmallImage(), MakeOddImage() })
  {
    for (const std::size_t minimumSize : { 1, 3 })
    {
      OracleType::ObjectType object;
      object.minimumComponentSize = minimumSize;
      const OracleType expected(image, object);
      for (const unsigned int numberOfThreads : NumbersOfThreads)
      {
        ThreadsType threads(numberOfThreads);
        ExpectSameOracle(OracleType(image, object, nullptr, &threads), expected);
      }
    }
  }
}

TEST(DelaunayRefinementParallel, MeshesAreTheSame)
{
  ExpectSameMesh(MakeSmallImage(), 1.0);
  ExpectSameMesh(MakeOddImage(), 3.0);
}
