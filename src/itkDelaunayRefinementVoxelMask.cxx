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
#include "itkDelaunayRefinementVoxelMask.h"

#include "itkDelaunayRefinementBits.h"

namespace itk
{
DelaunayRefinementVoxelMask::DelaunayRefinementVoxelMask(const SizeType & size)
  : m_Size(size)
  , m_WordsPerRow((static_cast<std::size_t>(size[0]) + 2) / 64 + 1)
  // One word more, as pairs may reach past the end of the last row.
  , m_Words(m_WordsPerRow * (size[1] + 2) * (size[2] + 2) + 1, 0)
{}

void
DelaunayRefinementVoxelMask::ClearRun(std::int32_t first, std::int32_t last, std::int32_t y, std::int32_t z)
{
  std::uint64_t * row = this->GetRow(y + 1, z + 1);
  for (std::int32_t bit = first + 1; bit <= last + 1; ++bit)
  {
    row[bit >> 6] &= ~(std::uint64_t{ 1 } << (bit & 63));
  }
}

void
DelaunayRefinementVoxelMask::FindMixedCells(std::int32_t y, std::int32_t z, std::vector<std::uint64_t> & words) const
{
  const std::uint64_t * rows[4] = {
    this->GetRow(y, z), this->GetRow(y + 1, z), this->GetRow(y, z + 1), this->GetRow(y + 1, z + 1)
  };
  words.resize(m_WordsPerRow);
  std::uint64_t nextAny = rows[0][0] | rows[1][0] | rows[2][0] | rows[3][0];
  std::uint64_t nextAll = rows[0][0] & rows[1][0] & rows[2][0] & rows[3][0];
  for (std::size_t i = 0; i < m_WordsPerRow; ++i)
  {
    const std::uint64_t any = nextAny;
    const std::uint64_t all = nextAll;
    const bool          hasNext = i + 1 < m_WordsPerRow;
    nextAny = hasNext ? rows[0][i + 1] | rows[1][i + 1] | rows[2][i + 1] | rows[3][i + 1] : 0;
    nextAll = hasNext ? rows[0][i + 1] & rows[1][i + 1] & rows[2][i + 1] & rows[3][i + 1] : 0;
    words[i] = (any | any >> 1 | nextAny << 63) & ~(all & (all >> 1 | nextAll << 63));
  }
}

std::size_t
DelaunayRefinementVoxelMask::Count() const
{
  std::size_t count = 0;
  for (const std::uint64_t word : m_Words)
  {
    count += CountDelaunayRefinementBits(word);
  }
  return count;
}
} // end namespace itk
