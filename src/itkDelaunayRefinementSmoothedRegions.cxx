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
#include "itkDelaunayRefinementSmoothedRegions.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace itk
{
namespace
{
/** Gaussians end at this many standard deviations. */
constexpr double Cutoff = 3.0;

/** What is left of a Gaussian by the correction is as smooth as one of half the width. */
constexpr double CorrectedWidth = 2.0;

/** Narrower ones, in voxels, change nothing. */
constexpr double LeastWidth = 0.2;

/** Linear interpolation between voxels smooths by this second moment, in voxels squared. */
constexpr double MomentOfInterpolation = 1.0 / 6.0;

/** Weights below this decide nothing. */
constexpr float LeastWeight = 1e-3f;
} // namespace

/** \class DelaunayRefinementSmoothedRegions::BlockSmoother
 * \brief Smooths one block after the other, on one thread. */
class DelaunayRefinementSmoothedRegions::BlockSmoother
{
public:
  /** The kernels of each component, by their numbers in \c kernels. */
  BlockSmoother(const DelaunayRefinementVoxelComponents & components,
                const DelaunayRefinementVoxelMask &       mask,
                const std::vector<KernelsType> &          kernels,
                const std::vector<std::uint32_t> &        kernelOf,
                std::int32_t                              reach)
    : m_Components(components)
    , m_Size(mask.GetSize())
    , m_Kernels(kernels)
    , m_KernelOf(kernelOf)
    , m_Reach(reach)
    , m_Side(BlockSize + 2 * reach)
  {}

  void
  Smooth(BlockType & block)
  {
    this->Gather(block.first);
    std::map<DelaunayRefinementRegion, WeightsType> sums;
    for (const auto & [key, window] : m_Windows)
    {
      const auto place = sums.try_emplace(key.first, WeightsType{}).first;
      this->AddSmoothed(window, m_Kernels[key.second], place->second);
    }
    for (const auto & [key, window] : m_Windows)
    {
      if (m_Kernels[key.second][0].taps.size() == 1 && m_Kernels[key.second][1].taps.size() == 1 &&
          m_Kernels[key.second][2].taps.size() == 1)
      {
        this->KeepAsTheyAre(window, key.first, sums);
      }
    }
    block.together = {};
    block.weighted.clear();
    block.weights.clear();
    for (const auto & [region, weights] : sums)
    {
      for (std::size_t i = 0; i < BlockVolume; ++i)
      {
        block.together[i] += weights[i];
      }
      if (*std::max_element(weights.begin(), weights.end()) >= LeastWeight)
      {
        block.weighted.push_back(region);
        block.weights.push_back(weights);
      }
    }
    for (std::size_t i = 0; i < BlockVolume; ++i)
    {
      block.regions[i] = 0;
      float largest = 0.0f;
      for (std::size_t j = 0; j < block.weighted.size() && block.together[i] >= 0.5f; ++j)
      {
        if (block.weights[j][i] > largest)
        {
          largest = block.weights[j][i];
          block.regions[i] = block.weighted[j];
        }
      }
    }
  }

private:
  /** A region's voxels that are smoothed alike; 1 where it is. */
  using WindowType = std::vector<float>;
  using KeyType = std::pair<DelaunayRefinementRegion, std::uint32_t>;

  void
  Gather(const IndexType & first)
  {
    m_Windows.clear();
    for (std::int32_t z = 0; z < m_Side; ++z)
    {
      const std::int32_t voxelZ = first[2] + z - m_Reach - 1;
      for (std::int32_t y = 0; y < m_Side && voxelZ >= 0 && voxelZ < m_Size[2]; ++y)
      {
        const std::int32_t voxelY = first[1] + y - m_Reach - 1;
        if (voxelY >= 0 && voxelY < m_Size[1])
        {
          this->GatherRow(first[0] - m_Reach - 1, voxelY, voxelZ, (static_cast<std::size_t>(z) * m_Side + y) * m_Side);
        }
      }
    }
  }

  /** The runs of a row from a voxel. */
  void
  GatherRow(std::int32_t start, std::int32_t y, std::int32_t z, std::size_t offset)
  {
    const auto & runs = m_Components.GetRuns();
    const auto   begin = runs.begin() + static_cast<std::ptrdiff_t>(m_Components.GetFirstRun(y, z));
    const auto   end = runs.begin() + static_cast<std::ptrdiff_t>(m_Components.GetFirstRun(y + 1, z));
    auto         run = std::partition_point(begin, end, [start](const auto & r) { return r.last < start; });
    for (; run != end && run->first < start + m_Side; ++run)
    {
      const DelaunayRefinementRegion region = m_Components.GetComponents()[run->component].region;
      WindowType &                   window = m_Windows[{ region, m_KernelOf[run->component] }];
      if (window.empty())
      {
        window.assign(static_cast<std::size_t>(m_Side) * m_Side * m_Side, 0.0f);
      }
      const std::int32_t from = std::max(run->first, start) - start;
      const std::int32_t to = std::min(run->last, start + m_Side - 1) - start;
      std::fill(window.begin() + static_cast<std::ptrdiff_t>(offset + from),
                window.begin() + static_cast<std::ptrdiff_t>(offset + to + 1),
                1.0f);
    }
  }

  /** All weight at a region's voxels is its own. */
  void
  KeepAsTheyAre(const WindowType &                                window,
                DelaunayRefinementRegion                          region,
                std::map<DelaunayRefinementRegion, WeightsType> & sums) const
  {
    for (std::size_t i = 0; i < BlockVolume; ++i)
    {
      const std::size_t x = i % BlockSize + m_Reach;
      const std::size_t y = i / BlockSize % BlockSize + m_Reach;
      const std::size_t z = i / (BlockSize * BlockSize) + m_Reach;
      if (window[(z * m_Side + y) * m_Side + x] != 0.0f)
      {
        for (auto & [other, weights] : sums)
        {
          weights[i] = other == region ? 1.0f : 0.0f;
        }
      }
    }
  }

  /** Along x, y and z, with a voxel more on all sides of the block. */
  void
  AddSmoothed(const WindowType & window, const KernelsType & kernels, WeightsType & sums)
  {
    constexpr std::size_t size = BlockSize + 2;
    constexpr std::size_t layer = size * size;
    const std::size_t     side = m_Side;
    const std::size_t     margin = m_Reach - 1;
    m_AlongX.assign(side * side * size, 0.0f);
    for (std::size_t row = 0; row < side * side; ++row)
    {
      Convolve<size>(window.data() + row * side + margin, 1, kernels[0], m_AlongX.data() + row * size);
    }
    m_AlongY.assign(side * layer, 0.0f);
    for (std::size_t z = 0; z < side; ++z)
    {
      for (std::size_t y = 0; y < size; ++y)
      {
        Convolve<size>(
          m_AlongX.data() + (z * side + y + margin) * size, size, kernels[1], m_AlongY.data() + (z * size + y) * size);
      }
    }
    m_Smooth.assign(size * layer, 0.0f);
    for (std::size_t z = 0; z < size; ++z)
    {
      Convolve<layer>(m_AlongY.data() + (z + margin) * layer, layer, kernels[2], m_Smooth.data() + z * layer);
    }
    for (std::size_t i = 0; i < BlockVolume; ++i)
    {
      const float * at = m_Smooth.data() + (1 + i % BlockSize) + size * (1 + i / BlockSize % BlockSize) +
                         layer * (1 + i / (BlockSize * BlockSize));
      sums[i] += *at - kernels[0].correction * (at[1] - 2.0f * at[0] + *(at - 1)) -
                 kernels[1].correction * (at[size] - 2.0f * at[0] + *(at - size)) -
                 kernels[2].correction * (at[layer] - 2.0f * at[0] + *(at - layer));
    }
  }

  /** Adds to numbers that follow each other, from numbers that do and those a multiple of \c stride away. */
  template <std::size_t VLength>
  static void
  Convolve(const float * from, std::size_t stride, const KernelType & kernel, float * to)
  {
    const float * source = from - static_cast<std::size_t>(kernel.radius) * stride;
    for (const float tap : kernel.taps)
    {
      for (std::size_t i = 0; i < VLength; ++i)
      {
        to[i] += tap * source[i];
      }
      source += stride;
    }
  }

  const DelaunayRefinementVoxelComponents &     m_Components;
  const DelaunayRefinementVoxelMask::SizeType & m_Size;
  const std::vector<KernelsType> &              m_Kernels;
  const std::vector<std::uint32_t> &            m_KernelOf;
  std::int32_t                                  m_Reach;
  std::int32_t                                  m_Side;
  std::map<KeyType, WindowType>                 m_Windows{};
  std::vector<float>                            m_AlongX{};
  std::vector<float>                            m_AlongY{};
  std::vector<float>                            m_Smooth{};
};

DelaunayRefinementSmoothedRegions::DelaunayRefinementSmoothedRegions(
  const DelaunayRefinementVoxelMask &       mask,
  const DelaunayRefinementVoxelComponents & components,
  const DelaunayRefinementBricks &          bricks,
  const std::array<double, 3> &             spacing)
  : m_Mask(mask)
  , m_Components(components)
  , m_Bricks(bricks)
  , m_Spacing(spacing)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_NumberOfBlocks[i] = (mask.GetSize()[i] + 2 + BlockSize - 1) / BlockSize;
  }
}

