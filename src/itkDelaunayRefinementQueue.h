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
#ifndef itkDelaunayRefinementQueue_h
#define itkDelaunayRefinementQueue_h

#include "itkDelaunayRefinementTriangulation.h"

namespace itk
{
/** \class DelaunayRefinementQueue
 * \brief Cells, or facets of cells, to be tested, first come first served; those that are gone are skipped.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementQueue
{
public:
  using IndexType = DelaunayRefinementTriangulation::IndexType;

  struct EntryType
  {
    IndexType     cell;
    std::uint32_t generation;
    unsigned int  facet;
  };

  void
  Push(const EntryType & entry)
  {
    m_Entries.push_back(entry);
  }

  /** Takes the oldest entry whose cell still exists; false if there is none. */
  bool
  Pop(const DelaunayRefinementTriangulation & triangulation, EntryType & entry)
  {
    while (m_Next < m_Entries.size())
    {
      entry = m_Entries[m_Next++];
      if (triangulation.GetGeneration(entry.cell) == entry.generation)
      {
        this->DropTaken();
        return true;
      }
    }
    m_Entries.clear();
    m_Next = 0;
    return false;
  }

  std::size_t
  GetLength() const
  {
    return m_Entries.size() - m_Next;
  }

private:
  void
  DropTaken()
  {
    constexpr std::size_t worthMoving = 65536;
    if (m_Next > worthMoving && 2 * m_Next > m_Entries.size())
    {
      m_Entries.erase(m_Entries.begin(), m_Entries.begin() + static_cast<std::ptrdiff_t>(m_Next));
      m_Next = 0;
    }
  }

  DelaunayRefinementArray<EntryType> m_Entries{};
  std::size_t                        m_Next{ 0 };
};
} // end namespace itk

#endif
