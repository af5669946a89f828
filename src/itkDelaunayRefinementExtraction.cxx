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
#include "itkDelaunayRefinementExtraction.h"

namespace itk
{
namespace
{
/** The vertices of the face opposite to each vertex, counterclockwise as seen from outside. */
constexpr unsigned int FaceVertices[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
} // namespace

DelaunayRefinementResult
ExtractDelaunayRefinementResult(const DelaunayRefinementComplex & complex)
{
  using IndexType = DelaunayRefinementComplex::IndexType;
  const auto &             triangulation = complex.GetTriangulation();
  DelaunayRefinementResult result;

  const auto isInside = [&](IndexType cell) {
    return triangulation.IsAlive(cell) && !triangulation.IsInfinite(cell) && complex.GetRegion(cell) != 0;
  };
  std::size_t numberOfTetrahedra = 0;
  for (IndexType index = 0; index < triangulation.GetNumberOfCellIndexes(); ++index)
  {
    numberOfTetrahedra += isInside(index) ? 1 : 0;
  }
  result.tetrahedra.reserve(numberOfTetrahedra);
  result.regions.reserve(numberOfTetrahedra);
  result.points.reserve(complex.GetNumberOfVertices());
  result.pointKinds.reserve(complex.GetNumberOfVertices());

  std::vector<IndexType> numbers(triangulation.GetNumberOfVertexIndexes(), DelaunayRefinementComplex::None);
  const auto             numberOf = [&](IndexType vertex) {
    if (numbers[vertex] == DelaunayRefinementComplex::None)
    {
      numbers[vertex] = static_cast<IndexType>(result.points.size());
      result.points.push_back(complex.GetPoint(vertex));
      result.pointKinds.push_back(complex.GetKind(vertex));
    }
    return numbers[vertex];
  };
  for (IndexType index = 0; index < triangulation.GetNumberOfCellIndexes(); ++index)
  {
    if (!isInside(index))
    {
      continue;
    }
    const auto &                 cell = triangulation.GetCell(index);
    std::array<std::uint32_t, 4> tetrahedron;
    for (unsigned int i = 0; i < 4; ++i)
    {
      tetrahedron[i] = numberOf(cell.vertices[i]);
    }
    result.tetrahedra.push_back(tetrahedron);
    result.regions.push_back(complex.GetRegion(index));
    for (unsigned int i = 0; i < 4; ++i)
    {
      if (!isInside(cell.neighbors[i]))
      {
        const auto & face = FaceVertices[i];
        result.boundaryTriangles.push_back({ tetrahedron[face[0]], tetrahedron[face[1]], tetrahedron[face[2]] });
        result.boundaryRegions.push_back(complex.GetRegion(index));
      }
    }
  }
  return result;
}
} // end namespace itk
