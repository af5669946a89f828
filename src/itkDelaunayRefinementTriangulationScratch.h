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
#ifndef itkDelaunayRefinementTriangulationScratch_h
#define itkDelaunayRefinementTriangulationScratch_h

#include "itkDelaunayRefinementTriangulation.h"

// Shared by the sources of the triangulation alone.

namespace itk
{
/** \class DelaunayRefinementTriangulation::ScratchType
 * \brief Marks of cells and vertices, and what links the cells of a star or fills a hole. */
class DelaunayRefinementTriangulation::ScratchType
{
public:
  static constexpr std::size_t MostVerticesOfMatrix = 512;

  /** Of cells, at the start of a search. */
  static constexpr std::size_t LeastRoom = 64;

  // Of cells that the search for a cavity has seen.
  enum class MarkEnum : std::uint8_t
  {
    NONE,
    IN,
    OUT
  };

  /** Two cells of a star meet in an edge of the cavity's boundary. */
  struct SharedEdgeType
  {
    std::uint64_t vertices;
    IndexType     cell;
    std::uint8_t  slot;
  };

  void
  ClearMarks(const std::vector<IndexType> & cells)
  {
    for (const IndexType cell : cells)
    {
      cellMarks[cell] = MarkEnum::NONE;
    }
  }

  DelaunayRefinementArray<MarkEnum>               cellMarks{}; // NONE between calls
  std::vector<IndexType>                          seen{};      // cells with a mark
  std::vector<std::pair<IndexType, unsigned int>> facets{};    // by cell and slot
  DelaunayRefinementArray<std::uint64_t>          vertexPlaces{};
  std::uint32_t                                   numberOfStars{ 0 };
  std::vector<IndexType>                          matrix{}; // of a star's vertices: the cell beyond each edge
  std::vector<std::array<std::uint32_t, 3>>       facetPlaces{};
  std::vector<SharedEdgeType>                     sharedEdges{};
  std::vector<IndexType>                          around{};
  std::vector<OrientedFacetType>                  openFacets{};
};

template <typename TTakeCell, typename TFreeCells>
void
DelaunayRefinementTriangulation::TakeCells(StarType & star, const TTakeCell & takeCell, TFreeCells & freeCells)
{
  const std::size_t size = star.boundary.size();
  star.cells.resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    // Most of them take the places of cells that are gone.
    if (i < star.cavity.size())
    {
      star.cells[i] = star.cavity[i];
      m_Generations[star.cells[i]] += 2;
    }
    else
    {
      star.cells[i] = takeCell();
    }
  }
  for (std::size_t i = size; i < star.cavity.size(); ++i)
  {
    ++m_Generations[star.cavity[i]];
    freeCells.push_back(star.cavity[i]);
  }
}

inline DelaunayRefinementTriangulation::BoundaryType
DelaunayRefinementTriangulation::MakeBoundary(IndexType cell, unsigned int slot) const
{
  // By its vertex, as other threads may be changing what the cell beyond has for neighbors elsewhere.
  const IndexType beyond = m_Cells[cell].neighbors[slot];
  const auto &    inner = m_Cells[cell].vertices;
  const auto &    outer = m_Cells[beyond].vertices;
  const IndexType apex =
    inner[0] ^ inner[1] ^ inner[2] ^ inner[3] ^ inner[slot] ^ outer[0] ^ outer[1] ^ outer[2] ^ outer[3];
  const unsigned int mirror =
    (outer[1] == apex ? 1u : 0u) | (outer[2] == apex ? 2u : 0u) | (outer[3] == apex ? 3u : 0u);
  return { inner, beyond, static_cast<std::uint8_t>(slot), static_cast<std::uint8_t>(mirror) };
}
} // end namespace itk

#endif
