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
#ifndef BenchmarkTypes_h
#define BenchmarkTypes_h

#include "itkImage.h"

#include <array>
#include <cstddef>
#include <vector>

using BenchmarkImageType = itk::Image<unsigned char, 3>;

/** One run, from the image or the points in memory to the mesh in memory. */
struct BenchmarkRunType
{
  double      seconds;
  std::size_t numberOfTetrahedra;
  std::size_t numberOfTriangles;
};

/** This project's filter. The mesh's points are stored in \c points. */
BenchmarkRunType
MeshByDelaunayRefinement(const BenchmarkImageType *           image,
                         double                               delta,
                         unsigned int                         numberOfThreads,
                         std::vector<std::array<double, 3>> & points);

/** CGAL Mesh_3: facet size delta, facet distance delta / 2, facet angle 30 degrees, radius-edge ratio 2, no
 * optimization. */
BenchmarkRunType
MeshByMesh3(const BenchmarkImageType * image, double delta);

/** CGAL's Delaunay triangulation of given points, which it sorts. */
BenchmarkRunType
TriangulatePoints(const std::vector<std::array<double, 3>> & points);

#endif
