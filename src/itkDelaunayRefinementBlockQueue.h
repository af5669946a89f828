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
#ifndef itkDelaunayRefinementBlockQueue_h
#define itkDelaunayRefinementBlockQueue_h

#include "itkDelaunayRefinementBlocks.h"
#include "itkDelaunayRefinementQueue.h"

namespace itk
{
/** \class DelaunayRefinementBlockQueue
 * \brief Cells to be tested, by the block of space that holds their circumcenter: those of different blocks rarely
 * have to do with each other.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementBlockQueue
{
public:
  using IndexType = DelaunayRefinementTriangulation::IndexType;
  using EntryType = DelaunayRefinementQueue::EntryType;

  DelaunayRefinementBlockQueue();

  void
  Push(std::uint32_t block, const EntryType & entry)
  {
    m_Blocks[block].Push(entry);
  }

  /** Some blocks with entries, at most \c most. A block goes on to be one of them until it is empty, as what is near
   * was used a moment ago. */
  const std::vector<std::uint32_t> &
  ChooseBlocks(std::size_t most);

  /** Takes the oldest entry of a block whose cell still exists; false if there is none. Other threads may do so with
   * other blocks. */
  bool
  Pop(const DelaunayRefinementTriangulation & triangulation, std::uint32_t block, EntryType & entry)
  {
    return m_Blocks[block].Pop(triangulation, entry);
  }

  std::size_t
  GetLength() const;

private:
  static constexpr std::uint32_t NumberOfBlocks = DelaunayRefinementBlocks::NumberOfBlocks;

  bool
  HasEntries(std::uint32_t block) const
  {
    return m_Blocks[block].GetLength() > 0;
  }

  std::vector<DelaunayRefinementQueue> m_Blocks;
  std::vector<std::uint32_t>           m_Chosen{};
  std::vector<bool>                    m_IsChosen;
  std::uint32_t                        m_Next{ 0 };
};
} // end namespace itk

#endif