DelaunayRefinementSmoothedRegions::KernelType
DelaunayRefinementSmoothedRegions::MakeKernel(double width)
{
  KernelType kernel;
  if (!(width > LeastWidth))
  {
    kernel.taps.push_back(1.0f);
    return kernel;
  }
  width *= CorrectedWidth;
  kernel.radius = static_cast<std::int32_t>(std::ceil(Cutoff * width));
  std::vector<double> samples;
  double              sum = 0.0;
  double              moment = 0.0;
  for (std::int32_t i = -kernel.radius; i <= kernel.radius; ++i)
  {
    samples.push_back(std::exp(-0.5 * i * i / (width * width)));
    sum += samples.back();
    moment += i * i * samples.back();
  }
  std::transform(samples.begin(), samples.end(), std::back_inserter(kernel.taps), [sum](double sample) {
    return static_cast<float>(sample / sum);
  });
  kernel.correction = static_cast<float>(moment / sum + MomentOfInterpolation);
  return kernel;
}

void
DelaunayRefinementSmoothedRegions::FindBlocks()
{
  m_Blocks.clear();
  m_Numbers.assign(static_cast<std::size_t>(m_NumberOfBlocks[0]) * m_NumberOfBlocks[1] * m_NumberOfBlocks[2], None);
  std::size_t offset = 0;
  for (std::int32_t z = 0; z < m_NumberOfBlocks[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_NumberOfBlocks[1]; ++y)
    {
      for (std::int32_t x = 0; x < m_NumberOfBlocks[0]; ++x, ++offset)
      {
        // Cell n is between voxels n and n + 1.
        const IndexType first{ BlockSize * x, BlockSize * y, BlockSize * z };
        IndexType       low;
        IndexType       high;
        for (unsigned int i = 0; i < 3; ++i)
        {
          low[i] = first[i] - m_Reach;
          high[i] = first[i] + BlockSize - 2 + m_Reach;
        }
        if (m_Bricks.IsAnyActive(low, high))
        {
          m_Numbers[offset] = static_cast<std::uint32_t>(m_Blocks.size());
          m_Blocks.emplace_back();
          m_Blocks.back().first = first;
        }
      }
    }
  }
}

