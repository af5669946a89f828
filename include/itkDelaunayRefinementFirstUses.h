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
#ifndef itkDelaunayRefinementFirstUses_h
#define itkDelaunayRefinementFirstUses_h

#include "itkDelaunayRefinementMemory.h"
#include "itkDelaunayRefinementThreads.h"

#include <cstdint>
#include <limits>

namespace itk
{
/** \class DelaunayRefinementFirstUses
 * \brief Numbers the indexes in a list from 0, in the order in which they come there first.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementFirstUses
{
public:
  /** The number of indexes that are not in the list. */
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  /** All indexes are less than \c numberOfIndexes. On several threads if there are any, with the same numbers. */
  DelaunayRefinementFirstUses(const std::uint32_t *       indexes,
                              std::size_t                 length,
                              std::size_t                 numberOfIndexes,
                              DelaunayRefinementThreads * threads);

  /** How many different indexes are in the list. */
  std::uint32_t
  GetNumberOfUsed() const
  {
    return m_NumberOfUsed;
  }

  /** The number of an index. */
  std::uint32_t
  GetNumber(std::uint32_t index) const
  {
    return m_Numbers[index];
  }

private:
  void
  NumberInPieces(const std::uint32_t *       indexes,
                 std::size_t                 length,
                 std::size_t                 lengthOfPieces,
                 DelaunayRefinementThreads * threads);

  DelaunayRefinementArray<std::uint32_t> m_Numbers;
  std::uint32_t                          m_NumberOfUsed{ 0 };
};
} // end namespace itk

#endif
