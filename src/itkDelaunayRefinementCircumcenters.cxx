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
#include "itkDelaunayRefinementCircumcenters.h"

#include <algorithm>

namespace itk
{
namespace
{
/** Of one block at a time, so that threads wait for each other now and then. */
constexpr std::size_t MostCellsAsked = 64;
} // namespace

DelaunayRefinementCircumcenters::DelaunayRefinementCircumcenters(DelaunayRefinementComplex &     complex,
                                                                 const DelaunayRefinementRules & rules,
                                                                 DelaunayRefinementThreads &     threads)
  : m_Complex(complex)
  , m_Rules(rules)
  , m_Threads(threads)
{}

bool
DelaunayRefinementCircumcenters::Apply(DelaunayRefinementBlockQueue & queue,
                                       const AskType &                ask,
                                       std::uint64_t                  maximumNumberOfVertices)
{
  const std::vector<std::uint32_t> & blocks = queue.ChooseBlocks(m_Most);
  m_Items.resize(blocks.size());
  if (blocks.empty())
  {
    return false;
  }
  m_Threads.Run(m_Items.size(),
                [&](std::size_t i, unsigned int thread) { this->Find(queue, blocks[i], ask, thread, m_Items[i]); });

  m_Complex.StartBatch();
  std::size_t numberOfProposals = 0;
  std::size_t numberOfInsertions = 0;
  for (ItemType & item : m_Items)
  {
    if (item.outcome != OutcomeEnum::LATER)
    {
      continue;
    }
    ++numberOfProposals;
    if (m_Complex.GetNumberOfVertices() >= maximumNumberOfVertices)
    {
      item.outcome = OutcomeEnum::FULL;
    }
    else if (m_Complex.Reserve(item.star, DelaunayRefinementEnums::VertexKind::FREE, 0.0))
    {
      item.outcome = OutcomeEnum::INSERTED;
      ++numberOfInsertions;
    }
  }
  if (numberOfInsertions > 0)
  {
    m_Threads.Run(m_Items.size(), [this](std::size_t i, unsigned int thread) { this->Fill(m_Items[i], thread); });
    for (const ItemType & item : m_Items)
    {
      if (item.outcome == OutcomeEnum::INSERTED)
      {
        m_Complex.Finish(item.star);
      }
    }
  }

  // As many at a time as have little to do with each other.
  if (2 * numberOfInsertions < numberOfProposals)
  {
    m_Most = std::max<std::size_t>(1, m_Most / 2);
  }
  else if (10 * numberOfInsertions >= 9 * numberOfProposals)
  {
    m_Most = std::min<std::size_t>(MostItems, 2 * m_Most);
  }
  return true;
}

void
DelaunayRefinementCircumcenters::Find(DelaunayRefinementBlockQueue & queue,
                                      std::uint32_t                  block,
                                      const AskType &                ask,
                                      unsigned int                   thread,
                                      ItemType &                     item) const
{
  item.outcome = OutcomeEnum::NOTHING;
  item.numberOfCells = 0;
  while (item.outcome == OutcomeEnum::NOTHING && item.numberOfCells < MostCellsAsked &&
         queue.Pop(m_Complex.GetTriangulation(), block, item.entry))
  {
    ++item.numberOfCells;
    const IndexType cell = item.entry.cell;
    if (ask(cell, item.rule))
    {
      const PointType center = m_Complex.Round(m_Complex.GetCircumcenter(cell));
      if (!m_Complex.IsStrictlyInsideBox(center))
      {
        item.outcome = OutcomeEnum::BEYOND;
      }
      else if (m_Complex.FindStar(center, cell, item.star, thread))
      {
        item.outcome = OutcomeEnum::LATER;
      }
    }
  }
}

void
DelaunayRefinementCircumcenters::Fill(ItemType & item, unsigned int thread)
{
  item.findings.clear();
  if (item.outcome != OutcomeEnum::INSERTED)
  {
    return;
  }
  m_Complex.Fill(item.star, thread);
  const auto & triangulation = m_Complex.GetTriangulation();
  for (std::size_t i = 0; i < item.star.cells.size(); ++i)
  {
    // The facets that others see, and those between two cells of the star once.
    const IndexType cell = item.star.cells[i];
    const auto &    neighbors = triangulation.GetCell(cell).neighbors;
    unsigned int    facets = 1u << item.star.boundary[i].slot;
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      facets |= neighbors[slot] > cell ? 1u << slot : 0;
    }
    m_Rules.Examine(cell, facets, item.findings);
  }
}
} // end namespace itk
