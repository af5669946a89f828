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
#include "itkDelaunayRefinementBricks.h"

#include <algorithm>
#include <limits>

namespace itk
{
namespace
{
/** The cells of a brick that have a number along an axis. */
constexpr std::uint64_t Layers[3][4] = {
  { 0x1111111111111111u, 0x2222222222222222u, 0x4444444444444444u, 0x8888888888888888u },
  { 0x000F000F000F000Fu, 0x00F000F000F000F0u, 0x0F000F000F000F00u, 0xF000F000F000F000u },
  { 0x000000000000FFFFu, 0x00000000FFFF0000u, 0x0000FFFF00000000u, 0xFFFF000000000000u }
};

/** \class MixedRows
 * \brief The cells with voxels of different kinds in 4 x 4 rows of cells, y fastest, 64 cells along x at a time. */
class MixedRows
{
public:
  MixedRows(const DelaunayRefinementVoxelMask &     mask,
            const DelaunayRefinementRegionChanges * changes,
            std::int32_t                            brickY,
            std::int32_t                            brickZ)
    : m_NumberOfWords(mask.GetWordsPerRow())
    , m_HasRegions(changes != nullptr)
  {
    // Beyond the outer layer is more of the same.
    for (std::int32_t z = 0; z < Side; ++z)
    {
      for (std::int32_t y = 0; y < Side; ++y)
      {
        const std::int32_t rowY = std::min(4 * brickY + y, mask.GetSize()[1] + 1);
        const std::int32_t rowZ = std::min(4 * brickZ + z, mask.GetSize()[2] + 1);
        m_Words[z][y] = mask.GetRow(rowY, rowZ);
        for (unsigned int axis = 0; axis < 3 && m_HasRegions; ++axis)
        {
          m_Changes[axis][z][y] = changes->GetRow(axis, rowY, rowZ);
        }
      }
    }
    this->GoTo(0);
  }

  /** Sets where it is, in words. */
  void
  GoTo(std::size_t word)
  {
    m_Next = this->Summarize(word);
    this->LookAt(word);
  }

  /** One word on. */
  void
  Advance()
  {
    this->LookAt(m_Word + 1);
  }

  /** The cells of all rows put together. */
  std::uint64_t
  GetAny() const
  {
    return m_Any;
  }

  /** The cells of one brick, a nibble of the words. */
  std::uint64_t
  Gather(std::int32_t nibble) const
  {
    std::uint64_t cells = 0;
    for (unsigned int i = 0; i < 16; ++i)
    {
      cells |= (m_Mixed[i] >> (4 * nibble) & 15u) << (4 * i);
    }
    return cells;
  }

private:
  static constexpr std::int32_t Side = 5;

  /** Of some voxels at one x: whether any is inside, whether all are, and whether regions change from those at the x
   * before and between them. */
  struct PairType
  {
    std::uint64_t any;
    std::uint64_t all;
    std::uint64_t changesFromLast;
    std::uint64_t changesBetween;
  };

  /** Each with the one after it; those of the last come from the next word. */
  static std::uint64_t
  AtNext(std::uint64_t here, std::uint64_t next)
  {
    return here >> 1 | next << 63;
  }

  /** The cells between a row of voxels and the next. */
  static std::uint64_t
  FindMixed(const PairType & here, const PairType & next)
  {
    const std::uint64_t all = here.all & AtNext(here.all, next.all);
    const std::uint64_t changes = here.changesBetween | AtNext(here.changesFromLast, next.changesFromLast);
    return ((here.any | AtNext(here.any, next.any)) & ~all) | (all & changes);
  }

  /** The same of more than one cell's voxels at each x: none is left out. */
  static std::uint64_t
  MayBeMixed(const PairType & here, const PairType & next)
  {
    const std::uint64_t all = here.all & AtNext(here.all, next.all);
    const std::uint64_t any = here.any | AtNext(here.any, next.any);
    return any & (~all | here.changesBetween | AtNext(here.changesFromLast, next.changesFromLast));
  }

