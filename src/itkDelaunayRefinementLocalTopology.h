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
#ifndef itkDelaunayRefinementLocalTopology_h
#define itkDelaunayRefinementLocalTopology_h

#include "itkDelaunayRefinementDisjointSets.h"
#include "itkDelaunayRefinementTriangulation.h"

#include <vector>

namespace itk
{
/** \class DelaunayRefinementLocalTopology
 * \brief The boundaries of regions within a ball of cells, before and after the cells are replaced by others: have they
 * the same topology?
 *
 * They have if, for each region, both have parts with the same rims and the same Euler characteristics, and pass
 * through the same vertices between the same edges of the rims: docs/guarantees.md says why.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementLocalTopology
{
public:
  using IndexType = DelaunayRefinementTriangulation::IndexType;
  using RegionType = DelaunayRefinementRegion;

  /** \class FacetsType
   * \brief Facets that part regions. */
  class FacetsType
  {
  public:
    void
    Clear()
    {
      m_Facets.clear();
    }

    /** Adds a facet if it parts regions; may be added again from its other side. */
    void
    Add(const std::array<IndexType, 3> & vertices, RegionType one, RegionType other)
    {
      if (one != other)
      {
        m_Facets.push_back({ vertices, { one, other } });
        std::sort(m_Facets.back().vertices.begin(), m_Facets.back().vertices.end());
      }
    }

  private:
    friend class DelaunayRefinementLocalTopology;

    struct FacetType
    {
      std::array<IndexType, 3>  vertices;
      std::array<RegionType, 2> regions;
    };

    std::vector<FacetType> m_Facets{};
  };

  /** Leaves facets sorted, and each once. \c vertex may be on one of them alone if \c mayComeOrGo is set. */
  bool
  AreEqual(FacetsType & before, FacetsType & after, IndexType vertex, bool mayComeOrGo);

  /** Of the last call: vertices at which a new edge may touch the boundary beyond the ball of cells. */
  const std::vector<IndexType> &
  GetVerticesToAsk() const
  {
    return m_VerticesToAsk;
  }

private:
  using EdgeType = std::array<IndexType, 2>;

  /** The facets around a vertex from one edge of the rim to another one, by the edges' other ends; none if they go all
   * around. */
  struct FanType
  {
    IndexType                vertex;
    std::array<IndexType, 2> ends;

    bool
    operator==(const FanType & other) const
    {
      return vertex == other.vertex && ends == other.ends;
    }

    bool
    operator<(const FanType & other) const
    {
      return vertex != other.vertex ? vertex < other.vertex : ends < other.ends;
    }
  };

  /** A part of a boundary by the first edge of its rim. */
  struct PartType
  {
    EdgeType     name;
    std::int32_t eulerCharacteristic;

    bool
    operator==(const PartType & other) const
    {
      return name == other.name && eulerCharacteristic == other.eulerCharacteristic;
    }

    bool
    operator<(const PartType & other) const
    {
      return name != other.name ? name < other.name : eulerCharacteristic < other.eulerCharacteristic;
    }
  };

  /** The boundary of one region. */
  struct SurfaceType
  {
    std::vector<EdgeType>                      edges{};
    std::vector<std::pair<EdgeType, EdgeType>> rim{}; // with the part's name
    std::vector<PartType>                      parts{};
    std::vector<FanType>                       fans{};
  };

  /** An edge of a facet; its corners are those of the facet at the edge's ends. */
  struct EdgeOfFacetType
  {
    EdgeType                     edge;
    std::array<std::uint32_t, 2> corners;
  };

  static void
  Normalize(FacetsType & facets);

  /** False if more than two facets meet in an edge. */
  bool
  Describe(const FacetsType & facets, RegionType region, SurfaceType & surface);

  /** Takes the fans of a vertex out; false if there is more than one, or one that does not go all around. */
  static bool
  TakeOut(IndexType vertex, std::vector<FanType> & fans);

  SurfaceType                    m_Before{};
  SurfaceType                    m_After{};
  std::vector<RegionType>        m_Regions{};
  std::vector<EdgeOfFacetType>   m_EdgesOfFacets{};
  DelaunayRefinementDisjointSets m_JoinedFacets{};  // by edges inside, into parts
  DelaunayRefinementDisjointSets m_JoinedCorners{}; // of facets, into fans
  std::vector<PartType>          m_Parts{};
  std::vector<FanType>           m_Fans{};
  std::vector<IndexType>         m_VerticesToAsk{};
};
} // end namespace itk

#endif
