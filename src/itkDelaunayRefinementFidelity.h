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
#ifndef itkDelaunayRefinementFidelity_h
#define itkDelaunayRefinementFidelity_h

#include "itkDelaunayRefinementComplex.h"
#include "itkDelaunayRefinementLocalDelta.h"
#include "itkDelaunayRefinementTriangleGrid.h"

namespace itk
{
/** \class DelaunayRefinementFidelity
 * \brief Where the facets that part regions, and the surface, are farther from each other than a bound.
 *
 * Certified, not sampled: balls around pieces of either that together cover it are asked for their distance to the
 * other, and pieces for which the answer is not clear are split. What was certified is kept as long as the facets are
 * there that it was certified by.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementFidelity
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementComplex::IndexType;
  using DistanceType = DelaunayRefinementDistance;

  /** A bound on the distance, and what the \c parameters say of that over delta. */
  DelaunayRefinementFidelity(const DelaunayRefinementOracle &     oracle,
                             const DelaunayRefinementParameters & parameters,
                             double                               bound,
                             const DelaunayRefinementComplex &    complex,
                             const DelaunayRefinementLocalDelta & localDelta,
                             DelaunayRefinementThreads &          threads);

  /** A ball around what is too far, in which delta should be lowered, no further than to \c leastDelta. */
  struct PlaceType
  {
    PointType center;
    double    radius;
    double    leastDelta;
  };

  /** Points of the surface that are too far from the facets, and facets with points too far from the surface; none if
   * all are certified to be nearer than the bound. Points count as too far beyond 9/10 of it. Not all such places are
   * listed: small pieces are asked only if larger ones show next to none. */
  std::vector<PlaceType>
  FindFarPlaces();

  /** After FindFarPlaces(): the greatest distances from the facets to the surface, and from there to the facets. Each
   * is that of its place; no other is greater by more than \c tolerance. */
  DistanceType
  MeasureFromFacets(double tolerance) const;
  DistanceType
  MeasureFromSurface(double tolerance) const;

private:
  using PatchType = DelaunayRefinementSurfacePatches::PatchType;
  using TriangleType = DelaunayRefinementTriangleGrid::TriangleType;

  /** A facet that parts regions, or did. */
  struct FacetType
  {
    IndexType     cell{ DelaunayRefinementComplex::None };
    std::uint32_t generation{ 0 };
    std::uint32_t slot{ 0 };
  };

  /** A piece of the surface with a facet that is near enough, if there is one. */
  struct CertifiedType
  {
    PatchType patch;
    FacetType facet;
  };

  /** What one of several threads found. */
  struct PartType
  {
    std::vector<CertifiedType> pieces{};
    std::vector<PlaceType>     places{};
    std::uint32_t              nearest{ DelaunayRefinementTriangleGrid::None }; // of the last piece

    bool
    IsInLastPlace(const PointType & point) const
    {
      return !places.empty() &&
             DelaunayRefinementGeometry::Distance(point, places.back().center) < places.back().radius;
    }
  };

  struct BoundType
  {
    double distance;
    double leastDelta; // that may be asked for where it is not kept
  };

  /** The bound where a delta holds. */
  BoundType
  GetBound(double delta) const;

  bool
  PartsRegions(const FacetType & facet) const;

  TriangleType
  GetTriangle(const FacetType & facet) const;

  void
  FindFacets();

  enum class AnswerEnum : uint8_t
  {
    CERTIFIED,
    TOO_FAR,
    OPEN // pieces would have to be smaller
  };

  /** Certify what they can without splitting pieces of a radius below \c smallest, over the bound; a patch up to its
   * first place that is too far, for which the answer is false. */
  void
  CertifySurface(double smallest, std::vector<PlaceType> & places);
  bool
  CertifyPatch(const PatchType & patch, double smallest, PartType & part) const;
  void
  CertifyFacets(double smallest, std::vector<PlaceType> & places);

  /** Whether all points of a triangle are nearer to the surface than \c bound; \c place is one of them if that is too
   * far. */
  AnswerEnum
  CertifyTriangle(const TriangleType & triangle, double bound, double smallest, PointType & place) const;

  const DelaunayRefinementOracle &       m_Oracle;
  const DelaunayRefinementParameters &   m_Parameters;
  const DelaunayRefinementComplex &      m_Complex;
  const DelaunayRefinementLocalDelta &   m_LocalDelta;
  DelaunayRefinementThreads &            m_Threads;
  double                                 m_Bound;
  std::vector<FacetType>                 m_Facets{};
  DelaunayRefinementTriangleGrid         m_Grid{}; // of the facets, with their numbers
  std::vector<CertifiedType>             m_Pieces{};
  DelaunayRefinementArray<std::uint32_t> m_CertifiedFacets{}; // generation of the cell, four for each
};
} // end namespace itk

#endif
