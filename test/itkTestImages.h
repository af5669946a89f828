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
#ifndef itkTestImages_h
#define itkTestImages_h

#include "itkAnalyticOracles.h"

#include "itkImage.h"
#include "itkImageRegionIteratorWithIndex.h"

namespace itk::DelaunayRefinementTest
{
using LabelImageType = Image<unsigned char, 3>;
using ShortImageType = Image<short, 3>;
using FloatImageType = Image<float, 3>;

/** \class ImageGeometry
 * \brief Where an image's voxels are.
 */
struct ImageGeometry
{
  LabelImageType::SizeType      size{};
  LabelImageType::IndexType     startIndex{};
  LabelImageType::SpacingType   spacing{ 1.0 };
  LabelImageType::PointType     origin{};
  LabelImageType::DirectionType direction = LabelImageType::DirectionType::GetIdentity();
};

template <typename TPixel>
typename Image<TPixel, 3>::Pointer
MakeEmptyImage(const ImageGeometry & geometry)
{
  auto image = Image<TPixel, 3>::New();
  image->SetRegions({ geometry.startIndex, geometry.size });
  image->SetSpacing(geometry.spacing);
  image->SetOrigin(geometry.origin);
  image->SetDirection(geometry.direction);
  image->Allocate(true);
  return image;
}

/** Moves the origin so that the middle of the image is at a point. */
inline ImageGeometry
CenterAt(ImageGeometry geometry, const PointType & center)
{
  const auto                 image = MakeEmptyImage<unsigned char>(geometry);
  ContinuousIndex<double, 3> middle;
  for (unsigned int i = 0; i < 3; ++i)
  {
    middle[i] = static_cast<double>(geometry.startIndex[i]) + 0.5 * (static_cast<double>(geometry.size[i]) - 1.0);
  }
  LabelImageType::PointType point;
  image->TransformContinuousIndexToPhysicalPoint(middle, point);
  for (unsigned int i = 0; i < 3; ++i)
  {
    geometry.origin[i] += center[i] - point[i];
  }
  return geometry;
}

/** A cube of voxels of 1 mm in the middle of which is the physical origin. */
inline ImageGeometry
MakeCubeGeometry(SizeValueType size)
{
  ImageGeometry geometry;
  geometry.size.Fill(size);
  return CenterAt(geometry, { 0.0, 0.0, 0.0 });
}

/** Oblique, anisotropic and shifted, with a non-zero start index, over some 30 mm around a point. */
inline ImageGeometry
MakeObliqueGeometry(const PointType & center, bool isLeftHanded)
{
  ImageGeometry geometry;
  geometry.size = { { 48, 34, 26 } };
  geometry.startIndex = { { -7, 11, 3 } };
  geometry.spacing[0] = 0.7;
  geometry.spacing[1] = 1.0;
  geometry.spacing[2] = 1.3;
  // The rotation by angle around the axis (1, 2, 2) / 3.
  const double                  angle = 0.6;
  const std::array<double, 3>   axis{ 1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0 };
  LabelImageType::DirectionType skew;
  skew.Fill(0.0);
  for (unsigned int i = 0; i < 3; ++i)
  {
    skew[(i + 2) % 3][(i + 1) % 3] = axis[i];
    skew[(i + 1) % 3][(i + 2) % 3] = -axis[i];
  }
  const auto squared = skew * skew;
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      geometry.direction[i][j] += std::sin(angle) * skew[i][j] + (1.0 - std::cos(angle)) * squared[i][j];
    }
    if (isLeftHanded)
    {
      geometry.direction[i][0] *= -1.0;
    }
  }
  return CenterAt(geometry, center);
}

/** The value of each voxel is that of a function of its physical position. */
template <typename TPixel, typename TFunction>
typename Image<TPixel, 3>::Pointer
MakeImage(const ImageGeometry & geometry, TFunction && function)
{
  const auto image = MakeEmptyImage<TPixel>(geometry);
  for (ImageRegionIteratorWithIndex<Image<TPixel, 3>> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    typename Image<TPixel, 3>::PointType point;
    image->TransformIndexToPhysicalPoint(it.GetIndex(), point);
    it.Set(static_cast<TPixel>(function(PointType{ point[0], point[1], point[2] })));
  }
  return image;
}

/** A label for the voxels with their centers in a shape, 0 for others. */
template <typename TPixel = unsigned char>
typename Image<TPixel, 3>::Pointer
MakeMask(const ImageGeometry & geometry, const AnalyticOracle & shape, TPixel label = 1)
{
  return MakeImage<TPixel>(geometry,
                           [&](const PointType & point) { return shape.Classify(point) != 0 ? label : TPixel{ 0 }; });
}

/** Grey values with the shape's surface at 0: its signed distance, positive inside. */
inline FloatImageType::Pointer
MakeDistanceImage(const ImageGeometry & geometry, const AnalyticOracle & shape)
{
  return MakeImage<float>(geometry, [&](const PointType & point) { return -shape.ComputeSignedDistance(point); });
}

/** Label 1 for the voxels of a list of indexes, 0 for others; voxels of 1 mm. */
inline LabelImageType::Pointer
MakeVoxels(SizeValueType size, const std::vector<std::array<int, 3>> & voxels)
{
  ImageGeometry geometry;
  geometry.size.Fill(size);
  const auto image = MakeEmptyImage<unsigned char>(geometry);
  for (const auto & voxel : voxels)
  {
    image->SetPixel({ { voxel[0], voxel[1], voxel[2] } }, 1);
  }
  return image;
}

/** The cube of 2 x 2 x 2 voxels with the lowest at a corner, those whose bits are set. */
inline std::vector<std::array<int, 3>>
MakeFilling(unsigned int bits, const std::array<int, 3> & corner)
{
  std::vector<std::array<int, 3>> voxels;
  for (unsigned int i = 0; i < 8; ++i)
  {
    if ((bits >> i & 1) != 0)
    {
      voxels.push_back({ corner[0] + static_cast<int>(i & 1),
                         corner[1] + static_cast<int>(i >> 1 & 1),
                         corner[2] + static_cast<int>(i >> 2) });
    }
  }
  return voxels;
}

/** The volume of voxels other than 0. */
template <typename TImage>
double
ComputeVoxelVolume(const TImage * image)
{
  std::size_t count = 0;
  for (ImageRegionConstIteratorWithIndex<TImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    count += it.Get() != 0 ? 1 : 0;
  }
  const auto & spacing = image->GetSpacing();
  return static_cast<double>(count) * spacing[0] * spacing[1] * spacing[2];
}
} // end namespace itk::DelaunayRefinementTest

#endif