  /** Of all rows. */
  PairType
  Summarize(std::size_t word) const
  {
    PairType pair{ 0, 0, 0, 0 };
    if (word < m_NumberOfWords && m_HasRegions)
    {
      for (std::int32_t z = 0; z < Side; ++z)
      {
        for (std::int32_t y = 0; y < Side; ++y)
        {
          pair.changesFromLast |= m_Changes[0][z][y][word];
          pair.changesBetween |= m_Changes[1][z][y][word] | m_Changes[2][z][y][word];
        }
      }
    }
    if (word < m_NumberOfWords)
    {
      pair.all = ~pair.all;
      for (const auto & layer : m_Words)
      {
        for (const std::uint64_t * words : layer)
        {
          pair.any |= words[word];
          pair.all &= words[word];
        }
      }
    }
    return pair;
  }

  /** Of the four voxels of each row of cells. */
  using CombinedType = std::array<PairType, 16>;

  CombinedType
  Combine(std::size_t word) const
  {
    CombinedType combined{};
    if (word < m_NumberOfWords)
    {
      for (unsigned int i = 0; i < 16; ++i)
      {
        const std::uint64_t voxels[4] = { m_Words[i / 4][i % 4][word],
                                          m_Words[i / 4][i % 4 + 1][word],
                                          m_Words[i / 4 + 1][i % 4][word],
                                          m_Words[i / 4 + 1][i % 4 + 1][word] };
        combined[i] = {
          voxels[0] | voxels[1] | voxels[2] | voxels[3], voxels[0] & voxels[1] & voxels[2] & voxels[3], 0, 0
        };
        if (m_HasRegions)
        {
          // If all four are alike along each of these edges, they are alike.
          const auto at = [this, word, i](unsigned int axis, unsigned int dy, unsigned int dz) {
            return m_Changes[axis][i / 4 + dz][i % 4 + dy][word];
          };
          combined[i].changesFromLast = at(0, 0, 0) | at(0, 1, 0) | at(0, 0, 1) | at(0, 1, 1);
          combined[i].changesBetween = at(1, 1, 0) | at(1, 1, 1) | at(2, 0, 1);
        }
      }
    }
    return combined;
  }

  void
  LookAt(std::size_t word)
  {
    const PairType here = m_Next;
    m_Word = word;
    m_Next = this->Summarize(word + 1);
    m_Any = 0;
    if (MayBeMixed(here, m_Next) == 0)
    {
      // As most are.
      m_Mixed = {};
      return;
    }
    const CombinedType rows = this->Combine(word);
    const CombinedType nextRows = this->Combine(word + 1);
    for (unsigned int i = 0; i < 16; ++i)
    {
      m_Mixed[i] = FindMixed(rows[i], nextRows[i]);
      m_Any |= m_Mixed[i];
    }
  }

