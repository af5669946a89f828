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
#include "itkDelaunayRefinementGeometry.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace itk
{
DelaunayRefinementGeometry::SphereType
DelaunayRefinementGeometry::ComputeExactCircumsphere(const PointType & a,
                                                     const PointType & b,
                                                     const PointType & c,
                                                     const PointType & d)
{
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto            exact = [](const PointType & p) { return Kernel::Point_3(p[0], p[1], p[2]); };
  const Kernel::Point_3 first = exact(a);
  const Kernel::Point_3 center = CGAL::circumcenter(first, exact(b), exact(c), exact(d));
  return { { CGAL::to_double(center.x()), CGAL::to_double(center.y()), CGAL::to_double(center.z()) },
           CGAL::to_double(CGAL::squared_distance(center, first)) };
}
} // end namespace itk
