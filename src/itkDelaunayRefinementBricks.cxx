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
} // namespace

std::vector<std::uint64_t>
DelaunayRefinementBricks::FindRows(const DelaunayRefinementVoxelMask & mask,
                                   std::int32_t                        brickY,
                                   std::int32_t                        brickZ,
                                   RowsType &                          rows)
{
  std::vector<std::uint64_t> any(mask.GetWordsPerRow(), 0);
  for (std::int32_t i = 0; i < BrickSize * BrickSize; ++i)
  {
    const std::int32_t y = BrickSize * brickY + i % BrickSize;
    const std::int32_t z = BrickSize * brickZ + i / BrickSize;
    if (y > mask.GetSize()[1] || z > mask.GetSize()[2])
    {
      rows[i].assign(any.size(), 0);
      continue;
    }
    mask.FindMixedCells(y, z, rows[i]);
    for (std::size_t word = 0; word < any.size(); ++word)
    {
      any[word] |= rows[i][word];
    }
  }
  return any;
}

std::uint64_t
DelaunayRefinementBricks::GatherCells(const RowsType & rows, std::size_t word, std::int32_t nibble)
{
  std::uint64_t cells = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    cells |= (rows[i][word] >> (4 * nibble) & 15u) << (4 * i);
  }
  return cells;
}

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

void
DelaunayRefinementBricks::Update(const DelaunayRefinementVoxelMask & mask, const std::vector<BoxType> & changes)
{
  RowsType rows;
  for (const BoxType & box : changes)
  {
    // Cell n is before voxel n, cell n + 1 after it.
    for (std::int32_t z = box.first[2] >> 2; z <= (box.last[2] + 1) >> 2; ++z)
    {
      for (std::int32_t y = box.first[1] >> 2; y <= (box.last[1] + 1) >> 2; ++y)
      {
        FindRows(mask, y, z, rows);
        for (std::int32_t x = box.first[0] >> 2; x <= (box.last[0] + 1) >> 2; ++x)
        {
          std::int32_t & number = m_Numbers[this->ToOffset(0, { x, y, z })];
          if (number >= 0)
          {
            m_Cells[number] = GatherCells(rows, static_cast<std::size_t>(x) / 16, x % 16);
          }
          else
          {
            number = GetNumberOfUniform(mask, { x, y, z });
          }
        }
      }
    }
  }
  const auto isEmpty = [this, &mask](const IndexType & brick) {
    std::int32_t & number = m_Numbers[this->ToOffset(0, brick)];
    const bool     hasNone = m_Cells[number] == 0;
    number = hasNone ? GetNumberOfUniform(mask, brick) : number;
    return hasNone;
  };
  m_ActiveBricks.erase(std::remove_if(m_ActiveBricks.begin(), m_ActiveBricks.end(), isEmpty), m_ActiveBricks.end());
  this->UpdateBounds();
}

DelaunayRefinementBricks::DelaunayRefinementBricks(const DelaunayRefinementVoxelMask & mask)
{
  const auto & voxels = mask.GetSize();
  IndexType    size;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = (voxels[i] + 1 + BrickSize - 1) / BrickSize;
  }
  m_Levels.push_back({ size, {} });
  m_Numbers.resize(static_cast<std::size_t>(size[0]) * size[1] * size[2]);

  RowsType rows;
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      const auto any = FindRows(mask, y, z, rows);
      for (std::size_t word = 0; word < any.size(); ++word)
      {
        // Bricks are nibbles of the words.
        const std::int32_t first = static_cast<std::int32_t>(16 * word);
        for (std::int32_t nibble = 0; nibble < 16 && first + nibble < size[0]; ++nibble)
        {
          const IndexType brick{ first + nibble, y, z };
          std::int32_t &  number = m_Numbers[this->ToOffset(0, brick)];
          if (any[word] >> (4 * nibble) & 15u)
          {
            number = static_cast<std::int32_t>(m_Cells.size());
            m_Cells.push_back(GatherCells(rows, word, nibble));
            m_ActiveBricks.push_back(brick);
          }
          else
          {
            number = GetNumberOfUniform(mask, brick);
          }
        }
      }
    }
  }
  this->UpdateBounds();

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
