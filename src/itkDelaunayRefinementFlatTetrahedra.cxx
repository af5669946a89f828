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
#include "itkDelaunayRefinementFlatTetrahedra.h"

#include "itkDelaunayRefinementGeometry.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using PointType = DelaunayRefinementPoint;
using IndexType = DelaunayRefinementComplex::IndexType;
using VertexKind = DelaunayRefinementEnums::VertexKind;

/** Tetrahedra with a smaller volume over their longest edge cubed are too flat. */
constexpr double FlattestShape = 1e-10;

constexpr unsigned int MostCrossings = 32;
constexpr std::size_t  CellsPerPiece = 4096;

PointType
MoveAtRandom(const PointType & from, double distance, std::mt19937_64 & random)
{
  PointType to = from;
  for (double & coordinate : to)
  {
    coordinate += distance * (2.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 1.0);
  }
  return to;
}
} // namespace

bool
IsFlatDelaunayRefinementTetrahedron(const DelaunayRefinementComplex & complex, IndexType cell)
{
  const auto   p = complex.GetPoints(cell);
  const double determinant = Geometry::Determinant(p[0], p[1], p[2], p[3]);
  const auto   isLessFor = [determinant](double squaredLength) {
    return determinant < 6.0 * FlattestShape * squaredLength * std::sqrt(squaredLength);
  };
  // No edge is longer than the diameter, which decides most.
  constexpr double roundedUp = 4.0 * (1.0 + 1e-3);
  return isLessFor(roundedUp * complex.GetSquaredRadius(cell)) &&
         isLessFor(Geometry::ComputeSquaredLongestEdge(p[0], p[1], p[2], p[3]));
}

std::vector<IndexType>
FindVerticesOfFlatDelaunayRefinementTetrahedra(const DelaunayRefinementComplex & complex,
                                               DelaunayRefinementThreads &       threads)
{
  const auto &           triangulation = complex.GetTriangulation();
  std::vector<IndexType> vertices;
  std::mutex             mutex;
  const auto             visitPiece = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (auto cell = static_cast<IndexType>(begin); cell < end; ++cell)
    {
      if (triangulation.IsAlive(cell) && !triangulation.IsInfinite(cell) && complex.GetRegion(cell) != 0 &&
          IsFlatDelaunayRefinementTetrahedron(complex, cell))
      {
        const auto & v = triangulation.GetCell(cell).vertices;
        const auto   isFree = [&](IndexType vertex) { return complex.GetKind(vertex) == VertexKind::FREE; };
        const auto   free = std::find_if(v.begin(), v.end(), isFree);

        const std::lock_guard<std::mutex> lock(mutex);
        vertices.push_back(free != v.end() ? *free : *std::max_element(v.begin(), v.end()));
      }
    }
  };
  DelaunayRefinementThreads::RunPieces(&threads, triangulation.GetNumberOfCellIndexes(), CellsPerPiece, visitPiece);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

bool
FindDelaunayRefinementPlaceNearby(const DelaunayRefinementOracle & oracle,
                                  VertexKind                       kind,
                                  const PointType &                own,
                                  double                           distance,
                                  std::mt19937_64 &                random,
                                  PointType &                      place)
{
  place = MoveAtRandom(own, distance, random);
  bool isFound = kind != VertexKind::FEATURE;
  for (unsigned int i = 0; i < MostCrossings && !isFound; ++i)
  {
    // Through the surface nearby: the closest point may be known too roughly to differ from the old one.
    const PointType from = MoveAtRandom(own, distance, random);
    const PointType to = MoveAtRandom(own, distance, random);
    isFound = oracle.FindFirstCrossing(from, to, place);
  }
  return isFound;
}
} // end namespace itk
