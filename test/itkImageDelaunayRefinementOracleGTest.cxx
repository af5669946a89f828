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
#include "itkImageDelaunayRefinementOracle.h"

#include "itkOracleChecks.h"
#include "itkTestImages.h"

#include "itkBSplineInterpolateImageFunction.h"
#include "itkLinearInterpolateImageFunction.h"
#include "itkNearestNeighborInterpolateImageFunction.h"

#include <algorithm>
#include <random>

using namespace itk::DelaunayRefinementTest;

namespace
{
using OracleType = itk::ImageDelaunayRefinementOracle<FloatImageType>;
using ObjectType = OracleType::ObjectType;
using DefinitionEnum = ObjectType::DefinitionEnum;
using InterpolatorType = OracleType::InterpolatorType;

const PointType center{ 12.0, -30.0, 55.0 };

enum class Content
{
  MASK,
  GREY,
  NOISE
};

/** One way to see an image as an object. */
struct OracleCase
{
  std::string name;
  Content     content;
  bool        isNearest;
  bool        isLeftHanded;
};

std::ostream &
operator<<(std::ostream & out, const OracleCase & value)
{
  return out << value.name;
}

class ImageOracle : public ::testing::TestWithParam<OracleCase>
{
protected:
  void
  SetUp() override
  {
    ImageGeometry geometry = MakeObliqueGeometry(center, GetParam().isLeftHanded);
    geometry.size = { { 22, 16, 13 } };
    geometry = CenterAt(geometry, center);
    const TwoBallsOracle balls(center, 3.0, 2.0, 1.0);
    if (GetParam().content == Content::MASK)
    {
      m_Image = MakeMask<float>(geometry, balls, 1.0f);
      m_Object.definition = DefinitionEnum::THRESHOLD;
      m_Object.lower = 0.5;
      m_Level = 0.5;
    }
    else
    {
      m_Image = MakeDistanceImage(geometry, balls);
      m_Object.definition = DefinitionEnum::ISO_VALUE;
      m_Object.isoValue = 0.25;
      m_Level = 0.25;
    }
    if (GetParam().content == Content::NOISE)
    {
      // Cells of every configuration.
      std::mt19937 generator(11);
      for (itk::ImageRegionIteratorWithIndex<FloatImageType> it(m_Image, m_Image->GetBufferedRegion()); !it.IsAtEnd();
           ++it)
      {
        it.Set(static_cast<float>(static_cast<double>(generator()) / 4294967295.0 - 0.4));
      }
    }
    if (GetParam().isNearest)
    {
      m_Interpolator = itk::NearestNeighborInterpolateImageFunction<FloatImageType, double>::New();
    }
    else
    {
      m_Interpolator = itk::LinearInterpolateImageFunction<FloatImageType, double>::New();
    }
    m_Interpolator->SetInputImage(m_Image);
  }

  std::vector<PointType>
  MakeQueries(const OracleType & oracle, std::size_t count) const
  {
    return MakeRandomPoints(MakeRoomyBox(oracle), count, 3);
  }

  FloatImageType::Pointer   m_Image{};
  ObjectType                m_Object{};
  double                    m_Level{ 0.0 };
  InterpolatorType::Pointer m_Interpolator{};
};

constexpr double SmallestSpacing = 0.7;
constexpr double OneVoxel = 1.0;
} // namespace

