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

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <chrono>
#include <cstring>

BenchmarkRunType
MeshByMesh3(const BenchmarkImageType * image, double delta)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using DomainType = CGAL::Labeled_mesh_domain_3<Kernel>;
  using TriangulationType = CGAL::Mesh_triangulation_3<DomainType>::type;
  using ComplexType = CGAL::Mesh_complex_3_in_triangulation_3<TriangulationType>;
  using CriteriaType = CGAL::Mesh_criteria_3<TriangulationType>;
  namespace params = CGAL::parameters;

  const auto size = image->GetBufferedRegion().GetSize();
  const auto spacing = image->GetSpacing();

  const auto   start = std::chrono::steady_clock::now();
  auto * const buffer =
    _createImage(size[0], size[1], size[2], 1, spacing[0], spacing[1], spacing[2], 1, WK_FIXED, SGN_UNSIGNED);
  std::memcpy(buffer->data, image->GetBufferPointer(), image->GetBufferedRegion().GetNumberOfPixels());
  const CGAL::Image_3 labels(buffer);
  const DomainType   domain = DomainType::create_labeled_image_mesh_domain(labels, params::relative_error_bound = 1e-6);
  const CriteriaType criteria(params::facet_angle = 30.0,
                              params::facet_size = delta,
                              params::facet_distance = 0.5 * delta,
                              params::cell_radius_edge_ratio = 2.0);
  const auto         mesh = CGAL::make_mesh_3<ComplexType>(
    domain, criteria, params::no_perturb(), params::no_exude(), params::no_lloyd(), params::no_odt());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return { seconds.count(), mesh.number_of_cells_in_complex(), mesh.number_of_facets_in_complex() };
}
