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

namespace itk
{
DelaunayRefinementBricks::DelaunayRefinementBricks(const DelaunayRefinementVoxelMask & mask)
{
  const auto & voxels = mask.GetSize();
  IndexType    size;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = (voxels[i] + 1 + BrickSize - 1) / BrickSize;
  }
  m_Levels.push_back({ size, {} });
  m_Numbers.assign(static_cast<std::size_t>(size[0]) * size[1] * size[2], -1);
  m_FirstCell = voxels;

  std::vector<std::uint64_t> words;
  for (std::int32_t z = 0; z <= voxels[2]; ++z)
  {
    for (std::int32_t y = 0; y <= voxels[1]; ++y)
    {
      mask.FindMixedCells(y, z, words);
      for (std::size_t i = 0; i < words.size(); ++i)
      {
        // Bricks are nibbles of the words.
        for (std::int32_t nibble = 0; nibble < 16 && words[i] >> (4 * nibble) != 0; ++nibble)
        {
          const std::uint64_t bits = words[i] >> (4 * nibble) & 15u;
          if (bits != 0)
          {
            const std::int32_t brickX = static_cast<std::int32_t>(16 * i) + nibble;
            const IndexType    brick{ brickX, y >> 2, z >> 2 };
            std::int32_t &     number = m_Numbers[this->ToOffset(0, brick)];
            if (number < 0)
            {
              number = static_cast<std::int32_t>(m_Cells.size());
              m_Cells.push_back(0);
              m_ActiveBricks.push_back(brick);
            }
            m_Cells[number] |= bits << ((y & 3) << 2 | (z & 3) << 4);
            const std::int32_t x = 4 * brickX;
            const std::int32_t low = bits & 1u ? 0 : bits & 2u ? 1 : bits & 4u ? 2 : 3;
            const std::int32_t high = bits & 8u ? 3 : bits & 4u ? 2 : bits & 2u ? 1 : 0;
            m_FirstCell = { std::min(m_FirstCell[0], x + low),
                            std::min(m_FirstCell[1], y),
                            std::min(m_FirstCell[2], z) };
            m_LastCell = { std::max(m_LastCell[0], x + high), std::max(m_LastCell[1], y), std::max(m_LastCell[2], z) };
          }
        }
      }
    }
  }

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