TEST_P(ImageOracle, ClassifiesAsTheInterpolatorDoes)
{
  const OracleType oracle(m_Image, m_Object, m_Interpolator);
  const auto       region = m_Image->GetBufferedRegion();
  std::size_t      numberOfPoints = 0;
  std::size_t      numberOfInsidePoints = 0;
  std::size_t      numberOfDifferences = 0;
  for (const PointType & query : MakeRandomPoints(MakeRoomyBox(oracle), 20000, 1))
  {
    FloatImageType::PointType point;
    for (unsigned int i = 0; i < 3; ++i)
    {
      point[i] = query[i];
    }
    const itk::ContinuousIndex<double, 3> index = m_Image->TransformPhysicalPointToContinuousIndex<double>(point);
    // Between the outermost centers and the border of the image, objects are closed in their own way.
    bool isBetweenCenters = true;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double first = static_cast<double>(region.GetIndex(i));
      isBetweenCenters = isBetweenCenters && index[i] >= first && index[i] <= first + region.GetSize(i) - 1.0;
    }
    const bool isInside = oracle.Classify(query) != 0;
    if (isBetweenCenters)
    {
      ++numberOfPoints;
      numberOfInsidePoints += isInside ? 1 : 0;
      const double value = m_Interpolator->EvaluateAtContinuousIndex(index);
      numberOfDifferences += std::abs(value - m_Level) > 1e-5 && isInside != (value >= m_Level) ? 1 : 0;
    }
    else if (!m_Interpolator->IsInsideBuffer(point))
    {
      EXPECT_FALSE(isInside);
    }
  }
  EXPECT_GT(numberOfInsidePoints, numberOfPoints / 50);
  EXPECT_LT(numberOfInsidePoints, numberOfPoints);
  EXPECT_EQ(numberOfDifferences, 0u);
}

TEST_P(ImageOracle, FindsClosestPoints)
{
  const OracleType oracle(m_Image, m_Object, m_Interpolator);
  const auto       surface = SampleSurfaceByClassify(oracle, 100);
  // On the surface to a thousandth of the smallest spacing, and the closest to a twentieth of a voxel.
  ExpectClosestSurfacePoints(oracle, MakeQueries(oracle, 200), surface, 0.05 * SmallestSpacing, 1e-3 * SmallestSpacing);
}

TEST_P(ImageOracle, FindsFirstCrossings)
{
  const OracleType oracle(m_Image, m_Object, m_Interpolator);
  ExpectFirstCrossings(oracle, MakeQueries(oracle, 300), 2000, 1e-3 * SmallestSpacing);
}

TEST_P(ImageOracle, CoversTheSurfaceWithPatches)
{
  const OracleType oracle(m_Image, m_Object, m_Interpolator);
  const auto       surface = SampleSurfaceByClassify(oracle, 60);
  ExpectPatchesCoverSurface(oracle, surface, 1e-3 * SmallestSpacing);
  ExpectBoxBound(oracle, surface);
}

TEST_P(ImageOracle, CellsOfPatchesAreThePartsOfTheirParts)
{
  ExpectCellsArePartsOfParts(OracleType(m_Image, m_Object, m_Interpolator));
}

INSTANTIATE_TEST_SUITE_P(Images,
                         ImageOracle,
                         ::testing::Values(OracleCase{ "LinearMask", Content::MASK, false, false },
                                           OracleCase{ "LinearMaskLeftHanded", Content::MASK, false, true },
                                           OracleCase{ "LinearGrey", Content::GREY, false, false },
                                           OracleCase{ "LinearNoise", Content::NOISE, false, true },
                                           OracleCase{ "NearestMask", Content::MASK, true, true },
                                           OracleCase{ "NearestGrey", Content::GREY, true, false }),
                         [](const auto & test) { return test.param.name; });

TEST(ImageDelaunayRefinementOracle, BorderClosesTheObject)
{
  const auto image = MakeImage<float>(MakeCubeGeometry(6), [](const PointType &) { return 1.0; });
  ObjectType object;
  object.definition = DefinitionEnum::THRESHOLD;
  object.lower = 0.5;
  const OracleType oracle(image, object);
  EXPECT_EQ(oracle.Classify({ 0.0, 0.0, 0.0 }), 1u);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      PointType point{ 0.3, -0.2, 0.1 };
      point[axis] = side * 2.9;
      EXPECT_EQ(oracle.Classify(point), 1u);
      point[axis] = side * 3.01;
      EXPECT_EQ(oracle.Classify(point), 0u);
      PointType closest;
      ASSERT_TRUE(oracle.FindClosestSurfacePoint(point, 1.0, closest));
      EXPECT_NEAR(closest[axis], side * 3.0, 1e-3);
    }
  }
  EXPECT_EQ(oracle.Classify({ 100.0, 0.0, 0.0 }), 0u);
}

