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
#ifndef itkImageDelaunayRefinementOracle_hxx
#define itkImageDelaunayRefinementOracle_hxx

#include "itkImageDelaunayRefinementOracle.h"

#include "itkImageRegionIterator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
template <typename TImage>
ImageDelaunayRefinementOracle<TImage>::ImageDelaunayRefinementOracle(const ImageType *           image,
                                                                     const ObjectType &          object,
                                                                     InterpolatorType *          interpolator,
                                                                     DelaunayRefinementThreads * threads)
  : m_Buffer(image->GetBufferPointer())
  , m_Regions(object.regionLabels)
  , m_Level(object.definition == ObjectType::DefinitionEnum::ISO_VALUE ? object.isoValue : 0.5)
  , m_Start(image->GetBufferedRegion().GetIndex())
{
  const auto & size = image->GetBufferedRegion().GetSize();
  m_Size = { static_cast<std::int32_t>(size[0]),
             static_cast<std::int32_t>(size[1]),
             static_cast<std::int32_t>(size[2]) };
  m_Strides = { 1, size[0], size[0] * size[1] };
  DelaunayRefinementVoxelMask mask(m_Size);

  const std::string interpolatorName =
    interpolator == nullptr ? "LinearInterpolateImageFunction" : interpolator->GetNameOfClass();
  ModelEnum model = object.definition == ObjectType::DefinitionEnum::ISO_VALUE ? ModelEnum::GREY : ModelEnum::INDICATOR;
  if (interpolatorName == "NearestNeighborInterpolateImageFunction")
  {
    model = ModelEnum::NEAREST;
  }
  else if (interpolatorName != "LinearInterpolateImageFunction")
  {
    model = ModelEnum::FIELD;
    m_Interpolator = interpolator;
  }

  WithPredicate(object, [&](const auto & isObject) {
    ForEachRow(mask, threads, [&](std::int32_t y, std::int32_t z) {
      const PixelType * row = m_Buffer + y * m_Strides[1] + z * m_Strides[2];
      mask.SetRow(y, z, [&](std::int32_t x) { return isObject(row[x]); });
    });
  });
  if (model == ModelEnum::FIELD)
  {
    this->PrepareField(image, object, mask, threads);
  }

  this->InitializeAs(model, image, object, std::move(mask), threads);
  if (object.smoothingWidth > 0.0 && model == ModelEnum::INDICATOR)
  {
    this->Smooth(object.smoothingWidth);
  }
}

template <typename TImage>
void
ImageDelaunayRefinementOracle<TImage>::InitializeAs(ModelEnum                   model,
                                                    const ImageType *           image,
                                                    const ObjectType &          object,
                                                    DelaunayRefinementVoxelMask mask,
                                                    DelaunayRefinementThreads * threads)
{
  m_IsSelective = object.largestComponentOnly || object.minimumComponentSize > 1;
  if (object.regionLabels.size() < 2)
  {
    DelaunayRefinementVoxelComponents components(mask, threads);
    if (m_IsSelective)
    {
      RemoveComponents(object, components, mask);
    }
    this->Initialize(model, ComputeFrame(image), std::move(mask), std::move(components), threads);
    return;
  }
  if (m_IsSelective)
  {
    // Of the object as a whole.
    DelaunayRefinementVoxelComponents components(mask, threads);
    RemoveComponents(object, components, mask);
  }
  auto changes = std::make_unique<DelaunayRefinementRegionChanges>(mask.GetSize());
  ForEachRow(mask, threads, [&](std::int32_t y, std::int32_t z) {
    const std::uint64_t * const words = std::as_const(mask).GetRow(y + 1, z + 1);
    if (std::any_of(words, words + mask.GetWordsPerRow(), [](std::uint64_t word) { return word != 0; }))
    {
      changes->SetRow(y, z, m_Buffer + y * m_Strides[1] + z * m_Strides[2], m_Strides[1], m_Strides[2]);
    }
  });
  DelaunayRefinementVoxelComponents components(
    mask,
    *changes,
    [this](std::int32_t x, std::int32_t y, std::int32_t z) { return this->GetVoxelRegion(x, y, z); },
    threads);
  this->Initialize(model, ComputeFrame(image), std::move(mask), std::move(components), threads, std::move(changes));
}

template <typename TImage>
void
ImageDelaunayRefinementOracle<TImage>::RemoveComponents(const ObjectType &                  object,
                                                        DelaunayRefinementVoxelComponents & components,
                                                        DelaunayRefinementVoxelMask &       mask)
{
  const auto & infos = components.GetComponents();
  const auto   largest = std::max_element(
    infos.begin(), infos.end(), [](const auto & a, const auto & b) { return a.numberOfVoxels < b.numberOfVoxels; });
  std::vector<bool> isRemoved;
  for (auto info = infos.begin(); info != infos.end(); ++info)
  {
    isRemoved.push_back(info->numberOfVoxels < object.minimumComponentSize ||
                        (object.largestComponentOnly && info != largest));
  }
  components.Remove(isRemoved, mask);
}