  std::size_t                   m_NumberOfWords;
  bool                          m_HasRegions;
  const std::uint64_t *         m_Words[Side][Side];
  const std::uint64_t *         m_Changes[3][Side][Side];
  std::size_t                   m_Word{ 0 };
  PairType                      m_Next{};
  std::array<std::uint64_t, 16> m_Mixed{};
  std::uint64_t                 m_Any{ 0 };
};

/** Puts the lower two bits of each nibble next to each other. */
std::uint32_t
GatherPairs(std::uint64_t nibbles)
{
  nibbles &= 0x3333333333333333u;
  nibbles = (nibbles | nibbles >> 2) & 0x0F0F0F0F0F0F0F0Fu;
  nibbles = (nibbles | nibbles >> 4) & 0x00FF00FF00FF00FFu;
  nibbles = (nibbles | nibbles >> 8) & 0x0000FFFF0000FFFFu;
  return static_cast<std::uint32_t>(nibbles | nibbles >> 16);
}

/** Whether no voxel of a row of bricks belongs to the object. */
bool
AreRowsEmpty(const DelaunayRefinementVoxelMask & mask, std::int32_t brickY, std::int32_t brickZ)
{
  constexpr std::int32_t size = DelaunayRefinementBricks::BrickSize;
  for (std::int32_t z = size * brickZ; z <= std::min(size * brickZ + size, mask.GetSize()[2] + 1); ++z)
  {
    for (std::int32_t y = size * brickY; y <= std::min(size * brickY + size, mask.GetSize()[1] + 1); ++y)
    {
      if (!mask.IsRowEmpty(y, z))
      {
        return false;
      }
    }
  }
  return true;
}
} // namespace

void
DelaunayRefinementBricks::UpdateBounds()
{
  constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();
  m_FirstCell = m_ActiveBricks.empty() ? IndexType{} : IndexType{ largest, largest, largest };
  m_LastCell = { -1, -1, -1 };
  for (const IndexType & brick : m_ActiveBricks)
  {
    const std::uint64_t cells = this->GetCells(brick);
    for (unsigned int i = 0; i < 3; ++i)
    {
      const std::int32_t first = BrickSize * brick[i];
      if (first < m_FirstCell[i] || first + BrickSize - 1 > m_LastCell[i])
      {
        for (std::int32_t j = 0; j < BrickSize; ++j)
        {
          if (cells & Layers[i][j])
          {
            m_FirstCell[i] = std::min(m_FirstCell[i], first + j);
            m_LastCell[i] = std::max(m_LastCell[i], first + j);
          }
        }
      }
    }
  }
}

std::size_t
DelaunayRefinementBricks::CountActiveCells() const
{
  std::size_t number = 0;
  for (const std::uint64_t cells : m_Cells)
  {
    number += CountDelaunayRefinementBits(cells);
  }
  return number;
}

void
DelaunayRefinementBricks::Update(const DelaunayRefinementVoxelMask &     mask,
                                 const DelaunayRefinementRegionChanges * changes,
                                 const std::vector<BoxType> &            boxes)
{
  for (const BoxType & box : boxes)
  {
    // Cell n is before voxel n, cell n + 1 after it.
    for (std::int32_t z = box.first[2] >> 2; z <= (box.last[2] + 1) >> 2; ++z)
    {
      for (std::int32_t y = box.first[1] >> 2; y <= (box.last[1] + 1) >> 2; ++y)
      {
        MixedRows rows(mask, changes, y, z);
        for (std::int32_t x = box.first[0] >> 2; x <= (box.last[0] + 1) >> 2; ++x)
        {
          if (x % 16 == 0 || x == box.first[0] >> 2)
          {
            rows.GoTo(static_cast<std::size_t>(x) / 16);
          }
          if (this->GetKind({ x, y, z }) == BrickEnum::MIXED)
          {
            m_Cells[this->GetNumber({ x, y, z })] = rows.Gather(x % 16);
          }
          else if (this->GetKind({ x, y, z }) == BrickEnum::INSIDE && mask.GetConfiguration(4 * x, 4 * y, 4 * z) == 0)
          {
            m_Kinds[this->ToWord({ x, y, z })] &= ~(3u << GetShift({ x, y, z }));
          }
        }
      }
    }
  }
  const auto isEmpty = [this](const IndexType & brick) {
    const bool hasNone = this->GetCells(brick) == 0;
    if (hasNone)
    {
      m_Kinds[this->ToWord(brick)] |= Emptied << GetShift(brick);
    }
    return hasNone;
  };
  m_ActiveBricks.erase(std::remove_if(m_ActiveBricks.begin(), m_ActiveBricks.end(), isEmpty), m_ActiveBricks.end());
  this->UpdateBounds();
}

DelaunayRefinementBricks::DelaunayRefinementBricks(const DelaunayRefinementVoxelMask &     mask,
                                                   const DelaunayRefinementRegionChanges * changes,
                                                   DelaunayRefinementThreads *             threads)
{
  const auto & voxels = mask.GetSize();
  IndexType    size;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = (voxels[i] + 1 + BrickSize - 1) / BrickSize;
  }
  m_Levels.push_back({ size, {} });
  m_WordsPerRow = (static_cast<std::size_t>(size[0]) + 15) / 16;
  m_Kinds.resize(m_WordsPerRow * size[1] * size[2]);
  m_FirstNumbers.resize(m_Kinds.size());