void
DelaunayRefinementSmoothedRegions::Smooth(const WidthsType & widths, DelaunayRefinementThreads * threads)
{
  std::map<double, std::uint32_t> numbers;
  std::vector<KernelsType>        kernels;
  std::vector<std::uint32_t>      kernelOf;
  std::int32_t                    reach = 1;
  for (const double width : widths)
  {
    const auto place = numbers.try_emplace(width, static_cast<std::uint32_t>(kernels.size()));
    if (place.second)
    {
      kernels.emplace_back();
      for (unsigned int i = 0; i < 3; ++i)
      {
        kernels.back()[i] = MakeKernel(width / m_Spacing[i]);
        reach = std::max(reach, kernels.back()[i].radius + 1);
      }
    }
    kernelOf.push_back(place.first->second);
  }
  if (m_Widths.empty())
  {
    m_Reach = reach;
    this->FindBlocks();
  }
  const std::vector<std::size_t> stale = this->FindStaleBlocks(widths);
  m_Widths = widths;
  constexpr std::size_t blocksPerPiece = 64;
  DelaunayRefinementThreads::RunPieces(
    threads, stale.size(), blocksPerPiece, [&](std::size_t, std::size_t begin, std::size_t end) {
      BlockSmoother smoother(m_Components, m_Mask, kernels, kernelOf, reach);
      for (std::size_t i = begin; i < end; ++i)
      {
        BlockType & block = m_Blocks[stale[i]];
        smoother.Smooth(block);
        for (std::size_t place = 0; place < BlockVolume; ++place)
        {
          block.regions[place] = this->IsInImage(ToVoxel(block, place)) ? block.regions[place] : 0;
        }
      }
    });
}

