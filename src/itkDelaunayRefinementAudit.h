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
#ifndef itkDelaunayRefinementAudit_h
#define itkDelaunayRefinementAudit_h

#include "itkDelaunayRefinementRules.h"

namespace itk
{
/** Asks every rule anew for every cell, and every facet, of a triangulation: counts by RefinementRule of where it would
 * fire. R1 is asked as the paper asks it, of the surface points closest to circumcenters; SHAPE not at all. */
std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules>
CountFiringDelaunayRefinementRules(const DelaunayRefinementOracle &        oracle,
                                   const DelaunayRefinementLocalDelta &    localDelta,
                                   const DelaunayRefinementSurfaceSample & sample,
                                   const DelaunayRefinementComplex &       complex,
                                   const DelaunayRefinementRules &         rules);
} // end namespace itk

#endif
