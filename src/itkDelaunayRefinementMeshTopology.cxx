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
#include "itkDelaunayRefinementMeshTopology.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace itk
{
namespace
{
using IndexType = DelaunayRefinementComplex::IndexType;

constexpr std::size_t CellsPerPiece = 4096;

using PartType = std::vector<IndexType>;

/** The cells of what is inside, or outside, in parts that facets join. */
std::vector<PartType>
FindParts(const DelaunayRefinementComplex & complex, bool isInside)
{
  const auto &          triangulation = complex.GetTriangulation();
  const auto            belongs = [&](IndexType cell) { return (complex.GetRegion(cell) != 0) == isInside; };
  std::vector<bool>     isSeen(triangulation.GetNumberOfCellIndexes(), false);
  std::vector<PartType> parts;
  for (IndexType first = 0; first < isSeen.size(); ++first)
  {
    if (isSeen[first] || !triangulation.IsAlive(first) || !belongs(first))
    {
      continue;
    }
    parts.push_back({ first });
    isSeen[first] = true;
    for (std::size_t i = 0; i < parts.back().size(); ++i)
    {
      for (const IndexType neighbor : triangulation.GetCell(parts.back()[i]).neighbors)
      {
        if (!isSeen[neighbor] && belongs(neighbor))
        {
          isSeen[neighbor] = true;
          parts.back().push_back(neighbor);
        }
      }
    }
  }
  return parts;
}

/** Appends the finite cells of parts with an owner that a larger part has already. */
template <typename TFindOwner>
void
AppendSuperfluous(const DelaunayRefinementComplex & complex,
                  std::vector<PartType>             parts,
                  const TFindOwner &                findOwner,
                  PartType &                        superfluous)
{
  std::stable_sort(
    parts.begin(), parts.end(), [](const PartType & a, const PartType & b) { return a.size() > b.size(); });
  std::set<std::uint32_t> owners;
  for (const PartType & part : parts)
  {
    if (!owners.insert(findOwner(part)).second)
    {
      std::copy_if(part.begin(), part.end(), std::back_inserter(superfluous), [&](IndexType cell) {
        return !complex.GetTriangulation().IsInfinite(cell);
      });
    }
  }
}
} // namespace

DelaunayRefinementTopology
CountDelaunayRefinementMeshTopology(const DelaunayRefinementComplex & complex)
{
  const auto &      triangulation = complex.GetTriangulation();
  std::vector<bool> isOnBoundary(triangulation.GetNumberOfVertexIndexes(), false);
  std::int64_t      vertices = 0;
  std::int64_t      facets = 0;
  for (IndexType index = 0; index < triangulation.GetNumberOfCellIndexes(); ++index)
  {
    if (!triangulation.IsAlive(index) || complex.GetRegion(index) == 0)
    {
      continue;
    }
    const auto & cell = triangulation.GetCell(index);
    for (unsigned int i = 0; i < 4; ++i)
    {
      if (complex.GetRegion(cell.neighbors[i]) != 0)
      {
        continue;
      }
      ++facets;
      for (const unsigned int corner : DelaunayRefinementComplex::OutwardFacets[i])
      {
        const IndexType vertex = cell.vertices[corner];
        vertices += isOnBoundary[vertex] ? 0 : 1;
        isOnBoundary[vertex] = true;
      }
    }
  }
  DelaunayRefinementTopology topology;
  topology.isKnown = true;
  topology.components = static_cast<std::int64_t>(FindParts(complex, true).size());
  // All but what is around the object.
  topology.cavities = static_cast<std::int64_t>(FindParts(complex, false).size()) - 1;
  // Two facets share each edge.
  topology.eulerCharacteristic = vertices - facets / 2;
  return topology;
}

std::vector<DelaunayRefinementPoint>
FindHiddenDelaunayRefinementSurface(const DelaunayRefinementOracle &  oracle,
                                    const DelaunayRefinementComplex & complex,
                                    DelaunayRefinementThreads &       threads)
{
  using PointsType = std::vector<DelaunayRefinementPoint>;
  const auto &            triangulation = complex.GetTriangulation();
  const std::size_t       numberOfCells = triangulation.GetNumberOfCellIndexes();
  std::vector<PointsType> parts(DelaunayRefinementThreads::CountPieces(numberOfCells, CellsPerPiece));
  DelaunayRefinementThreads::RunPieces(
    &threads, numberOfCells, CellsPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      for (IndexType cell = static_cast<IndexType>(begin); cell < end; ++cell)
      {
        if (!triangulation.IsAlive(cell) || triangulation.IsInfinite(cell))
        {
          continue;
        }
        for (const IndexType neighbor : triangulation.GetCell(cell).neighbors)
        {
          DelaunayRefinementPoint crossing;
          if (cell < neighbor && !triangulation.IsInfinite(neighbor) &&
              complex.GetRegion(cell) == complex.GetRegion(neighbor) &&
              oracle.FindFirstCrossing(complex.GetCircumcenter(cell), complex.GetCircumcenter(neighbor), crossing))
          {
            parts[piece].push_back(crossing);
          }
        }
      }
    });
  PointsType all;
  for (const PointsType & part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

std::vector<IndexType>
FindSuperfluousDelaunayRefinementParts(const DelaunayRefinementOracle &  oracle,
                                       const DelaunayRefinementComplex & complex)
{
  const auto & triangulation = complex.GetTriangulation();
  const auto   findComponent = [&](const PartType & part) {
    return oracle.FindComponent(complex.GetCircumcenter(part.front()));
  };
  const auto findCavity = [&](const PartType & part) {
    const auto isInfinite = [&](IndexType cell) { return triangulation.IsInfinite(cell); };
    return std::any_of(part.begin(), part.end(), isInfinite) ? oracle.GetNumberOfCavities()
                                                             : oracle.FindCavity(complex.GetCircumcenter(part.front()));
  };
  PartType superfluous;
  AppendSuperfluous(complex, FindParts(complex, true), findComponent, superfluous);
  AppendSuperfluous(complex, FindParts(complex, false), findCavity, superfluous);
  return superfluous;
}
} // end namespace itk
