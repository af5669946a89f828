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
#ifndef itkDelaunayRefinementMissingComponents_h
#define itkDelaunayRefinementMissingComponents_h

#include "itkDelaunayRefinementComplex.h"
#include "itkDelaunayRefinementThreads.h"

namespace itk
{
/** The components in which no tetrahedron has its circumcenter, in ascending order. */
std::vector<std::uint32_t>
FindMissingDelaunayRefinementComponents(const DelaunayRefinementOracle &  oracle,
                                        const DelaunayRefinementComplex & complex,
                                        DelaunayRefinementThreads &       threads);

/** The cavities in which no tetrahedron outside has its circumcenter, in ascending order. */
std::vector<std::uint32_t>
FindMissingDelaunayRefinementCavities(const DelaunayRefinementOracle &  oracle,
                                      const DelaunayRefinementComplex & complex,
                                      DelaunayRefinementThreads &       threads);
} // end namespace itk

#endif
