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
#ifndef itkDelaunayRefinementVoxelCavities_h
#define itkDelaunayRefinementVoxelCavities_h

#include "itkDelaunayRefinementVoxelComponents.h"

namespace itk
{
/** \class DelaunayRefinementVoxelCavities
 * \brief The cavities of a mask: voxels outside that share faces, and no way leads from them to the image's border.
 *
 * That is what 18-connected components leave between them. Cavities are numbered from 0 in the order of their first
 * voxels.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementVoxelCavities
{
public:
  using IndexType = DelaunayRefinementVoxelComponents::IndexType;

  struct CavityType
  {
    std::size_t numberOfVoxels;
    IndexType   firstVoxel;
    IndexType   least; // indexes of its voxels, and the greatest ones
    IndexType   greatest;
  };

  static constexpr std::uint32_t None = 0xFFFFFFFFu;

  /** Of a mask of some size with these components. */
  DelaunayRefinementVoxelCavities(const DelaunayRefinementVoxelComponents &     components,
                                  const DelaunayRefinementVoxelMask::SizeType & size);

  const std::vector<CavityType> &
  Get() const
  {
    return m_Cavities;
  }

  /** The cavity of a voxel, which may lie beyond the image; None if it is in none. */
  std::uint32_t
  Find(const IndexType & voxel) const;

private:
  /** Voxels first to last (included) of one row between two runs of the mask. */
  struct GapType
  {
    std::int32_t  first;
    std::int32_t  last;
    std::uint32_t root; // one before it that it is joined to, or its own number; in the end its cavity
  };

  void
  FindGaps(const DelaunayRefinementVoxelComponents & components);

  /** Whether a row is at the image's border, so that nothing surrounds its gaps. */
  bool
  IsAtBorder(std::int32_t y, std::int32_t z) const;

  /** Joins the gaps of two rows that share faces. */
  void
  JoinRows(std::size_t row, std::size_t other);

  /** Joins gaps of a row to the outside that share faces with what is beyond the runs of another one. */
  void
  JoinToOutside(const DelaunayRefinementVoxelComponents & components, std::size_t row, std::size_t other);

  /** Cavities are what is left of the gaps, without those of the outside. */
  void
  NumberCavities();

  std::uint32_t
  FindRoot(std::uint32_t gap);

  void
  Join(std::uint32_t a, std::uint32_t b);

  DelaunayRefinementVoxelMask::SizeType m_Size;
  std::vector<GapType>                  m_Gaps{};      // the first one stands for all that no run surrounds
  std::vector<std::uint32_t>            m_FirstGaps{}; // of each row, and the end
  std::vector<CavityType>               m_Cavities{};
};
} // end namespace itk

#endif
