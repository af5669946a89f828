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
#ifndef itkDelaunayRefinementSmoothedRegions_h
#define itkDelaunayRefinementSmoothedRegions_h

#include "itkDelaunayRefinementBricks.h"
#include "itkDelaunayRefinementRegionCells.h"
#include "itkDelaunayRefinementVoxelComponents.h"

namespace itk
{
/** \class DelaunayRefinementSmoothedRegions
 * \brief Weights of regions at voxels: their indicators, smoothed, each component by a width of its own.
 *
 * Kept near changes between regions alone, in blocks of 8 x 8 x 8 voxels; elsewhere voxels are as they were. A
 * Gaussian moves a surface by its variance times the mean curvature; less its variance times the Laplacian of the
 * result leaves curved surfaces where they are, and only what is shorter than the width is smoothed away.
 *
 * Voxels are counted from the outer layer, x = 0 there.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementSmoothedRegions
{
public:
  using IndexType = std::array<std::int32_t, 3>;
  using WidthsType = std::vector<double>;

  /** Nothing is smoothed yet. What is given must be there as long as this. \c spacing is that of the voxels (mm). */
  DelaunayRefinementSmoothedRegions(const DelaunayRefinementVoxelMask &       mask,
                                    const DelaunayRefinementVoxelComponents & components,
                                    const DelaunayRefinementBricks &          bricks,
                                    const std::array<double, 3> &             spacing);

  /** Smooths by the width of each component (mm); 0 leaves a component as it is. Again with other widths, none larger
   * than the largest before, it only looks at what is near components whose width is another one. */
  void
  Smooth(const WidthsType & widths, DelaunayRefinementThreads * threads);

  /** How many voxels each component has more than before; fewer if negative. */
  std::vector<std::ptrdiff_t>
  CountGains(DelaunayRefinementThreads * threads) const;

  /** Calls \c action with each voxel that is kept here, places beyond the image included, and its region now. */
  template <typename TAction>
  void
  ForEachVoxel(const TAction & action) const
  {
    for (const BlockType & block : m_Blocks)
    {
      for (std::size_t i = 0; i < BlockVolume; ++i)
      {
        action(ToVoxel(block, i), block.regions[i]);
      }
    }
  }

  /** Whether a voxel's region and weights are kept here. */
  bool
  Has(const IndexType & voxel) const
  {
    return m_Numbers[this->ToOffset(voxel)] != None;
  }

  /** The region of a voxel that is kept here. */
  DelaunayRefinementRegion
  GetRegion(const IndexType & voxel) const
  {
    return m_Blocks[m_Numbers[this->ToOffset(voxel)]].regions[ToPlace(voxel)];
  }

  /** The weight of all regions together at a voxel that is kept here. */
  double
  GetWeight(const IndexType & voxel) const;

  /** Sets the weights at a corner of a cell to those of a voxel that is kept here, times a factor. */
  void
  SetWeights(const IndexType & voxel, unsigned int corner, double factor, DelaunayRefinementRegionsCell & cell) const;

private:
  static constexpr std::int32_t  BlockSize = 8;
  static constexpr std::size_t   BlockVolume = 512;
  static constexpr std::uint32_t None = 0xFFFFFFFFu;

  using WeightsType = std::array<float, BlockVolume>;

  /** Weights by regions, ascending, and of all together; the region that has each voxel. */
  struct BlockType
  {
    IndexType                                         first{};
    WeightsType                                       together{};
    std::vector<DelaunayRefinementRegion>             weighted{};
    std::vector<WeightsType>                          weights{};
    std::array<DelaunayRefinementRegion, BlockVolume> regions{};
  };

  struct KernelType
  {
    std::vector<float> taps{};
    std::int32_t       radius{ 0 };
    float              correction{ 0.0f }; // of second differences
  };

  /** Of a Gaussian's standard deviation in voxels. */
  static KernelType
  MakeKernel(double width);

  /** Kernels along the axes for one width. */
  struct KernelsType
  {
    std::array<KernelType, 3> axes{};
    std::int32_t              reach{ 1 }; // of the widest, and one voxel more
  };

  class BlockSmoother;

  void
  FindBlocks();

  void
  CountGainsInBlock(const BlockType & block, std::vector<std::ptrdiff_t> & gains) const;

  /** The blocks near components whose width is another one now; all the first time. */
  std::vector<std::size_t>
  FindStaleBlocks(const WidthsType & widths) const;

  std::size_t
  ToOffset(const IndexType & voxel) const
  {
    return (static_cast<std::size_t>(voxel[2] / BlockSize) * m_NumberOfBlocks[1] + voxel[1] / BlockSize) *
             m_NumberOfBlocks[0] +
           voxel[0] / BlockSize;
  }

  static std::size_t
  ToPlace(const IndexType & voxel)
  {
    return static_cast<std::size_t>(voxel[0] % BlockSize + BlockSize * (voxel[1] % BlockSize) +
                                    BlockSize * BlockSize * (voxel[2] % BlockSize));
  }

  static IndexType
  ToVoxel(const BlockType & block, std::size_t place)
  {
    const auto i = static_cast<std::int32_t>(place);
    return { block.first[0] + i % BlockSize,
             block.first[1] + i / BlockSize % BlockSize,
             block.first[2] + i / (BlockSize * BlockSize) };
  }

  bool
  IsInImage(const IndexType & voxel) const
  {
    const auto & size = m_Mask.GetSize();
    return voxel[0] > 0 && voxel[1] > 0 && voxel[2] > 0 && voxel[0] <= size[0] && voxel[1] <= size[1] &&
           voxel[2] <= size[2];
  }

  /** The component of a voxel before; None for one outside. */
  std::uint32_t
  FindComponent(const IndexType & voxel) const;

  const DelaunayRefinementVoxelMask &       m_Mask;
  const DelaunayRefinementVoxelComponents & m_Components;
  const DelaunayRefinementBricks &          m_Bricks;
  std::array<double, 3>                     m_Spacing;
  IndexType                                 m_NumberOfBlocks{};
  std::vector<std::uint32_t>                m_Numbers{};
  std::vector<BlockType>                    m_Blocks{};
  std::int32_t                              m_Reach{ 0 }; // of the widest kernel there was, in voxels
  WidthsType                                m_Widths{};
};
} // end namespace itk

#endif
