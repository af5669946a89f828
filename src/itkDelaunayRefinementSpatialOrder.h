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
#ifndef itkDelaunayRefinementSpatialOrder_h
#define itkDelaunayRefinementSpatialOrder_h

#include "itkDelaunayRefinementTypes.h"

namespace itk
{
/** An order in which points are quickly inserted into a triangulation: random rounds, each some times as long as the
 * one before it, and within a round along a space-filling curve. Always the same for the same points. */
std::vector<std::uint32_t>
ComputeDelaunayRefinementSpatialOrder(const std::vector<DelaunayRefinementPoint> & points);
} // end namespace itk

#endif
