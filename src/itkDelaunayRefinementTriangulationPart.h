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
#ifndef itkDelaunayRefinementTriangulationPart_h
#define itkDelaunayRefinementTriangulationPart_h

#include "itkDelaunayRefinementTriangulation.h"

// Shared by the sources of the triangulation alone.

namespace itk
{
/** \class DelaunayRefinementTriangulation::PartType
 * \brief What one thread may see and change while others change the rest.
 *
 * Vertices belong to one part or to none. A cell belongs to a part if two or more of its vertices do and none to
 * another part; the others, which part the parts, stay as they are. Facets with vertices of one part lead from cell to
 * cell of that part, or to one that stays: only the part's thread writes what lies beyond them. What lies beyond a
 * facet of several parts stays, and nobody looks beyond the facets of another part or of none. So threads need not
 * agree. */
class DelaunayRefinementTriangulation::PartType
{
public:
  static constexpr std::uint8_t NoPart = std::numeric_limits<std::uint8_t>::max();

  PartType(const std::vector<std::uint8_t> & partsOfVertices, std::uint8_t part)
    : m_PartsOfVertices(partsOfVertices.data())
    , m_Part(part)
  {}

  bool
  Has(IndexType vertex) const
  {
    return m_PartsOfVertices[vertex] == m_Part;
  }

  bool
  MayChange(const CellType & cell) const
  {
    unsigned int number = 0;
    for (const IndexType vertex : cell.vertices)
    {
      const std::uint8_t part = m_PartsOfVertices[vertex];
      if (part != m_Part && part != NoPart)
      {
        return false;
      }
      number += part == m_Part ? 1 : 0;
    }
    return number >= 2;
  }

  /** The cell is one that this part may see. */
  bool
  MaySeeBeyond(const CellType & cell, unsigned int slot) const
  {
    std::uint8_t other = NoPart;
    bool         hasSeveral = false;
    for (const unsigned int i : FacetVertices[slot])
    {
      const std::uint8_t part = m_PartsOfVertices[cell.vertices[i]];
      if (part == m_Part)
      {
        return true;
      }
      hasSeveral = hasSeveral || (part != NoPart && other != NoPart && part != other);
      other = part != NoPart ? part : other;
    }
    return hasSeveral;
  }

private:
  const std::uint8_t * m_PartsOfVertices;
  std::uint8_t         m_Part;
};
} // end namespace itk

#endif
