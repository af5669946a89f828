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
#include "BenchmarkTypes.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <chrono>

BenchmarkRunType
TriangulatePoints(const std::vector<std::array<double, 3>> & points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> converted;
  converted.reserve(points.size());
  for (const auto & point : points)
  {
    converted.emplace_back(point[0], point[1], point[2]);
  }
  const auto                                   start = std::chrono::steady_clock::now();
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(converted.begin(), converted.end());
  const std::chrono::duration<double>          seconds = std::chrono::steady_clock::now() - start;
  return { seconds.count(), triangulation.number_of_finite_cells(), 0 };
}
