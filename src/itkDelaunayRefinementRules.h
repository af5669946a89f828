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
#ifndef itkDelaunayRefinementRules_h
#define itkDelaunayRefinementRules_h

#include "itkDelaunayRefinementComplex.h"
#include "itkDelaunayRefinementQueue.h"
#include "itkDelaunayRefinementSurfaceSample.h"

#include <limits>

namespace itk
{
/** \class DelaunayRefinementRules
 * \brief Rules R2, R3, R4 and R4' of the paper: does a rule fire for a cell, and which point does it propose?
 *
 * Notation of the paper in these files: delta, rhoBar (bound on the radius-edge ratio), c and r (center and radius of a
 * circumball), t (tetrahedron), f (facet), q (center of a surface ball). Rule R1 is asked of the surface as a whole, by
 * DelaunayRefinementSurfaceSample. Bounds are tested with a relative margin of 1e-9.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementRules
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementComplex::IndexType;

  // Rules that are asked, and have their turn, together.
  enum class RuleGroupEnum : uint8_t
  {
    R2,
    ENCROACHMENT, // R2 with a circumcenter outside the box
    R3,
    R4 // the bound on cells' sizes and R4', too
  };

  DelaunayRefinementRules(const DelaunayRefinementOracle &        oracle,
                          const DelaunayRefinementParameters &    parameters,
                          const DelaunayRefinementComplex &       complex,
                          const DelaunayRefinementLocalDelta &    localDelta,
                          const DelaunayRefinementSurfaceSample & sample);

  /** Cheap: false only if R2 does not fire. */
  bool
  MayFireR2(IndexType cell) const;

  /** R2 (section III): an intersecting tetrahedron with r >= 2 delta, here one with a feature vertex unless the user
   * asks for all; proposes c(t). New edges are at least 2 delta long, so it ends. Delta is the same everywhere here,
   * also around components with a lower one: all that R2 gives is Lemma 4, and there R1 gives more than that. */
  bool
  FiresR2(IndexType cell) const;

  /** R3 (section III): a restricted facet, the one opposite to vertex \c i, with a surface ball of radius >= delta;
   * proposes q.
   *
   * A surface ball is empty of vertices and its center is on the surface, so that R1, which leaves no surface point
   * farther than delta from a feature vertex, excludes such balls for all restricted facets. What is left to R3 are the
   * facets between a tetrahedron with its circumcenter inside and one with its circumcenter outside, the mesh's
   * boundary to be. For them R3 also fires if the radius is not smaller than the facet's shortest edge, which keeps
   * planar angles above 30 degrees where delta varies, and new edges no shorter than old ones; and, for rhoBar >= 2, if
   * a vertex of the facet is off the surface, which Lemma 5 excludes for a constant delta: new edges are at least half
   * of those at that vertex then, and no shorter than a quarter of delta. */
  bool
  FiresR3(IndexType cell, unsigned int i, PointType & center) const;

  /** R4 (section III): r / shortest edge >= rhoBar and c(t) inside; proposes c(t). Applied to intersecting tetrahedra,
   * too. */
  bool
  FiresR4(IndexType cell) const;

  /** The user's bound on circumradii inside; proposes c(t). New edges are no shorter than the bound. */
  bool
  FiresCellSize(IndexType cell) const;

  /** R4' (section VI-B): a dihedral angle below the user's bound and c(t) inside; proposes c(t). The paper has no proof
   * that it ends; here it fires only while new edges are at least a quarter of delta long. */
  bool
  FiresR4Prime(IndexType cell) const;

  /** A rule that may fire, or that fires if there is nothing left to ask. */
  struct FindingType
  {
    RuleGroupEnum                      which;
    DelaunayRefinementQueue::EntryType entry;
    std::uint32_t                      block; // of the circumcenter
  };

  /** Appends what is to be asked again, or to be done, for a new cell and those of its facets that have their bit set.
   */
  void
  Examine(IndexType cell, unsigned int facets, std::vector<FindingType> & findings) const;

  /** Whether any rule fires for a cell or one of its facets. */
  bool
  Fires(IndexType cell) const;

private:
  /** Whether the regions on either side of a facet differ: quickly asked before FiresR3(), which asks it, too. */
  bool
  IsBetweenRegions(IndexType cell, unsigned int i) const
  {
    return m_Complex.GetRegion(cell) != m_Complex.GetRegion(m_Complex.GetTriangulation().GetCell(cell).neighbors[i]);
  }

  bool
  HasFeatureVertex(IndexType cell) const;

  /** The largest delta of the feature vertices of a cell, one left out; the largest of all if there is none. Where
   * components with different deltas meet, the facets' edges see to the transition. */
  double
  GetDeltaOfFeatures(const std::array<IndexType, 4> & vertices, unsigned int leftOut) const;

  /** Surface balls of a facet with at least this squared radius make R3 fire; infinity if none can be so large. */
  double
  ComputeSquaredR3Threshold(IndexType cell, unsigned int i) const;

  /** A surface point between two points of different regions. */
  void
  FindCrossing(const PointType & from, const PointType & to, PointType & crossing) const;

  const DelaunayRefinementOracle &        m_Oracle;
  const DelaunayRefinementParameters &    m_Parameters;
  const DelaunayRefinementComplex &       m_Complex;
  const DelaunayRefinementLocalDelta &    m_LocalDelta;
  const DelaunayRefinementSurfaceSample & m_Sample;
  double                                  m_LargestDihedralCosine;

  // R1 leaves no surface farther from a vertex, if the oracle knows of all.
  double m_SquaredLargestBall{ std::numeric_limits<double>::infinity() };
};
} // end namespace itk

#endif
