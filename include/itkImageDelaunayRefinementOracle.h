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
#ifndef itkImageDelaunayRefinementOracle_h
#define itkImageDelaunayRefinementOracle_h

#include "itkDelaunayRefinementLabelTable.h"
#include "itkDelaunayRefinementLatticeOracle.h"
#include "itkInterpolateImageFunction.h"

#include <limits>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementObject
 * \brief Which pixel values make the object that is to be meshed.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TPixel>
struct DelaunayRefinementObject
{
  /** \class DefinitionEnum
   * \brief The kinds of objects.
   * \ingroup DelaunayRefinement
   */
  enum class DefinitionEnum : uint8_t
  {
    NON_ZERO,
    LABELS,
    THRESHOLD,
    ISO_VALUE
  };

  /** Which of them this one is. */
  DefinitionEnum definition{ DefinitionEnum::NON_ZERO };

  /** LABELS: the labels, ascending. */
  std::vector<TPixel> labels{};

  /** NON_ZERO and LABELS: if there are several, pixel values that are regions of the object, numbered from 1 in this
   * order, ascending and positive; no other value may be inside. Else the object is one region. */
  std::vector<TPixel> regionLabels{};

  /** THRESHOLD: an end of the range, which belongs to it, in pixel values. */
  /** @ITKStartGrouping */
  double lower{ -std::numeric_limits<double>::infinity() };
  double upper{ std::numeric_limits<double>::infinity() };
  /** @ITKEndGrouping */

  /** ISO_VALUE: inside is at or above, in pixel values. */
  double isoValue{ 0.0 };

  /** All but ISO_VALUE: indicators are smoothed by a Gaussian's standard deviation (mm), with linear interpolation
   * alone. 0: they are not. */
  double smoothingWidth{ 0.0 };

  /** Components with fewer voxels are left out. */
  std::size_t minimumComponentSize{ 1 };

  /** All components but the one with the most voxels are left out. */
  bool largestComponentOnly{ false };
};

/** \class ImageDelaunayRefinementOracle
 * \brief The object in a segmented 3D image: the paper's function f (section II) from voxels, interpolator and the
 * image's spacing, origin and direction.
 *
 * Linear interpolation (no interpolator, or itk::LinearInterpolateImageFunction) and nearest neighbors
 * (itk::NearestNeighborInterpolateImageFunction) are computed here, with the interpolator's values; any other
 * interpolator is asked, and decides between voxels where the object's surface passes. Objects of several regions have
 * linear interpolation or nearest neighbors.
 *
 * The image's buffer must stay as it is while the oracle is used.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TImage>
class ITK_TEMPLATE_EXPORT ImageDelaunayRefinementOracle : public DelaunayRefinementLatticeOracle
{
public:
  static_assert(TImage::ImageDimension == 3, "Only images of dimension 3 can be meshed.");

  /** The image and what belongs to it. */
  /** @ITKStartGrouping */
  using ImageType = TImage;
  using PixelType = typename TImage::PixelType;
  using InterpolatorType = InterpolateImageFunction<TImage, double>;
  using ObjectType = DelaunayRefinementObject<PixelType>;
  /** @ITKEndGrouping */

  /** Takes the buffered region of the image. An interpolator other than linear and nearest neighbors has its input
   * image set to the image if the object is defined by an iso value, else to an indicator image made here; it is asked
   * on several threads at once, by EvaluateAtContinuousIndex(), which is const. Threads, if there are any, share the
   * work here and in what describes the object as a whole; they must outlive the oracle. */
  ImageDelaunayRefinementOracle(const ImageType *           image,
                                const ObjectType &          object,
                                InterpolatorType *          interpolator = nullptr,
                                DelaunayRefinementThreads * threads = nullptr);

  /** Leaves the interpolator without an input image. */
  ~ImageDelaunayRefinementOracle() override;

protected:
  double
  GetVoxelValue(std::int32_t x, std::int32_t y, std::int32_t z) const override;

  RegionType
  GetVoxelRegion(std::int32_t x, std::int32_t y, std::int32_t z) const override;

  bool
  IsInsideField(const PointType & position) const override;

  void
  GetVoxelRegions(const std::array<std::int32_t, 3> & first,
                  unsigned int                        voxels,
                  std::array<RegionType, 8> &         regions) const override;

  bool
  MayHaveJunctions(const std::array<std::int32_t, 3> & first) const override;

private:
  static FrameType
  ComputeFrame(const ImageType * image);

  /** Calls \c action with a predicate on pixel values that tells the object's. */
  template <typename TAction>
  static void
  WithPredicate(const ObjectType & object, const TAction & action);

  /** Sets the interpolator's input, and the mask from it. */
  void
  PrepareField(const ImageType *             image,
               const ObjectType &            object,
               DelaunayRefinementVoxelMask & mask,
               DelaunayRefinementThreads *   threads);

  /** The same for objects of one region and of several. */
  void
  InitializeAs(ModelEnum                   model,
               const ImageType *           image,
               const ObjectType &          object,
               DelaunayRefinementVoxelMask mask,
               DelaunayRefinementThreads * threads);

  /** Removes the components that the user does not want from the mask. */
  static void
  RemoveComponents(const ObjectType &                  object,
                   DelaunayRefinementVoxelComponents & components,
                   DelaunayRefinementVoxelMask &       mask);

  /** Calls \c action with y and z of each row of voxels. */
  template <typename TAction>
  static void
  ForEachRow(const DelaunayRefinementVoxelMask & mask, DelaunayRefinementThreads * threads, const TAction & action);

  const PixelType *                       m_Buffer;
  std::array<std::int32_t, 3>             m_Size{};
  std::array<std::size_t, 3>              m_Strides{};
  DelaunayRefinementLabelTable<PixelType> m_Regions;
  double                                  m_Level;
  bool                                    m_IsSelective{ false };
  typename InterpolatorType::Pointer      m_Interpolator{};
  typename ImageType::Pointer             m_Indicator{};
  typename ImageType::IndexType           m_Start{};
};
} // end namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkImageDelaunayRefinementOracle.hxx"
#endif

#endif
