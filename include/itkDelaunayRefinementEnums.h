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
#ifndef itkDelaunayRefinementEnums_h
#define itkDelaunayRefinementEnums_h

#include "DelaunayRefinementExport.h"

#include <cstdint>
#include <ostream>

namespace itk
{
/** \class DelaunayRefinementEnums
 * \brief The words of the paper that appear in parameters, statistics and results.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementEnums
{
public:
  /** \class VertexKind
   * \brief What a vertex of the triangulation is (paper, section III). BOX_EDGE vertices lie on one of the 12 edges of
   * the bounding box, BOX vertices in the inside of one of its 6 faces; FEATURE vertices lie on the surface of the
   * object; FREE vertices are all others. */
  enum class VertexKind : uint8_t
  {
    BOX_EDGE,
    BOX,
    FREE,
    FEATURE
  };

  /** \class RefinementRule
   * \brief Why a vertex was inserted (paper, section III; R4_PRIME: section VI-B). CELL_SIZE is the user's bound on
   * circumradii, SHAPE replaces a vertex of a tetrahedron too flat to be stored, JUNCTION puts vertices on lines where
   * three regions meet, MANIFOLD where the boundary was no 2-manifold, SLIVER where a dihedral angle was small. */
  enum class RefinementRule : uint8_t
  {
    R1,
    R2,
    R3,
    R4,
    R4_PRIME,
    CELL_SIZE,
    SHAPE,
    JUNCTION,
    MANIFOLD,
    SLIVER
  };

  /** Length of lists by RefinementRule. */
  static constexpr unsigned int NumberOfRefinementRules = 10;

  /** \class EncroachmentCase
   * \brief How a circumcenter on or outside the box was replaced (paper, section III, E1 to E3). */
  enum class EncroachmentCase : uint8_t
  {
    NONE,
    E1,
    E2,
    E3
  };

  /** Length of lists by EncroachmentCase. */
  static constexpr unsigned int NumberOfEncroachmentCases = 4;

  /** \class TerminationReason
   * \brief Why the refinement ended. Only COMPLETED comes with a mesh. */
  enum class TerminationReason : uint8_t
  {
    COMPLETED,
    STOPPED_BY_CALLER,
    VERTEX_LIMIT,
    NO_SURFACE_FOUND
  };
};

extern DelaunayRefinement_EXPORT std::ostream &
                                 operator<<(std::ostream & out, DelaunayRefinementEnums::VertexKind value);
extern DelaunayRefinement_EXPORT std::ostream &
                                 operator<<(std::ostream & out, DelaunayRefinementEnums::RefinementRule value);
extern DelaunayRefinement_EXPORT std::ostream &
                                 operator<<(std::ostream & out, DelaunayRefinementEnums::EncroachmentCase value);
extern DelaunayRefinement_EXPORT std::ostream &
                                 operator<<(std::ostream & out, DelaunayRefinementEnums::TerminationReason value);
} // end namespace itk

#endif
