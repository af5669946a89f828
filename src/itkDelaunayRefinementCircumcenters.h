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
#ifndef itkDelaunayRefinementCircumcenters_h
#define itkDelaunayRefinementCircumcenters_h

#include "itkDelaunayRefinementBlockQueue.h"
#include "itkDelaunayRefinementRules.h"

namespace itk
{
/** \class DelaunayRefinementCircumcenters
 * \brief Inserts the circumcenters of some cells at a time as free vertices, on several threads.
 *
 * First all cells are asked for themselves, and what their circumcenters' insertions would change is found; then, in
 * order, those insertions are kept that are apart from the ones before; then these are done. What comes out depends on
 * the cells and their order alone, not on threads.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementCircumcenters
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementComplex::IndexType;
  using RefinementRule = DelaunayRefinementEnums::RefinementRule;
  using EntryType = DelaunayRefinementBlockQueue::EntryType;

  /** So many at a time; more would take more caches than one thread has. */
  static constexpr unsigned int MostItems = 16;

  enum class OutcomeEnum : uint8_t
  {
    NOTHING, // no cell fires
    INSERTED,
    LATER,  // too near to another one
    BEYOND, // not strictly inside the box
    FULL    // there are as many vertices as there may be
  };

  /** What comes of a block: of the first of its cells that fires, or of the last one asked. */
  struct ItemType
  {
    EntryType                                         entry{};
    std::size_t                                       numberOfCells{ 0 }; // asked
    OutcomeEnum                                       outcome{ OutcomeEnum::NOTHING };
    RefinementRule                                    rule{ RefinementRule::R2 };
    DelaunayRefinementComplex::StarType               star{};
    std::vector<DelaunayRefinementRules::FindingType> findings{}; // of the new cells
  };

  /** Whether a rule fires for a cell, and which. Asked on several threads. */
  using AskType = std::function<bool(IndexType cell, RefinementRule & rule)>;

  DelaunayRefinementCircumcenters(DelaunayRefinementComplex &     complex,
                                  const DelaunayRefinementRules & rules,
                                  DelaunayRefinementThreads &     threads);

  /** Takes cells of a queue, of some blocks until one fires; false if there were none. */
  bool
  Apply(DelaunayRefinementBlockQueue & queue, const AskType & ask, std::uint64_t maximumNumberOfVertices);

  /** What became of the cells that Apply() took. */
  const std::vector<ItemType> &
  GetItems() const
  {
    return m_Items;
  }

private:
  void
  Find(DelaunayRefinementBlockQueue & queue,
       std::uint32_t                  block,
       const AskType &                ask,
       unsigned int                   thread,
       ItemType &                     item) const;

  void
  Fill(ItemType & item, unsigned int thread);

  DelaunayRefinementComplex &     m_Complex;
  const DelaunayRefinementRules & m_Rules;
  DelaunayRefinementThreads &     m_Threads;
  std::vector<ItemType>           m_Items{};
  std::size_t                     m_Most{ 1 };
};
} // end namespace itk

#endif
