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
#ifndef itkDelaunayRefinementInteriorSeeds_h
#define itkDelaunayRefinementInteriorSeeds_h

#include "itkDelaunayRefinementOracle.h"
#include "itkDelaunayRefinementThreads.h"

#include <functional>
#include <vector>

namespace itk
{
/** Free vertices where rule R2 would put many: inside the object, near its surface, at least 2 delta away from feature
 * vertices and from each other, as R2's own are (docs/guarantees.md, section 10).
 *
 * R2 inserts the circumcenters of large balls one after the other, each of which changes a hundred tetrahedra. These
 * are cheap to insert, with the feature vertices, and leave R2 with little to do. Always the same in the same order,
 * however many \c threads there are; rounded to floats if \c roundToFloat is set; none if delta is very small against
 * the box around the surface. None if \c keepGoing, asked now and then on the calling thread, said so.
 */
std::vector<DelaunayRefinementPoint>
FindDelaunayRefinementInteriorSeeds(const DelaunayRefinementOracle &             oracle,
                                    const std::vector<DelaunayRefinementPoint> & features,
                                    double                                       delta,
                                    bool                                         roundToFloat,
                                    DelaunayRefinementThreads &                  threads,
                                    const std::function<bool()> &                keepGoing);
} // end namespace itk

#endif
