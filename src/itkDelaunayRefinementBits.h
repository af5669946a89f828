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
#ifndef itkDelaunayRefinementBits_h
#define itkDelaunayRefinementBits_h

#include <cstdint>
#ifdef __SSE2__
#  include <emmintrin.h>
#endif

namespace itk
{
/** Bit i is set if number i is no less than \c least. */
inline std::uint32_t
FindDelaunayRefinementNumbersFrom(float least, const float (&numbers)[16])
{
#ifdef __SSE2__
  const __m128  leasts = _mm_set1_ps(least);
  const auto    compare = [&](int i) { return _mm_castps_si128(_mm_cmple_ps(leasts, _mm_loadu_ps(numbers + i))); };
  const __m128i low = _mm_packs_epi32(compare(0), compare(4));
  const __m128i high = _mm_packs_epi32(compare(8), compare(12));
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
#else
  std::uint32_t bits = 0;
  for (unsigned int i = 0; i < 16; ++i)
  {
    bits |= least <= numbers[i] ? 1u << i : 0;
  }
  return bits;
#endif
}

/** The number of ones. */
inline unsigned int
CountDelaunayRefinementBits(std::uint64_t word)
{
  word -= word >> 1 & 0x5555555555555555u;
  word = (word & 0x3333333333333333u) + (word >> 2 & 0x3333333333333333u);
  word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
  return static_cast<unsigned int>(word * 0x0101010101010101u >> 56);
}

/** The place of the lowest one of a word that is not 0. */
inline unsigned int
FindDelaunayRefinementBit(std::uint64_t word)
{
#ifdef __GNUC__
  return static_cast<unsigned int>(__builtin_ctzll(word));
#else
  return CountDelaunayRefinementBits((word & (~word + 1)) - 1);
#endif
}

/** Of bits \c first to \c last (included) of a row of words, those in one of these: a word that holds some of them. */
inline std::uint64_t
GetDelaunayRefinementBitsOfRun(std::int32_t first, std::int32_t last, std::int32_t word)
{
  constexpr std::uint64_t all = ~std::uint64_t{ 0 };
  return (word == first >> 6 ? all << (first & 63) : all) & (word == last >> 6 ? all >> (63 - (last & 63)) : all);
}

/** The numbers, 0 to 3, that occur along an axis among the cubes of a word: bit x + 4 y + 16 z is cube (x, y, z). */
inline unsigned int
GetDelaunayRefinementLayers(std::uint64_t cubes, unsigned int axis)
{
  if (axis == 2)
  {
    return (cubes & 0xFFFFu ? 1u : 0u) | (cubes >> 16 & 0xFFFFu ? 2u : 0u) | (cubes >> 32 & 0xFFFFu ? 4u : 0u) |
           (cubes >> 48 ? 8u : 0u);
  }
  std::uint64_t slice = cubes | cubes >> 32;
  slice |= slice >> 16; // bit x + 4 y
  if (axis == 0)
  {
    slice |= slice >> 8;
    return static_cast<unsigned int>(slice | slice >> 4) & 15u;
  }
  slice |= slice >> 1;
  slice |= slice >> 2; // bit 4 y
  return static_cast<unsigned int>((slice & 1u) | (slice >> 3 & 2u) | (slice >> 6 & 4u) | (slice >> 9 & 8u));
}
} // end namespace itk

#endif