TEST(ImageDelaunayRefinementOracle, PlateauAtTheLevelIsInside)
{
  // Values 0, 1 and 1 / 2, with the level at 1 / 2: the plateau belongs to the object.
  const auto image = MakeImage<float>(MakeCubeGeometry(12), [](const PointType & point) {
    return Norm(point) > 5.0 ? 0.0 : (point[0] > 0.0 ? 1.0 : 0.5);
  });
  ObjectType object;
  object.definition = DefinitionEnum::ISO_VALUE;
  object.isoValue = 0.5;
  const OracleType oracle(image, object);
  EXPECT_EQ(oracle.Classify({ 2.0, 0.0, 0.0 }), 1u);
  EXPECT_EQ(oracle.Classify({ -2.0, 0.2, 0.1 }), 1u);
  EXPECT_EQ(oracle.Classify({ -5.4, 0.2, 0.1 }), 0u);
  PointType crossing;
  EXPECT_FALSE(oracle.FindFirstCrossing({ 2.0, 0.1, 0.2 }, { -2.0, 0.1, 0.2 }, crossing));
}

TEST(ImageDelaunayRefinementOracle, AsksOtherInterpolators)
{
  const BallOracle ball({ 0.0, 0.0, 0.0 }, 4.0);
  const auto       image = MakeDistanceImage(MakeCubeGeometry(12), ball);
  const auto       spline = itk::BSplineInterpolateImageFunction<FloatImageType, double>::New();
  ObjectType       object;
  object.definition = DefinitionEnum::ISO_VALUE;
  const OracleType oracle(image, object, spline);
  std::size_t      numberOfDifferences = 0;
  for (const PointType & query : MakeRandomPoints({ { -5.4, -5.4, -5.4 }, { 5.4, 5.4, 5.4 } }, 5000, 1))
  {
    FloatImageType::PointType point;
    for (unsigned int i = 0; i < 3; ++i)
    {
      point[i] = query[i];
    }
    const double value = spline->Evaluate(point);
    numberOfDifferences += std::abs(value) > 1e-3 && (oracle.Classify(query) != 0) != (value >= 0.0) ? 1 : 0;
  }
  EXPECT_EQ(numberOfDifferences, 0u);
  const auto surface = SampleSurfaceByClassify(oracle, 30);
  ExpectClosestSurfacePoints(oracle, MakeRandomPoints(MakeRoomyBox(oracle), 40, 2), surface, 0.25, 1e-3);
  ExpectPatchesCoverSurface(oracle, surface, 1e-3);
}

TEST(ImageDelaunayRefinementOracle, ComponentsAreNumberedAndBounded)
{
  const TwoBallsOracle balls({ 0.0, 0.0, 0.0 }, 4.0, 3.0, 3.0);
  const auto           image = MakeMask<float>(MakeCubeGeometry(24), balls, 1.0f);
  ObjectType           object;
  object.definition = DefinitionEnum::THRESHOLD;
  object.lower = 1.0;
  const OracleType oracle(image, object);
  ASSERT_EQ(oracle.GetNumberOfComponents(), 2u);
  const auto left = oracle.FindComponent({ -5.5, 0.0, 0.0 });
  const auto right = oracle.FindComponent({ 4.5, 0.0, 0.0 });
  EXPECT_NE(left, right);
  for (const PointType & point : SampleSurfaceByClassify(oracle, 40))
  {
    const auto component = oracle.FindComponent(point);
    EXPECT_EQ(component, point[0] < 0.0 ? left : right);
    const auto bounds = oracle.GetComponentBounds(component);
    for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_GE(point[i], bounds.minimum[i] - 1e-9);
      EXPECT_LE(point[i], bounds.maximum[i] + 1e-9);
    }
  }
  const auto components = oracle.ComputeComponents(100.0);
  ASSERT_EQ(components.size(), 2u);
  // Never too large, but perhaps too small.
  EXPECT_GT(components[left].inscribedRadius, 1.0);
  EXPECT_LT(components[left].inscribedRadius, 4.0 + OneVoxel);
  EXPECT_GT(components[right].inscribedRadius, 1.0);
  EXPECT_LT(components[right].inscribedRadius, 3.0 + OneVoxel);
}

