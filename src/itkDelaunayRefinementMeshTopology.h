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
#ifndef itkDelaunayRefinementMeshTopology_h
#define itkDelaunayRefinementMeshTopology_h

#include "itkDelaunayRefinementComplex.h"

namespace itk
{
/** Counts the topology of all regions together, whose boundary is a 2-manifold. */
DelaunayRefinementTopology
CountDelaunayRefinementMeshTopology(const DelaunayRefinementComplex & complex);

/** Where two tetrahedra of one region meet whose circumcenters have surface between them: the first crossing from the
 * one with the smaller number. Where delta is small against the object there is none (Edelsbrunner and Shah,
 * Triangulating topological spaces). */
std::vector<DelaunayRefinementPoint>
FindHiddenDelaunayRefinementSurface(const DelaunayRefinementOracle &  oracle,
                                    const DelaunayRefinementComplex & complex,
                                    DelaunayRefinementThreads &       threads);

/** The tetrahedra of parts, joined by facets, that are one too many in a component of the object, in one of its
 * cavities, or around it: the largest part of each is the one that should be there. */
std::vector<DelaunayRefinementComplex::IndexType>
FindSuperfluousDelaunayRefinementParts(const DelaunayRefinementOracle &  oracle,
                                       const DelaunayRefinementComplex & complex);
} // end namespace itk

#endif