  using Threads = DelaunayRefinementThreads;
  constexpr std::size_t leastLength = 64;
  const std::size_t     rows = static_cast<std::size_t>(size[1]) * size[2];
  const std::size_t     length = Threads::ChoosePieceLength(threads, rows, leastLength);
  std::vector<PartType> parts(Threads::CountPieces(rows, length));
  Threads::RunPieces(threads, rows, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    parts[piece].firstWord = begin * m_WordsPerRow;
    parts[piece].endOfWords = end * m_WordsPerRow;
    DelaunayRefinementVoxelMask::VisitRows(size, begin, end, [&](std::size_t, std::int32_t y, std::int32_t z) {
      this->FindBricks(mask, changes, y, z, parts[piece]);
    });
  });
  this->JoinParts(parts, threads);
  this->UpdateBounds();
  this->MakeLevels();
}

void
DelaunayRefinementBricks::FindBricks(const DelaunayRefinementVoxelMask &     mask,
                                     const DelaunayRefinementRegionChanges * changes,
                                     std::int32_t                            brickY,
                                     std::int32_t                            brickZ,
                                     PartType &                              part)
{
  const std::int32_t numberOfBricks = m_Levels[0].size[0];
  const std::size_t  firstWord = this->ToWord({ 0, brickY, brickZ });
  if (AreRowsEmpty(mask, brickY, brickZ))
  {
    std::fill_n(m_Kinds.data() + firstWord, m_WordsPerRow, 0u);
    std::fill_n(m_FirstNumbers.data() + firstWord, m_WordsPerRow, 0u);
    return;
  }
  MixedRows rows(mask, changes, brickY, brickZ);
  for (std::int32_t first = 0; first < numberOfBricks; first += 16, rows.Advance())
  {
    // Bricks are nibbles of the words.
    constexpr std::uint64_t lowest = 0x1111111111111111u;
    const std::uint64_t     any = rows.GetAny();
    const std::uint64_t     inside = mask.GetRow(BrickSize * brickY, BrickSize * brickZ)[first / 16];
    const std::uint64_t     mixed = (any | any >> 1 | any >> 2 | any >> 3) & lowest;
    const std::size_t       word = firstWord + static_cast<std::size_t>(first) / 16;
    m_FirstNumbers[word] = static_cast<std::uint32_t>(part.cells.size());
    m_Kinds[word] = GatherPairs((inside & lowest & ~mixed) | mixed << 1);
    for (std::uint64_t left = mixed; left != 0; left &= left - 1)
    {
      const auto nibble = static_cast<std::int32_t>(FindDelaunayRefinementBit(left)) / 4;
      part.cells.push_back(rows.Gather(nibble));
      part.active.push_back({ first + nibble, brickY, brickZ });
    }
  }
}

void
DelaunayRefinementBricks::JoinParts(std::vector<PartType> & parts, DelaunayRefinementThreads * threads)
{
  if (parts.size() == 1)
  {
    m_Cells = std::move(parts[0].cells);
    m_ActiveBricks = std::move(parts[0].active);
    return;
  }
  std::vector<std::size_t> firsts(parts.size() + 1, 0);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    firsts[i + 1] = firsts[i] + parts[i].cells.size();
  }
  m_Cells.resize(firsts.back());
  m_ActiveBricks.resize(firsts.back());
  DelaunayRefinementThreads::RunPieces(threads, parts.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
    const auto first = static_cast<std::ptrdiff_t>(firsts[i]);
    std::copy(parts[i].cells.begin(), parts[i].cells.end(), m_Cells.begin() + first);
    std::copy(parts[i].active.begin(), parts[i].active.end(), m_ActiveBricks.begin() + first);
    for (std::size_t word = parts[i].firstWord; word < parts[i].endOfWords; ++word)
    {
      m_FirstNumbers[word] += static_cast<std::uint32_t>(first);
    }
  });
}

