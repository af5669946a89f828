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
#ifndef itkDelaunayRefinementManifoldRepair_h
#define itkDelaunayRefinementManifoldRepair_h

#include "itkDelaunayRefinementDihedralAngles.h"
#include "itkDelaunayRefinementRules.h"
#include "itkDelaunayRefinementVertexStar.h"

#include <map>

namespace itk
{
/** \class DelaunayRefinementManifoldRepair
 * \brief Gives tetrahedra to other regions so that the regions' boundaries become 2-manifolds.
 *
 * Where delta is not small against the object, the tetrahedra of a region may touch in an edge or a vertex alone. A
 * small set of tetrahedra at such a place is given to the region beyond one of its facets if that leaves fewer such
 * places, no rule fires for those that come inside, and all new facets between regions have three feature vertices and
 * angles above 30 degrees. Each change leaves fewer bad places, so it ends.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementManifoldRepair
{
public:
  using IndexType = DelaunayRefinementComplex::IndexType;
  using RegionType = DelaunayRefinementComplex::RegionType;

  /** Tetrahedra with a dihedral angle below \c smallestAngle (degrees) are taken inside only if nothing else helps. */
  DelaunayRefinementManifoldRepair(const DelaunayRefinementOracle & oracle,
                                   const DelaunayRefinementRules &  rules,
                                   DelaunayRefinementComplex &      complex,
                                   DelaunayRefinementThreads &      threads,
                                   double                           smallestAngle);

  /** To be called when no rule fires. Returns the vertices where nothing helped, ascending. */
  std::vector<IndexType>
  Run();

  /** Gives all tetrahedra back to the regions of their circumcenters. */
  void
  Undo();

  /** Tetrahedra that are not in the region of their circumcenter. */
  std::size_t
  GetNumberOfChanges() const
  {
    return m_OwnRegions.size();
  }

  /** Whether a tetrahedron is one of them. */
  bool
  IsChanged(IndexType cell) const
  {
    return !m_OwnRegions.empty() && m_OwnRegions.count(cell) > 0;
  }

  /** The region of a tetrahedron's circumcenter. */
  RegionType
  GetOwnRegion(IndexType cell) const
  {
    const auto found = m_OwnRegions.find(cell);
    return found == m_OwnRegions.end() ? m_Complex.GetRegion(cell) : found->second;
  }

  /** To be called before a tetrahedron that is one of them goes. */
  void
  Forget(IndexType cell)
  {
    m_OwnRegions.erase(cell);
  }

  /** Gives a tetrahedron to a region. */
  void
  Give(IndexType cell, RegionType region);

private:
  /** Cells of the star at hand, and the region for them. */
  struct CandidateType
  {
    std::size_t begin; // in m_CellsOfCandidates
    std::size_t end;
    RegionType  region;
  };

  /** Makes a change that leaves fewer bad places, at a vertex with some; false if there is none. */
  bool
  Mend(IndexType vertex);

  void
  Change(const std::vector<IndexType> & cells, RegionType region);

  // Sets of cells of the star at hand, small ones first: most vertices need no others.
  enum class SetsEnum : uint8_t
  {
    CELLS,
    PAIRS, // that share a facet
    PARTS,
    NONE
  };

  /** Lists the next sets, each with regions that they might be given to; false if there are no more. */
  bool
  AddMoreCandidates();

  void
  AddCandidates(const std::uint32_t * cells, std::size_t numberOfCells);

  /** Whether a change leaves fewer bad places at the vertices of some cells, which it lists with those left. */
  bool
  LeavesFewerBad(const std::vector<IndexType> & cells, RegionType region);

  /** Whether the facets that would part regions may do so, and rules leave alone what would come inside; no slivers
   * among that unless \c maySlivers is set. */
  bool
  MayChange(const std::vector<IndexType> & cells, RegionType region, bool maySlivers);

  bool
  MayPartRegions(IndexType cell, unsigned int facet) const;

  /** Whether the last tetrahedra of a component would go. */
  bool
  WouldLoseComponent(const std::vector<IndexType> & cells) const;

  const DelaunayRefinementOracle &        m_Oracle;
  const DelaunayRefinementRules &         m_Rules;
  DelaunayRefinementComplex &             m_Complex;
  DelaunayRefinementThreads &             m_Threads;
  DelaunayRefinementDihedralAngles        m_Angles;
  DelaunayRefinementVertexStar            m_Star{};
  DelaunayRefinementVertexStar            m_OtherStar{};
  std::vector<CandidateType>              m_Candidates{};
  std::vector<std::uint32_t>              m_CellsOfCandidates{};
  SetsEnum                                m_NextSets{ SetsEnum::CELLS };
  std::vector<RegionType>                 m_RegionsBeside{};
  std::vector<std::vector<std::uint32_t>> m_Parts{};
  std::vector<bool>                       m_IsBad{};      // of vertices, while it runs
  std::vector<IndexType>                  m_Concerned{};  // by the last change that was asked about
  std::vector<unsigned int>               m_BadAfter{};   // their bad places, if it leaves fewer
  std::map<IndexType, RegionType>         m_OwnRegions{}; // of the circumcenters, where they are others
};
} // end namespace itk

#endif