template <typename TImage>
template <typename TAction>
void
ImageDelaunayRefinementOracle<TImage>::ForEachRow(const DelaunayRefinementVoxelMask & mask,
                                                  DelaunayRefinementThreads *         threads,
                                                  const TAction &                     action)
{
  using Threads = DelaunayRefinementThreads;
  constexpr std::size_t leastVoxels = 16384;
  const auto &          size = mask.GetSize();
  const std::size_t     rows = static_cast<std::size_t>(size[1]) * size[2];
  const std::size_t     length = Threads::ChoosePieceLength(threads, rows, 1 + leastVoxels / size[0]);
  Threads::RunPieces(threads, rows, length, [&](std::size_t, std::size_t begin, std::size_t end) {
    DelaunayRefinementVoxelMask::VisitRows(
      size, begin, end, [&action](std::size_t, std::int32_t y, std::int32_t z) { action(y, z); });
  });
}

template <typename TImage>
ImageDelaunayRefinementOracle<TImage>::~ImageDelaunayRefinementOracle()
{
  if (m_Interpolator.IsNotNull())
  {
    m_Interpolator->SetInputImage(nullptr);
  }
}

template <typename TImage>
typename ImageDelaunayRefinementOracle<TImage>::FrameType
ImageDelaunayRefinementOracle<TImage>::ComputeFrame(const ImageType * image)
{
  const auto &                  region = image->GetBufferedRegion();
  typename ImageType::PointType start;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), start);
  FrameType frame;
  for (unsigned int i = 0; i < 3; ++i)
  {
    // Over the whole image, so that little is lost to rounding far from the origin.
    auto index = region.GetIndex();
    index[i] += static_cast<IndexValueType>(region.GetSize(i));
    typename ImageType::PointType end;
    image->TransformIndexToPhysicalPoint(index, end);
    for (unsigned int j = 0; j < 3; ++j)
    {
      frame.axes[i][j] = (end[j] - start[j]) / static_cast<double>(region.GetSize(i));
    }
    frame.origin[i] = start[i];
  }
  return frame;
}

template <typename TImage>
template <typename TAction>
void
ImageDelaunayRefinementOracle<TImage>::WithPredicate(const ObjectType & object, const TAction & action)
{
  using DefinitionEnum = typename ObjectType::DefinitionEnum;
  switch (object.definition)
  {
    case DefinitionEnum::NON_ZERO:
      action([](PixelType value) { return value != PixelType{ 0 }; });
      break;
    case DefinitionEnum::LABELS:
      if (object.labels.size() == 1)
      {
        action([label = object.labels.front()](PixelType value) { return value == label; });
      }
      else
      {
        action([table = DelaunayRefinementLabelTable<PixelType>(object.labels)](PixelType value) {
          return table.Find(value) != 0;
        });
      }
      break;
    case DefinitionEnum::THRESHOLD:
      if constexpr (std::is_integral<PixelType>::value && sizeof(PixelType) < sizeof(float))
      {
        // The range in the pixels' own type, in which many are compared at once.
        using LimitsType = std::numeric_limits<PixelType>;
        const double lowest = LimitsType::lowest();
        const double highest = LimitsType::max();
        if (object.lower <= highest && object.upper >= lowest && std::ceil(object.lower) <= std::floor(object.upper))
        {
          const auto lower = static_cast<PixelType>(std::ceil(std::max(object.lower, lowest)));
          const auto upper = static_cast<PixelType>(std::floor(std::min(object.upper, highest)));
          action([lower, upper](PixelType value) { return (value >= lower) & (value <= upper); });
          break;
        }
      }
      action([lower = object.lower, upper = object.upper](PixelType value) {
        const auto real = static_cast<double>(value);
        return real >= lower && real <= upper;
      });
      break;
    case DefinitionEnum::ISO_VALUE:
      action([level = object.isoValue](PixelType value) { return static_cast<double>(value) >= level; });
      break;
  }
}