void
DelaunayRefinementBricks::MakeLevels()
{
  IndexType size = m_Levels[0].size;
  while (std::max({ size[0], size[1], size[2] }) > 1)
  {
    const unsigned int below = static_cast<unsigned int>(m_Levels.size()) - 1;
    const IndexType    sizeBelow = size;
    for (int i = 0; i < 3; ++i)
    {
      size[i] = (size[i] + 1) / 2;
    }
    m_Levels.push_back({ size, std::vector<bool>(static_cast<std::size_t>(size[0]) * size[1] * size[2], false) });
    if (below == 0)
    {
      for (const IndexType & brick : m_ActiveBricks)
      {
        m_Levels[1].isActive[this->ToOffset(1, { brick[0] >> 1, brick[1] >> 1, brick[2] >> 1 })] = true;
      }
      continue;
    }
    for (std::int32_t z = 0; z < sizeBelow[2]; ++z)
    {
      for (std::int32_t y = 0; y < sizeBelow[1]; ++y)
      {
        for (std::int32_t x = 0; x < sizeBelow[0]; ++x)
        {
          if (this->IsActiveNode(below, { x, y, z }))
          {
            m_Levels[below + 1].isActive[this->ToOffset(below + 1, { x >> 1, y >> 1, z >> 1 })] = true;
          }
        }
      }
    }
  }
}

std::uint64_t
DelaunayRefinementBricks::GetBits(const IndexType & first, const IndexType & last)
{
  std::uint64_t row = 0;
  for (std::int32_t x = first[0]; x <= last[0]; ++x)
  {
    row |= std::uint64_t{ 1 } << x;
  }
  std::uint64_t bits = 0;
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      bits |= row << (4 * y + 16 * z);
    }
  }
  return bits;
}

bool
DelaunayRefinementBricks::IsAnyActive(IndexType first, IndexType last) const
{
  std::int32_t extent = 0;
  for (int i = 0; i < 3; ++i)
  {
    first[i] = std::max(first[i], m_FirstCell[i]);
    last[i] = std::min(last[i], m_LastCell[i]);
    if (first[i] > last[i])
    {
      return false;
    }
    extent = std::max(extent, (last[i] >> 2) - (first[i] >> 2));
  }
  unsigned int level = 0;
  while ((extent >> level) > 1 && level + 1 < this->GetNumberOfLevels())
  {
    ++level;
  }
  const int shift = 2 + static_cast<int>(level);
  for (std::int32_t z = first[2] >> shift; z <= last[2] >> shift; ++z)
  {
    for (std::int32_t y = first[1] >> shift; y <= last[1] >> shift; ++y)
    {
      for (std::int32_t x = first[0] >> shift; x <= last[0] >> shift; ++x)
      {
        if (this->IsAnyActiveBelow(level, { x, y, z }, first, last))
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool
DelaunayRefinementBricks::IsAnyActiveBelow(unsigned int      level,
                                           const IndexType & node,
                                           const IndexType & first,
                                           const IndexType & last) const
{
  if (!this->IsActiveNode(level, node))
  {
    return false;
  }
  const int shift = 2 + static_cast<int>(level);
  IndexType low;
  IndexType high;
  for (int i = 0; i < 3; ++i)
  {
    low[i] = std::max(first[i], node[i] << shift);
    high[i] = std::min(last[i], ((node[i] + 1) << shift) - 1);
    if (low[i] > high[i])
    {
      return false;
    }
  }
  if (level == 0)
  {
    const IndexType inside{ low[0] & 3, low[1] & 3, low[2] & 3 };
    const IndexType insideLast{ high[0] & 3, high[1] & 3, high[2] & 3 };
    return (this->GetCells(node) & GetBits(inside, insideLast)) != 0;
  }
  const IndexType & size = m_Levels[level - 1].size;
  for (std::int32_t child = 0; child < 8; ++child)
  {
    const IndexType below{ 2 * node[0] + (child & 1), 2 * node[1] + (child >> 1 & 1), 2 * node[2] + (child >> 2) };
    if (below[0] < size[0] && below[1] < size[1] && below[2] < size[2] &&
        this->IsAnyActiveBelow(level - 1, below, first, last))
    {
      return true;
    }
  }
  return false;
}
} // end namespace itk
