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
#ifndef itkDelaunayRefinementRegionChanges_h
#define itkDelaunayRefinementRegionChanges_h

#include "itkDelaunayRefinementTypes.h"
#include "itkDelaunayRefinementVoxelMask.h"

namespace itk
{
/** \class DelaunayRefinementRegionChanges
 * \brief Where voxels differ from the one before them along each axis: a bit each, with one layer all around.
 *
 * What it says of voxels that are not both in the object is of no matter.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementRegionChanges
{
public:
  /** No voxel differs from another. */
  explicit DelaunayRefinementRegionChanges(const DelaunayRefinementVoxelMask::SizeType & size)
    : m_Masks{ DelaunayRefinementVoxelMask(size), DelaunayRefinementVoxelMask(size), DelaunayRefinementVoxelMask(size) }
  {}

  /** Compares the row of voxels (y, z) with its neighbors; \c row points to its first voxel in a buffer whose rows and
   * slices are so many voxels apart. Rows may be set in parallel. */
  template <typename TVoxel>
  void
  SetRow(std::int32_t y, std::int32_t z, const TVoxel * row, std::size_t rowStride, std::size_t sliceStride)
  {
    const auto compare = [row](std::size_t stride) {
      return [row, before = row - stride](std::int32_t x) { return row[x] != before[x]; };
    };
    if (y == 0 && z == 0)
    {
      m_Masks[0].SetRow(y, z, [row](std::int32_t x) { return x > 0 && row[x] != row[x - 1]; });
    }
    else
    {
      // The first voxel, with none before it, is compared with the last of another row.
      m_Masks[0].SetRow(y, z, compare(1));
    }
    if (y > 0)
    {
      m_Masks[1].SetRow(y, z, compare(rowStride));
    }
    if (z > 0)
    {
      m_Masks[2].SetRow(y, z, compare(sliceStride));
    }
  }

  /** Says whether voxel (x, y, z) differs from the one before it along an axis. */
  void
  Set(unsigned int axis, std::int32_t x, std::int32_t y, std::int32_t z, bool differs)
  {
    m_Masks[axis].Set(x, y, z, differs);
  }

  /** The words of a row, as those of a mask. */
  const std::uint64_t *
  GetRow(unsigned int axis, std::int32_t paddedY, std::int32_t paddedZ) const
  {
    return m_Masks[axis].GetRow(paddedY, paddedZ);
  }

private:
  std::array<DelaunayRefinementVoxelMask, 3> m_Masks;
};
} // end namespace itk

#endif
