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
#ifndef itkDelaunayRefinementBricks_h
#define itkDelaunayRefinementBricks_h

#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementRegionChanges.h"
#include "itkDelaunayRefinementThreads.h"
#include "itkDelaunayRefinementVoxelMask.h"

#include <algorithm>

namespace itk
{
/** \class DelaunayRefinementBricks
 * \brief Which cells of a mask hold surface: bits of bricks of 4 x 4 x 4 cells, below a pyramid of coarser levels.
 *
 * A node of level 0 is a brick; a node of level n joins 2 x 2 x 2 nodes of level n - 1.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementBricks
{
public:
  using IndexType = std::array<std::int32_t, 3>;

  static constexpr std::int32_t BrickSize = 4;

  /** The voxels \c first to \c last (included) along each axis. */
  struct BoxType
  {
    IndexType first;
    IndexType last;
  };

  /** Cells with a change between regions hold surface, too, if \c changes is not null. On several threads if there are
   * any. */
  DelaunayRefinementBricks(const DelaunayRefinementVoxelMask &     mask,
                           const DelaunayRefinementRegionChanges * changes,
                           DelaunayRefinementThreads *             threads);

  /** After whole components within some boxes were made outside: bricks without surface are outside then. Nodes above
   * level 0 may stay active without need. */
  void
  Update(const DelaunayRefinementVoxelMask &     mask,
         const DelaunayRefinementRegionChanges * changes,
         const std::vector<BoxType> &            boxes);

  /** Bricks with surface, in the order of their first cells. */
  const std::vector<IndexType> &
  GetActiveBricks() const
  {
    return m_ActiveBricks;
  }

  // Whether a brick holds surface, or which side of it it is on.
  enum class BrickEnum : uint8_t
  {
    OUTSIDE = 0,
    INSIDE = 1,
    MIXED = 2
  };

  BrickEnum
  GetKind(const IndexType & brick) const
  {
    const std::uint32_t kind = m_Kinds[this->ToWord(brick)] >> GetShift(brick) & 3u;
    return kind == Emptied ? BrickEnum::OUTSIDE : static_cast<BrickEnum>(kind);
  }

  /** Of all bricks. */
  std::size_t
  CountActiveCells() const;

  /** Bit x + 4 y + 16 z for each cell of a brick; 0 for bricks without surface. */
  std::uint64_t
  GetCells(const IndexType & brick) const
  {
    return this->GetKind(brick) == BrickEnum::MIXED ? m_Cells[this->GetNumber(brick)] : 0;
  }

  bool
  IsActiveCell(const IndexType & cell) const
  {
    return this->GetCells({ cell[0] >> 2, cell[1] >> 2, cell[2] >> 2 }) >> GetBit(cell) & 1u;
  }

  static unsigned int
  GetBit(const IndexType & cell)
  {
    return static_cast<unsigned int>((cell[0] & 3) | (cell[1] & 3) << 2 | (cell[2] & 3) << 4);
  }

  /** The cell of a brick that has a bit. */
  static IndexType
  GetCell(const IndexType & brick, unsigned int bit)
  {
    const auto place = static_cast<std::int32_t>(bit);
    return { BrickSize * brick[0] + (place & 3),
             BrickSize * brick[1] + (place >> 2 & 3),
             BrickSize * brick[2] + (place >> 4) };
  }

  /** The bits of cells first to last (included) of a brick, by their indexes within it. */
  static std::uint64_t
  GetBits(const IndexType & first, const IndexType & last);

  /** Whether a cell between \c first and \c last (included; clamped to what there is) holds surface. */
  bool
  IsAnyActive(IndexType first, IndexType last) const;

  unsigned int
  GetNumberOfLevels() const
  {
    return static_cast<unsigned int>(m_Levels.size());
  }

  const IndexType &
  GetLevelSize(unsigned int level) const
  {
    return m_Levels[level].size;
  }

  bool
  IsActiveNode(unsigned int level, const IndexType & node) const
  {
    return level == 0 ? this->GetKind(node) == BrickEnum::MIXED : m_Levels[level].isActive[this->ToOffset(level, node)];
  }

  /** The least and the greatest index of cells with surface. */
  const IndexType &
  GetFirstCell() const
  {
    return m_FirstCell;
  }
  const IndexType &
  GetLastCell() const
  {
    return m_LastCell;
  }

private:
  /** What a part of the bricks has with surface, numbered from 0. */
  struct PartType
  {
    std::size_t                firstWord{ 0 };
    std::size_t                endOfWords{ 0 };
    std::vector<std::uint64_t> cells{};
    std::vector<IndexType>     active{};
  };

  /** Fills in a row of bricks. */
  void
  FindBricks(const DelaunayRefinementVoxelMask &     mask,
             const DelaunayRefinementRegionChanges * changes,
             std::int32_t                            brickY,
             std::int32_t                            brickZ,
             PartType &                              part);

  /** Puts parts together, one after another. */
  void
  JoinParts(std::vector<PartType> & parts, DelaunayRefinementThreads * threads);

  void
  MakeLevels();

  void
  UpdateBounds();

  // Kinds are pairs of bits, sixteen in a word: what is asked most often fits a small cache.

  /** In place of the kind of a brick that held surface once, and whose voxels are all outside now. */
  static constexpr std::uint32_t Emptied = 3;

  /** The higher bit of each pair: set for bricks that hold surface, or did. */
  static constexpr std::uint32_t HigherOfPairs = 0xAAAAAAAAu;

  std::size_t
  ToWord(const IndexType & brick) const
  {
    const IndexType & size = m_Levels[0].size;
    return (static_cast<std::size_t>(brick[2]) * size[1] + brick[1]) * m_WordsPerRow +
           static_cast<std::size_t>(brick[0] >> 4);
  }

  static unsigned int
  GetShift(const IndexType & brick)
  {
    return 2 * (static_cast<unsigned int>(brick[0]) & 15u);
  }

  /** Of a brick that holds surface, or did, among m_Cells. */
  std::size_t
  GetNumber(const IndexType & brick) const
  {
    const std::size_t   word = this->ToWord(brick);
    const std::uint32_t before = (1u << GetShift(brick)) - 1;
    return m_FirstNumbers[word] + CountDelaunayRefinementBits(m_Kinds[word] & before & HigherOfPairs);
  }

  struct LevelType
  {
    IndexType         size;
    std::vector<bool> isActive;
  };

  std::size_t
  ToOffset(unsigned int level, const IndexType & node) const
  {
    const IndexType & size = m_Levels[level].size;
    return (static_cast<std::size_t>(node[2]) * size[1] + node[1]) * size[0] + node[0];
  }

  bool
  IsAnyActiveBelow(unsigned int level, const IndexType & node, const IndexType & first, const IndexType & last) const;

  std::vector<LevelType>                 m_Levels{};
  std::size_t                            m_WordsPerRow{ 0 };
  DelaunayRefinementArray<std::uint32_t> m_Kinds{};
  DelaunayRefinementArray<std::uint32_t> m_FirstNumbers{}; // of the bricks of each word
  std::vector<std::uint64_t>             m_Cells{};
  std::vector<IndexType>                 m_ActiveBricks{};
  IndexType                              m_FirstCell{};
  IndexType                              m_LastCell{ -1, -1, -1 };
};
} // end namespace itk

#endif
