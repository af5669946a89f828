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

namespace itk
{
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
} // end namespace itk

#endif