template <typename TImage>
void
ImageDelaunayRefinementOracle<TImage>::PrepareField(const ImageType *             image,
                                                    const ObjectType &            object,
                                                    DelaunayRefinementVoxelMask & mask,
                                                    DelaunayRefinementThreads *   threads)
{
  if (object.definition == ObjectType::DefinitionEnum::ISO_VALUE)
  {
    m_Interpolator->SetInputImage(image);
  }
  else
  {
    m_Indicator = ImageType::New();
    m_Indicator->CopyInformation(image);
    m_Indicator->SetRegions(image->GetBufferedRegion());
    m_Indicator->Allocate();
    PixelType * const pixels = m_Indicator->GetBufferPointer();
    ForEachRow(mask, threads, [&](std::int32_t y, std::int32_t z) {
      PixelType * row = pixels + y * m_Strides[1] + z * m_Strides[2];
      for (std::int32_t x = 0; x < mask.GetSize()[0]; ++x)
      {
        row[x] = static_cast<PixelType>(mask.Get(x, y, z) ? 1 : 0);
      }
    });
    m_Interpolator->SetInputImage(m_Indicator);
  }
  // B-splines keep the voxels' values; any other interpolator may change them.
  if (std::string(m_Interpolator->GetNameOfClass()) != "BSplineInterpolateImageFunction")
  {
    ForEachRow(mask, threads, [&](std::int32_t y, std::int32_t z) {
      // Asked once for each voxel, as interpolators take their time.
      std::vector<std::uint8_t> isInside(mask.GetSize()[0]);
      for (std::int32_t x = 0; x < mask.GetSize()[0]; ++x)
      {
        const PointType position{ static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) };
        isInside[x] = this->IsInsideField(position) ? 1 : 0;
      }
      mask.SetRow(y, z, [&isInside](std::int32_t x) { return isInside[x] != 0; });
    });
  }
}

template <typename TImage>
double
ImageDelaunayRefinementOracle<TImage>::GetVoxelValue(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  // Infinite values would leave no number after interpolation.
  constexpr double largest = 1e30;
  const auto       value = static_cast<double>(m_Buffer[x + y * m_Strides[1] + z * m_Strides[2]]);
  return std::clamp(value - m_Level, -largest, largest);
}

template <typename TImage>
auto
ImageDelaunayRefinementOracle<TImage>::GetVoxelRegion(std::int32_t x, std::int32_t y, std::int32_t z) const
  -> RegionType
{
  return m_Regions.Find(m_Buffer[x + y * m_Strides[1] + z * m_Strides[2]]);
}

template <typename TImage>
void
ImageDelaunayRefinementOracle<TImage>::GetVoxelRegions(const std::array<std::int32_t, 3> & first,
                                                       unsigned int                        voxels,
                                                       std::array<RegionType, 8> &         regions) const
{
  for (std::int32_t i = 0; i < 8; ++i)
  {
    if (voxels >> i & 1u)
    {
      regions[i] =
        ImageDelaunayRefinementOracle::GetVoxelRegion(first[0] + (i & 1), first[1] + (i >> 1 & 1), first[2] + (i >> 2));
    }
  }
}

template <typename TImage>
bool
ImageDelaunayRefinementOracle<TImage>::MayHaveJunctions(const std::array<std::int32_t, 3> & first) const
{
  // Some more voxels of each row make it as long as processors like.
  constexpr std::array<std::int32_t, 3> lengths{ 8, 5, 5 };
  bool                                  isInImage = true;
  for (unsigned int i = 0; i < 3; ++i)
  {
    isInImage = isInImage && first[i] >= 0 && first[i] + lengths[i] <= m_Size[i];
  }
  if (!isInImage || m_IsSelective)
  {
    return true;
  }

  // Two values make no more than two regions: each is the least or the greatest.
  using RowType = std::array<PixelType, lengths[0]>;
  RowType rows[lengths[1] * lengths[2]];
  RowType least;
  RowType greatest;
  for (std::int32_t i = 0; i < lengths[1] * lengths[2]; ++i)
  {
    const std::int32_t y = first[1] + i % lengths[1];
    const std::int32_t z = first[2] + i / lengths[1];
    std::copy_n(m_Buffer + first[0] + y * m_Strides[1] + z * m_Strides[2], lengths[0], rows[i].data());
    if (i == 0)
    {
      least = greatest = rows[0];
    }
    for (std::int32_t x = 0; x < lengths[0]; ++x)
    {
      least[x] = std::min(least[x], rows[i][x]);
      greatest[x] = std::max(greatest[x], rows[i][x]);
    }
  }
  const PixelType low = *std::min_element(least.begin(), least.end());
  const PixelType high = *std::max_element(greatest.begin(), greatest.end());
  bool            areTwo = true;
  for (const RowType & row : rows)
  {
    for (const PixelType value : row)
    {
      areTwo = areTwo & ((value == low) | (value == high));
    }
  }
  return !areTwo;
}

template <typename TImage>
bool
ImageDelaunayRefinementOracle<TImage>::IsInsideField(const PointType & position) const
{
  typename InterpolatorType::ContinuousIndexType index;
  for (unsigned int i = 0; i < 3; ++i)
  {
    index[i] = static_cast<double>(m_Start[i]) + position[i];
  }
  return m_Interpolator->IsInsideBuffer(index) && m_Interpolator->EvaluateAtContinuousIndex(index) >= m_Level;
}
} // end namespace itk

#endif