std::vector<std::size_t>
DelaunayRefinementSmoothedRegions::FindStaleBlocks(const WidthsType & widths) const
{
  std::vector<bool> isStale(m_Blocks.size(), m_Widths.empty());
  for (std::size_t i = 0; i < m_Widths.size(); ++i)
  {
    if (widths[i] == m_Widths[i])
    {
      continue;
    }
    const auto & info = m_Components.GetComponents()[i];
    IndexType    first;
    IndexType    last;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::max(0, info.minimum[axis] + 1 - m_Reach) / BlockSize;
      last[axis] = std::min(m_NumberOfBlocks[axis] - 1, (info.maximum[axis] + 1 + m_Reach) / BlockSize);
    }
    for (std::int32_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::int32_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::int32_t x = first[0]; x <= last[0]; ++x)
        {
          const std::uint32_t number = m_Numbers[this->ToOffset({ BlockSize * x, BlockSize * y, BlockSize * z })];
          if (number != None)
          {
            isStale[number] = true;
          }
        }
      }
    }
  }
  std::vector<std::size_t> stale;
  for (std::size_t i = 0; i < isStale.size(); ++i)
  {
    if (isStale[i])
    {
      stale.push_back(i);
    }
  }
  return stale;
}

std::uint32_t
DelaunayRefinementSmoothedRegions::FindComponent(const IndexType & voxel) const
{
  const IndexType v{ voxel[0] - 1, voxel[1] - 1, voxel[2] - 1 };
  return this->IsInImage(voxel) && m_Mask.Get(v[0], v[1], v[2]) ? m_Components.Find(v[0], v[1], v[2]) : None;
}

std::vector<std::ptrdiff_t>
DelaunayRefinementSmoothedRegions::CountGains() const
{
  const auto &                infos = m_Components.GetComponents();
  std::vector<std::ptrdiff_t> gains(infos.size(), 0);
  this->ForEachVoxel([&](const IndexType & voxel, DelaunayRefinementRegion region) {
    const std::uint32_t before = this->FindComponent(voxel);
    if ((before == None ? 0 : infos[before].region) == region)
    {
      return;
    }
    if (before != None)
    {
      --gains[before];
    }
    // A component next to the voxel has won it.
    for (std::int32_t i = 0; i < 27 && region != 0; ++i)
    {
      const IndexType     next{ voxel[0] + i % 3 - 1, voxel[1] + i / 3 % 3 - 1, voxel[2] + i / 9 - 1 };
      const std::uint32_t winner = this->FindComponent(next);
      if (winner != None && infos[winner].region == region)
      {
        ++gains[winner];
        return;
      }
    }
  });
  return gains;
}

double
DelaunayRefinementSmoothedRegions::GetWeight(const IndexType & voxel) const
{
  return static_cast<double>(m_Blocks[m_Numbers[this->ToOffset(voxel)]].together[ToPlace(voxel)]);
}

void
DelaunayRefinementSmoothedRegions::SetWeights(const IndexType &               voxel,
                                              unsigned int                    corner,
                                              double                          factor,
                                              DelaunayRefinementRegionsCell & cell) const
{
  const BlockType & block = m_Blocks[m_Numbers[this->ToOffset(voxel)]];
  cell.SetUnion(corner, factor * static_cast<double>(block.together[ToPlace(voxel)]));
  for (std::size_t i = 0; i < block.weighted.size(); ++i)
  {
    const float weight = block.weights[i][ToPlace(voxel)];
    if (weight >= LeastWeight)
    {
      cell.Add(block.weighted[i], corner, factor * static_cast<double>(weight));
    }
  }
}
} // end namespace itk
