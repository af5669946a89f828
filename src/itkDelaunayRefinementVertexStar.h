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
#ifndef itkDelaunayRefinementVertexStar_h
#define itkDelaunayRefinementVertexStar_h

#include "itkDelaunayRefinementComplex.h"
#include "itkDelaunayRefinementDisjointSets.h"

namespace itk
{
/** \class DelaunayRefinementVertexStar
 * \brief The cells around a vertex, with a region each that may be tried out.
 *
 * Seen from the vertex they are triangles of a sphere, whose corners are the edges at the vertex. The boundary of a
 * region is a 2-manifold at the vertex if it is one simple closed curve on that sphere.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementVertexStar
{
public:
  using IndexType = DelaunayRefinementComplex::IndexType;
  using RegionType = DelaunayRefinementComplex::RegionType;

  /** A cell by its number in the star. Neighbor i is across the edge of its triangle that is opposite to corner i. */
  struct CellType
  {
    IndexType                    index;
    std::array<std::uint32_t, 3> corners;
    std::array<std::uint32_t, 3> neighbors;
  };

  /** Takes the cells around a vertex, with the regions that they have. */
  void
  Find(const DelaunayRefinementComplex & complex, IndexType vertex);

  const std::vector<CellType> &
  GetCells() const
  {
    return m_Cells;
  }

  /** Of each cell; callers may try others. */
  std::vector<RegionType> &
  GetRegions()
  {
    return m_Regions;
  }

  /** How many places keep the regions' boundaries from being 2-manifolds here, outside left out: at each edge the pairs
   * of triangles beyond the first, and at the vertex the fans beyond the first. An edge also counts at its other end.
   */
  unsigned int
  CountBadPlaces();

  /** Sets of cells of one region that are connected over facets: those of the whole star, and those around each edge
   * where regions change more than twice. */
  void
  FindParts(std::vector<std::vector<std::uint32_t>> & parts);

private:
  /** \class NumberingType
   * \brief Numbers in the order in which indexes come first; a table of hashes, as stars have some tens of cells. */
  class NumberingType
  {
  public:
    void
    Clear()
    {
      m_Indexes.clear();
      m_Table.assign(LeastLength, None);
    }

    std::uint32_t
    Find(IndexType index)
    {
      std::uint32_t place = this->GetPlace(index);
      while (m_Table[place] != None && m_Indexes[m_Table[place]] != index)
      {
        place = (place + 1) & (m_Table.size() - 1);
      }
      if (m_Table[place] == None)
      {
        m_Table[place] = static_cast<std::uint32_t>(m_Indexes.size());
        m_Indexes.push_back(index);
        if (2 * m_Indexes.size() > m_Table.size())
        {
          this->Grow();
        }
        return static_cast<std::uint32_t>(m_Indexes.size() - 1);
      }
      return m_Table[place];
    }

    const std::vector<IndexType> &
    GetIndexes() const
    {
      return m_Indexes;
    }

  private:
    static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::size_t   LeastLength = 128;

    std::uint32_t
    GetPlace(IndexType index) const
    {
      return (index * 2654435769u >> 16) & static_cast<std::uint32_t>(m_Table.size() - 1);
    }

    void
    Grow();

    std::vector<IndexType>     m_Indexes{};
    std::vector<std::uint32_t> m_Table{};
  };

  unsigned int
  CountBadPlacesOf(RegionType region);

  /** Appends the connected parts among some cells. */
  template <typename TIsAmong>
  void
  AppendParts(const TIsAmong & isAmong, std::vector<std::vector<std::uint32_t>> & parts);

  std::vector<CellType>          m_Cells{};
  std::vector<RegionType>        m_Regions{};
  NumberingType                  m_CellNumbers{};
  NumberingType                  m_Corners{};
  std::vector<std::uint32_t>     m_Degrees{};
  DelaunayRefinementDisjointSets m_Fans{}; // corners that triangles join
  std::vector<RegionType>        m_Different{};
  std::vector<char>              m_IsVisited{};
};
} // end namespace itk

#endif