TEST(ImageDelaunayRefinementOracle, RoughNumberOfTetrahedraIsABound)
{
  std::mt19937 random(4);
  for (const unsigned int oneIn : { 2u, 3u, 50u })
  {
    const auto image =
      MakeImage<float>(MakeCubeGeometry(20), [&](const PointType &) { return random() % oneIn == 0 ? 1.0 : 0.0; });
    ObjectType                        object;
    const OracleType                  oracle(image, object);
    itk::DelaunayRefinementParameters parameters;
    parameters.delta = 2.0;
    const double estimate = oracle.EstimateNumberOfTetrahedra(parameters);
    EXPECT_LE(estimate, oracle.BoundNumberOfTetrahedra(parameters));
    EXPECT_GE(4.0 * estimate, oracle.BoundNumberOfTetrahedra(parameters));
  }
}

TEST(ImageDelaunayRefinementOracle, LeastOfComponentsIsBoundedInPatches)
{
  // Blocks of voxels and single ones, so that components touch everywhere.
  std::mt19937 random(3);
  const auto   labelOf = [&random](const PointType & point) {
    const bool isSingle = random() % 16 == 0;
    return 1.0 + (isSingle ? random() % 4 : static_cast<unsigned int>(std::floor(point[0] / 3.0 + 10.0)) % 4);
  };
  const auto image = MakeImage<float>(MakeCubeGeometry(12), labelOf);
  ObjectType object;
  object.regionLabels = { 1.0f, 2.0f, 3.0f, 4.0f };
  for (const bool isNearest : { false, true })
  {
    SCOPED_TRACE(isNearest ? "nearest" : "linear");
    InterpolatorType::Pointer interpolator;
    if (isNearest)
    {
      interpolator = itk::NearestNeighborInterpolateImageFunction<FloatImageType, double>::New();
    }
    const OracleType    oracle(image, object, interpolator);
    std::vector<double> values(oracle.GetNumberOfComponents());
    ASSERT_GT(values.size(), 20u);
    for (double & value : values)
    {
      value = std::uniform_real_distribution<double>(1.0, 2.0)(random);
    }
    OracleType::SurfacePatches patches = oracle.GetSurfacePatches();
    for (unsigned int split = 0; split < 4; ++split)
    {
      OracleType::SurfacePatches parts(patches.GetOrigin());
      std::size_t                numberOfStrayValues = 0;
      std::size_t                numberOfStrayParts = 0;
      std::size_t                numberOfUniformPatches = 0;
      for (std::size_t i = 0; i < patches.GetSize(); ++i)
      {
        const auto patch = patches.Get(i);
        const auto range = oracle.FindLeastInPatch(patch, values);
        numberOfUniformPatches += range.least == range.greatest ? 1 : 0;
        if (PointType point; oracle.FindPointOfPatch(patch.identifier, point))
        {
          // Cells share their faces: a point there is in one of them alone.
          const double least = oracle.FindLeastAt(point, values);
          numberOfStrayValues += least < range.least || least > range.greatest ? 1 : 0;
          EXPECT_LE(least, values[oracle.FindComponent(point)]);
        }
        const std::size_t first = parts.GetSize();
        oracle.SplitSurfacePatch(patch.identifier, parts);
        for (std::size_t j = first; j < parts.GetSize(); ++j)
        {
          const auto part = oracle.FindLeastInPatch(parts.Get(j), values);
          numberOfStrayParts += part.least < range.least || part.greatest > range.greatest ? 1 : 0;
        }
      }
      EXPECT_LE(numberOfStrayValues, patches.GetSize() / 20);
      EXPECT_EQ(numberOfStrayParts, 0u);
      // Parts of cells have one value each.
      EXPECT_EQ(numberOfUniformPatches == patches.GetSize(), split >= OracleType::CellLevel);
      patches = std::move(parts);
    }
  }
}

