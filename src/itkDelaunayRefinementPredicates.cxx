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
#include "itkDelaunayRefinementPredicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace itk
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3
ToKernel(const DelaunayRefinementPoint & point)
{
  return { point[0], point[1], point[2] };
}
} // namespace

int
DelaunayRefinementPredicates::ExactOrientation(const PointType & a,
                                               const PointType & b,
                                               const PointType & c,
                                               const PointType & d)
{
  return static_cast<int>(CGAL::orientation(ToKernel(a), ToKernel(b), ToKernel(c), ToKernel(d)));
}

int
DelaunayRefinementPredicates::ExactSideOfSphere(const PointType & a,
                                                const PointType & b,
                                                const PointType & c,
                                                const PointType & d,
                                                const PointType & p)
{
  return static_cast<int>(
    CGAL::side_of_oriented_sphere(ToKernel(a), ToKernel(b), ToKernel(c), ToKernel(d), ToKernel(p)));
}
} // end namespace itk
