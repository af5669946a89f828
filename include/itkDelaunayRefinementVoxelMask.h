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
#ifndef itkDelaunayRefinementVoxelMask_h
#define itkDelaunayRefinementVoxelMask_h

#include "itkDelaunayRefinementMemory.h"

#include <algorithm>
#include <array>
#include <cstdint>
#ifdef __SSE2__
#  include <emmintrin.h>
#endif

namespace itk
{
/** \class DelaunayRefinementVoxelMask
 * \brief The object's voxels, a bit each, with one layer of outside all around.
 *
 * A cell is the cube between the centers of eight voxels. Cells are numbered from 0: cell 0 lies between the outer
 * layer and voxel 0, cell n between voxel n - 1 and the outer layer.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementVoxelMask
{
public:
  /** Number of voxels along x, y, z. */
  using SizeType = std::array<std::int32_t, 3>;

  /** All voxels are outside. */
  explicit DelaunayRefinementVoxelMask(const SizeType & size);

  /** Number of voxels along each axis. */
  const SizeType &
  GetSize() const
  {
    return m_Size;
  }

  /** Calls action(row, y, z) for some rows of voxels, numbered along y first, \c end not included. */
  template <typename TAction>
  static void
  VisitRows(const SizeType & size, std::size_t begin, std::size_t end, const TAction & action)
  {
    auto y = static_cast<std::int32_t>(begin % size[1]);
    auto z = static_cast<std::int32_t>(begin / size[1]);
    for (std::size_t row = begin; row < end; ++row)
    {
      action(row, y, z);
      if (++y == size[1])
      {
        y = 0;
        ++z;
      }
    }
  }

  /** Sets the row of voxels (y, z) to isInside(0), isInside(1), ... which is asked twice for some, and should be cheap.
   * Rows may be set in parallel. */
  template <typename TPredicate>
  void
  SetRow(std::int32_t y, std::int32_t z, const TPredicate & isInside)
  {
    // By bytes first, which compilers make fast.
    std::uint64_t *              row = this->GetRow(y + 1, z + 1);
    std::array<std::uint8_t, 64> bytes{};
    const std::int32_t           length = std::min(64, m_Size[0]);
    std::uint64_t                carry = 0;
    std::uint64_t                any = 0;
    for (std::int32_t first = 0; first < m_Size[0]; first += 64)
    {
      // The last 64 of a row overlap those before them, so that all loops have one length.
      const std::int32_t start = std::max(0, std::min(first, m_Size[0] - 64));
      for (std::int32_t i = 0; i < length; ++i)
      {
        bytes[i] = isInside(start + i) ? 1 : 0;
      }
      const std::uint64_t bits = PackBytes(bytes) >> (first - start);
      *row++ = bits << 1 | carry;
      carry = bits >> 63;
      any |= bits;
    }
    if (m_Size[0] % 64 == 0)
    {
      *row = carry;
    }
    m_MayHaveVoxels[this->ToRow(y + 1, z + 1)] = any != 0 ? 1 : 0;
  }

  /** Whether voxel (x, y, z) belongs to the object; any index from -1 to the size. */
  bool
  Get(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    const std::uint32_t bit = static_cast<std::uint32_t>(x + 1);
    return this->GetRow(y + 1, z + 1)[bit >> 6] >> (bit & 63u) & 1u;
  }

  /** Makes voxel (x, y, z) a part of the object, or not. */
  void
  Set(std::int32_t x, std::int32_t y, std::int32_t z, bool isInside)
  {
    const std::uint32_t bit = static_cast<std::uint32_t>(x + 1);
    const std::uint64_t flag = std::uint64_t{ 1 } << (bit & 63u);
    std::uint64_t &     word = this->GetRow(y + 1, z + 1)[bit >> 6];
    word = isInside ? word | flag : word & ~flag;
    m_MayHaveVoxels[this->ToRow(y + 1, z + 1)] |= isInside ? 1 : 0;
  }

