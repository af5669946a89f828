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
#ifndef itkDelaunayRefinementEncroachment_h
#define itkDelaunayRefinementEncroachment_h

#include "itkDelaunayRefinementComplex.h"

namespace itk
{
/** \class DelaunayRefinementEncroachment
 * \brief The cases E1, E2 and E3 (section III): what to insert instead of a circumcenter on or outside the box.
 *
 * Let p be the point of the box closest to the circumcenter c, and h the radius of the circumball's disc in the plane
 * through p across c - p; the part of the circumball in the box lies within h of p. If p is on a box edge, the box-edge
 * vertices around it are at least h away from it, so that the diametral sphere of the box edge between them covers that
 * part (E1). If p is inside a face of the box, the box facet that contains p has no vertex nearer than h to it, so that
 * its circumradius is at least h (E2, E3). As the circumball holds a feature point, which is at least 2 sqrt 2 delta
 * away from the box, so is h: the proof of Lemma 2 applies.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementEncroachment
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementComplex::IndexType;
  using EncroachmentCase = DelaunayRefinementEnums::EncroachmentCase;

  /** What to insert, and the radius of the ball around it that is to be emptied. */
  struct ProposalType
  {
    EncroachmentCase which;
    PointType        point;
    double           radius;
  };

  explicit DelaunayRefinementEncroachment(const DelaunayRefinementComplex & complex);

  /** The case for a circumcenter; NONE if it is strictly inside the box. Midpoints of box edges are taken to be
   * inserted once proposed. */
  ProposalType
  FindEncroachment(const PointType & circumcenter);

private:
  /** The vertices on one of the 12 edges of the box, by their coordinate along it. */
  using BoxEdgeType = std::vector<double>;

  /** The edge along \c axis at the given sides of the other two axes, in ascending order of axes. */
  BoxEdgeType &
  GetBoxEdge(unsigned int axis, bool firstAtMaximum, bool secondAtMaximum);

  ProposalType
  SplitBoxEdge(EncroachmentCase which, unsigned int axis, const std::array<bool, 3> & atMaximum, double coordinate);

  /** The infinite cell over the box facet that contains a point of a face. */
  IndexType
  FindBoxFacet(unsigned int axis, bool atMaximum, const PointType & point) const;

  /** Any infinite cell over a box facet of a face. */
  IndexType
  FindAnyBoxFacet(unsigned int axis, bool atMaximum) const;

  bool
  IsOnFace(IndexType infiniteCell, unsigned int axis, double position) const;

  const DelaunayRefinementComplex & m_Complex;
  std::array<BoxEdgeType, 12>       m_BoxEdges{};
};
} // end namespace itk

#endif
