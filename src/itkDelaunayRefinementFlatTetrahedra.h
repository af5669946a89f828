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
#ifndef itkDelaunayRefinementFlatTetrahedra_h
#define itkDelaunayRefinementFlatTetrahedra_h

#include "itkDelaunayRefinementComplex.h"
#include "itkDelaunayRefinementThreads.h"

#include <random>

namespace itk
{
/** Whether a tetrahedron is too flat to be stored. */
bool
IsFlatDelaunayRefinementTetrahedron(const DelaunayRefinementComplex &    complex,
                                    DelaunayRefinementComplex::IndexType cell);

/** A vertex of each tetrahedron of the mesh that is too flat to be stored, a free one if it has one; ascending. */
std::vector<DelaunayRefinementComplex::IndexType>
FindVerticesOfFlatDelaunayRefinementTetrahedra(const DelaunayRefinementComplex & complex,
                                               DelaunayRefinementThreads &       threads);

/** Another place for a vertex, about as far as \c distance from its own, and on the surface for a feature vertex; false
 * if none was found. */
bool
FindDelaunayRefinementPlaceNearby(const DelaunayRefinementOracle &    oracle,
                                  DelaunayRefinementEnums::VertexKind kind,
                                  const DelaunayRefinementPoint &     own,
                                  double                              distance,
                                  std::mt19937_64 &                   random,
                                  DelaunayRefinementPoint &           place);
} // end namespace itk

#endif