  /** Makes voxels first to last (included) of a row outside. */
  void
  ClearRun(std::int32_t first, std::int32_t last, std::int32_t y, std::int32_t z);

  /** The eight voxels of a cell: bit dx + 2 dy + 4 dz for voxel (x - 1 + dx, y - 1 + dy, z - 1 + dz). */
  unsigned int
  GetConfiguration(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    const unsigned int low = this->GetPair(x, y, z) | this->GetPair(x, y + 1, z) << 2;
    const unsigned int high = this->GetPair(x, y, z + 1) | this->GetPair(x, y + 1, z + 1) << 2;
    return low | high << 4;
  }

  /** The words of a row, outer layer included: bit x + 1 is voxel x. Rows are numbered from the outer layer. */
  const std::uint64_t *
  GetRow(std::int32_t paddedY, std::int32_t paddedZ) const
  {
    return m_Words.data() + m_WordsPerRow * this->ToRow(paddedY, paddedZ);
  }

  /** Cheap: true only if no voxel of a row belongs to the object. Rows are numbered from the outer layer. */
  bool
  IsRowEmpty(std::int32_t paddedY, std::int32_t paddedZ) const
  {
    return m_MayHaveVoxels[this->ToRow(paddedY, paddedZ)] == 0;
  }

  /** Number of words of each row. */
  std::size_t
  GetWordsPerRow() const
  {
    return m_WordsPerRow;
  }

private:
  std::size_t
  ToRow(std::int32_t paddedY, std::int32_t paddedZ) const
  {
    return static_cast<std::size_t>(paddedZ) * (m_Size[1] + 2) + paddedY;
  }

  /** Bit i is byte i, which is 0 or 1. */
  static std::uint64_t
  PackBytes(const std::array<std::uint8_t, 64> & bytes)
  {
    std::uint64_t bits = 0;
#ifdef __SSE2__
    for (unsigned int part = 0; part < 4; ++part)
    {
      // The last bit of each byte becomes its first.
      const __m128i sixteen = _mm_loadu_si128(reinterpret_cast<const __m128i *>(bytes.data() + 16 * part));
      const int     some = _mm_movemask_epi8(_mm_slli_epi16(sixteen, 7));
      bits |= static_cast<std::uint64_t>(static_cast<unsigned int>(some)) << (16 * part);
    }
#else
    for (unsigned int part = 0; part < 8; ++part)
    {
      // Compilers make one load of it. The product moves the last bit of byte k to bit 56 + k; nothing else gets there.
      const std::uint8_t * const b = bytes.data() + 8 * part;
      const auto                 at = [b](unsigned int i) { return static_cast<std::uint64_t>(b[i]) << (8 * i); };
      const std::uint64_t        eight = at(0) | at(1) | at(2) | at(3) | at(4) | at(5) | at(6) | at(7);
      bits |= (eight * 0x0102040810204080u >> 56) << (8 * part);
    }
#endif
    return bits;
  }

  std::uint64_t *
  GetRow(std::int32_t paddedY, std::int32_t paddedZ)
  {
    return m_Words.data() + m_WordsPerRow * this->ToRow(paddedY, paddedZ);
  }

  /** Two neighboring bits of a row. */
  unsigned int
  GetPair(std::int32_t x, std::int32_t paddedY, std::int32_t paddedZ) const
  {
    const std::uint64_t * row = this->GetRow(paddedY, paddedZ) + (x >> 6);
    const unsigned int    shift = static_cast<unsigned int>(x) & 63u;
    const std::uint64_t   low = row[0] >> shift;
    return static_cast<unsigned int>((shift == 63u ? low | row[1] << 1 : low) & 3u);
  }

  SizeType                               m_Size;
  std::size_t                            m_WordsPerRow;
  DelaunayRefinementArray<std::uint64_t> m_Words;
  DelaunayRefinementArray<std::uint8_t>  m_MayHaveVoxels; // of each row; bytes, as rows may be set in parallel
};
} // end namespace itk

#endif
