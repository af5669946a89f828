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
#ifndef itkCheckedMesh_h
#define itkCheckedMesh_h

#include "itkTestGeometry.h"

namespace itk::DelaunayRefinementTest
{
/** \class CheckedMesh
 * \brief A mesh as the checks see it: points, tetrahedra and the triangles that are said to be its boundary and the
 * interfaces between labels.
 */
struct CheckedMesh
{
  std::vector<PointType>                    points{};
  std::vector<std::array<std::uint32_t, 4>> tetrahedra{};
  std::vector<std::array<std::uint32_t, 3>> triangles{};

  /** Cell data, where the mesh has them. */
  std::vector<double> tetrahedronLabels{};
  std::vector<double> triangleLabels{};

  /** Of the two labels that a triangle parts, the smaller one. */
  std::vector<double> triangleOtherLabels{};
};

inline CheckedMesh
MakeCheckedMesh(const DelaunayRefinementResult & result)
{
  CheckedMesh mesh;
  mesh.points.assign(result.points.begin(), result.points.end());
  mesh.tetrahedra.assign(result.tetrahedra.begin(), result.tetrahedra.end());
  mesh.triangles.assign(result.boundaryTriangles.begin(), result.boundaryTriangles.end());
  mesh.tetrahedronLabels.assign(result.regions.begin(), result.regions.end());
  for (const auto & regions : result.boundaryRegions)
  {
    mesh.triangleLabels.push_back(regions[0]);
    mesh.triangleOtherLabels.push_back(regions[1]);
  }
  return mesh;
}
} // end namespace itk::DelaunayRefinementTest

#endif