TEST(ImageDelaunayRefinementOracle, CellsOfAShearedImageAreThePartsOfTheirParts)
{
  ImageGeometry geometry = MakeCubeGeometry(12);
  geometry.direction(0, 1) = 0.4;
  geometry.direction(1, 2) = -0.3;
  geometry.direction(0, 2) = 0.2;
  const auto image = MakeImage<float>(geometry, [](const PointType & point) { return Norm(point) < 3.0 ? 1.0 : 0.0; });
  ExpectCellsArePartsOfParts(OracleType(image, ObjectType()));
}

TEST(ImageDelaunayRefinementOracle, SurfaceInTheFacesOfPatchesIsInOneOfThem)
{
  // Half a voxel beyond the border of a grey image, where rounding alone says on which side a point is.
  constexpr int size = 8;
  std::mt19937  random(1);
  const auto    image = MakeImage<float>(MakeCubeGeometry(size), [&random](const PointType &) {
    return std::uniform_real_distribution<double>(0.2, 10.0)(random);
  });
  ObjectType    object;
  object.definition = DefinitionEnum::ISO_VALUE;
  object.isoValue = 0.1;
  const OracleType       oracle(image, object);
  std::vector<PointType> points;
  for (int i = 0; i < 100; ++i)
  {
    std::uniform_real_distribution<double> coordinate(-0.5 * (size - 1), 0.5 * (size - 1));
    const double                           x = coordinate(random);
    points.push_back({ x, -0.5 * size, coordinate(random) });
    points.push_back({ x, 0.5 * size, coordinate(random) });
  }
  auto patches = oracle.GetSurfacePatches();
  for (unsigned int split = 0; split < 9; ++split)
  {
    for (const PointType & point : points)
    {
      bool isInBox = false;
      for (std::size_t number = 0; number < patches.GetSize() && !isInBox; ++number)
      {
        constexpr double rounding = 1e-9;
        const auto       patch = patches.Get(number);
        isInBox = true;
        for (unsigned int i = 0; i < 3; ++i)
        {
          isInBox = isInBox && std::abs(point[i] - patch.center[i]) <= patch.halfExtents[i] + rounding;
        }
      }
      EXPECT_TRUE(isInBox) << "after splitting " << split << " times";
    }
    OracleType::SurfacePatches parts(patches.GetOrigin());
    for (std::size_t number = 0; number < patches.GetSize(); ++number)
    {
      // Those alone in which some point may be.
      const auto patch = patches.Get(number);
      if (std::any_of(points.begin(), points.end(), [&patch](const PointType & point) {
            return Distance(point, patch.center) <= patch.radius + 1e-9;
          }))
      {
        oracle.SplitSurfacePatch(patch.identifier, parts);
      }
    }
    patches = std::move(parts);
  }
}

TEST(ImageDelaunayRefinementOracle, EmptyObjectHasNoSurface)
{
  const auto image = MakeImage<float>(MakeCubeGeometry(6), [](const PointType &) { return 0.0; });
  ObjectType object;
  object.definition = DefinitionEnum::THRESHOLD;
  object.lower = 0.5;
  const OracleType oracle(image, object);
  EXPECT_EQ(oracle.GetNumberOfComponents(), 0u);
  EXPECT_EQ(oracle.GetSurfacePatches().GetSize(), 0u);
  EXPECT_EQ(oracle.Classify({ 0.0, 0.0, 0.0 }), 0u);
  PointType point;
  EXPECT_FALSE(oracle.FindClosestSurfacePoint({ 0.0, 0.0, 0.0 }, 100.0, point));
  EXPECT_FALSE(oracle.FindFirstCrossing({ -3.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }, point));
  EXPECT_FALSE(oracle.MayIntersectBox({ { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } }));
}
