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
#ifndef itkDelaunayRefinementJunctionSample_h
#define itkDelaunayRefinementJunctionSample_h

#include "itkDelaunayRefinementLocalDelta.h"

namespace itk
{
/** Feature vertices for the points where four regions or more meet, outside counted, then for the lines where three do;
 * before those of rule R1, which keep a whole delta away (docs/guarantees.md, section 12). Always the same in the same
 * order. Points are rounded to floats if \c roundToFloat is set. */
std::vector<DelaunayRefinementPoint>
SampleDelaunayRefinementJunctions(const DelaunayRefinementOracle &     oracle,
                                  const DelaunayRefinementLocalDelta & localDelta,
                                  bool                                 roundToFloat,
                                  const std::function<bool()> &        keepGoing);
} // end namespace itk

#endif
