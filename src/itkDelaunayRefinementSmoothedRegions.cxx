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
#include <functional>
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
      const auto & axes = m_Kernels[key.second].axes;
      if (std::all_of(axes.begin(), axes.end(), [](const KernelType & kernel) { return kernel.taps.size() == 1; }))
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
  /** A region's voxels that are smoothed alike, in a block and as far around as their kernels reach. */
  struct WindowType
  {
    std::int32_t                           reach{ 0 };
    std::int32_t                           side{ 0 };
    std::vector<float>                     values{}; // 1 where the region is
    DelaunayRefinementArray<std::uint16_t> filled{}; // how many voxels of each row are 1
  };

  using KeyType = std::pair<DelaunayRefinementRegion, std::uint32_t>;

  void
  Gather(const IndexType & first)
  {
    m_Windows.clear();
    for (std::int32_t z = -m_Reach; z < BlockSize + m_Reach; ++z)
    {
      for (std::int32_t y = -m_Reach; y < BlockSize + m_Reach; ++y)
      {
        const std::int32_t voxelY = first[1] + y - 1;
        const std::int32_t voxelZ = first[2] + z - 1;
        if (voxelY >= 0 && voxelY < m_Size[1] && voxelZ >= 0 && voxelZ < m_Size[2])
        {
          this->GatherRow(first[0] - 1, voxelY, voxelZ, y, z);
        }
      }
    }
  }

  /** The runs of a row of voxels, each as far from the block as its kernels reach: \c start is the block's first voxel
   * along x, \c y and \c z are counted from the block. */
  void
  GatherRow(std::int32_t start, std::int32_t voxelY, std::int32_t voxelZ, std::int32_t y, std::int32_t z)
  {
    const auto & runs = m_Components.GetRuns();
    const auto   begin = runs.begin() + static_cast<std::ptrdiff_t>(m_Components.GetFirstRun(voxelY, voxelZ));
    const auto   end = runs.begin() + static_cast<std::ptrdiff_t>(m_Components.GetFirstRun(voxelY + 1, voxelZ));
    const auto   distance = [](std::int32_t place) { return std::max(-place, place - BlockSize + 1); };
    const auto   leastReach = std::max(distance(y), distance(z));
    auto         run = std::partition_point(begin, end, [&](const auto & r) { return r.last < start - m_Reach; });
    for (; run != end && run->first < start + BlockSize + m_Reach; ++run)
    {
      const std::uint32_t kernel = m_KernelOf[run->component];
      const std::int32_t  reach = m_Kernels[kernel].reach;
      const std::int32_t  from = std::max(run->first - start + reach, 0);
      const std::int32_t  to = std::min(run->last + 1 - start + reach, BlockSize + 2 * reach);
      if (leastReach > reach || from >= to)
      {
        continue;
      }
      WindowType & window = m_Windows[{ m_Components.GetComponents()[run->component].region, kernel }];
      if (window.values.empty())
      {
        window.reach = reach;
        window.side = BlockSize + 2 * reach;
        window.values.assign(static_cast<std::size_t>(window.side) * window.side * window.side, 0.0f);
        window.filled.assign(static_cast<std::size_t>(window.side) * window.side, 0);
      }
      const std::size_t row = static_cast<std::size_t>(z + reach) * window.side + y + reach;
      window.filled[row] = static_cast<std::uint16_t>(window.filled[row] + to - from);
      std::fill_n(window.values.begin() + static_cast<std::ptrdiff_t>(row * window.side + from), to - from, 1.0f);
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
      const std::size_t x = i % BlockSize + window.reach;
      const std::size_t y = i / BlockSize % BlockSize + window.reach;
      const std::size_t z = i / (BlockSize * BlockSize) + window.reach;
      if (window.values[(z * window.side + y) * window.side + x] != 0.0f)
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
    const std::size_t     side = window.side;
    const std::size_t     margin = window.reach - 1;
    m_AlongX.assign(side * side * size, 0.0f);
    for (std::size_t row = 0; row < side * side; ++row)
    {
      float * const to = m_AlongX.data() + row * size;
      if (window.filled[row] == side)
      {
        std::fill_n(to, size, 1.0f);
      }
      else if (window.filled[row] != 0)
      {
        Convolve<size>(window.values.data() + row * side + margin, 1, kernels.axes[0], to);
      }
    }
    m_AlongY.assign(side * layer, 0.0f);
    for (std::size_t z = 0; z < side; ++z)
    {
      const auto rows = window.filled.begin() + static_cast<std::ptrdiff_t>(z * side);
      if (std::all_of(rows, rows + static_cast<std::ptrdiff_t>(side), [](std::uint16_t filled) { return filled == 0; }))
      {
        continue;
      }
      for (std::size_t y = 0; y < size; ++y)
      {
        Convolve<size>(m_AlongX.data() + (z * side + y + margin) * size,
                       size,
                       kernels.axes[1],
                       m_AlongY.data() + (z * size + y) * size);
      }
    }
    m_Smooth.assign(size * layer, 0.0f);
    for (std::size_t z = 0; z < size; ++z)
    {
      Convolve<layer>(m_AlongY.data() + (z + margin) * layer, layer, kernels.axes[2], m_Smooth.data() + z * layer);
    }
    for (std::size_t i = 0; i < BlockVolume; ++i)
    {
      const float * at = m_Smooth.data() + (1 + i % BlockSize) + size * (1 + i / BlockSize % BlockSize) +
                         layer * (1 + i / (BlockSize * BlockSize));
      sums[i] += *at - kernels.axes[0].correction * (at[1] - 2.0f * at[0] + *(at - 1)) -
                 kernels.axes[1].correction * (at[size] - 2.0f * at[0] + *(at - size)) -
                 kernels.axes[2].correction * (at[layer] - 2.0f * at[0] + *(at - layer));
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
        kernels.back().axes[i] = MakeKernel(width / m_Spacing[i]);
        kernels.back().reach = std::max(kernels.back().reach, kernels.back().axes[i].radius + 1);
      }
    }
    kernelOf.push_back(place.first->second);
    reach = std::max(reach, kernels[kernelOf.back()].reach);
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
DelaunayRefinementSmoothedRegions::CountGains(DelaunayRefinementThreads * threads) const
{
  using Threads = DelaunayRefinementThreads;
  // Each piece has its own list of components, which is to be shorter than its voxels.
  const std::size_t                        numberOfComponents = m_Components.GetComponents().size();
  const std::size_t                        leastLength = 256 + 4 * numberOfComponents / BlockVolume;
  const std::size_t                        length = Threads::ChoosePieceLength(threads, m_Blocks.size(), leastLength);
  std::vector<std::vector<std::ptrdiff_t>> gains(Threads::CountPieces(m_Blocks.size(), length) + 1);
  gains.front().assign(numberOfComponents, 0);
  Threads::RunPieces(threads, m_Blocks.size(), length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    gains[piece + 1].assign(numberOfComponents, 0);
    for (std::size_t i = begin; i < end; ++i)
    {
      this->CountGainsInBlock(m_Blocks[i], gains[piece + 1]);
    }
  });
  for (std::size_t piece = 1; piece < gains.size(); ++piece)
  {
    std::transform(
      gains[piece].begin(), gains[piece].end(), gains.front().begin(), gains.front().begin(), std::plus<>());
  }
  return gains.front();
}

void
DelaunayRefinementSmoothedRegions::CountGainsInBlock(const BlockType & block, std::vector<std::ptrdiff_t> & gains) const
{
  const auto & infos = m_Components.GetComponents();
  for (std::size_t place = 0; place < BlockVolume; ++place)
  {
    const IndexType                voxel = ToVoxel(block, place);
    const DelaunayRefinementRegion region = block.regions[place];
    const std::uint32_t            before = this->FindComponent(voxel);
    if ((before == None ? 0 : infos[before].region) == region)
    {
      continue;
    }
    if (before != None)
    {
      --gains[before];
    }
    // A component next to the voxel has won it.
    bool isWon = region == 0;
    for (std::int32_t i = 0; i < 27 && !isWon; ++i)
    {
      const IndexType     next{ voxel[0] + i % 3 - 1, voxel[1] + i / 3 % 3 - 1, voxel[2] + i / 9 - 1 };
      const std::uint32_t winner = this->FindComponent(next);
      if (winner != None && infos[winner].region == region)
      {
        ++gains[winner];
        isWon = true;
      }
    }
  }
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
