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

#include "itkDelaunayRefinementFirstUses.h"

#include <algorithm>
#include <limits>

namespace itk
{
namespace
{
using IndexType = DelaunayRefinementComplex::IndexType;
using TriangleType = std::array<std::uint32_t, 3>;
using Threads = DelaunayRefinementThreads;

/** Fewer are no work for a thread. */
constexpr std::size_t LeastLength = 8192;

/** Calls \c action with each index less than \c size. */
template <typename TAction>
void
ForEach(Threads * threads, std::size_t size, const TAction & action)
{
  Threads::RunPieces(threads,
                     size,
                     Threads::ChoosePieceLength(threads, size, LeastLength),
                     [&action](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i)
                       {
                         action(i);
                       }
                     });
}

/** What a range of the cells has of the boundary and the interfaces. */
struct BoundaryPartType
{
  std::vector<TriangleType>                 triangles{};
  std::vector<std::array<std::uint32_t, 2>> regions{};
};
} // namespace

DelaunayRefinementResult
ExtractDelaunayRefinementResult(const DelaunayRefinementComplex & complex, DelaunayRefinementThreads * threads)
{
  const auto &             triangulation = complex.GetTriangulation();
  const std::size_t        numberOfCells = triangulation.GetNumberOfCellIndexes();
  const std::size_t        length = Threads::ChoosePieceLength(threads, numberOfCells, LeastLength);
  const std::size_t        numberOfPieces = Threads::CountPieces(numberOfCells, length);
  DelaunayRefinementResult result;

  // A byte each, as every cell is asked for by its neighbors: its region, or the largest number.
  constexpr std::uint8_t                large = std::numeric_limits<std::uint8_t>::max();
  DelaunayRefinementArray<std::uint8_t> sides(numberOfCells);
  std::vector<std::size_t>              firsts(numberOfPieces + 1, 0);
  Threads::RunPieces(threads, numberOfCells, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      // Infinite cells are outside.
      const auto          cell = static_cast<IndexType>(i);
      const std::uint32_t region = triangulation.IsAlive(cell) ? complex.GetRegion(cell) : 0;
      sides[i] = static_cast<std::uint8_t>(std::min<std::uint32_t>(region, large));
      count += region != 0 ? 1 : 0;
    }
    firsts[piece + 1] = count;
  });
  for (std::size_t i = 0; i < numberOfPieces; ++i)
  {
    firsts[i + 1] += firsts[i];
  }

  // With the numbers that vertices have in the triangulation, first.
  std::vector<BoundaryPartType> parts(numberOfPieces);
  result.tetrahedra.resize(firsts.back());
  result.regions.resize(firsts.back());
  Threads::RunPieces(threads, numberOfCells, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    std::size_t next = firsts[piece];
    for (std::size_t i = begin; i < end; ++i)
    {
      if (sides[i] == 0)
      {
        continue;
      }
      const auto & cell = triangulation.GetCell(static_cast<IndexType>(i));
      const auto   region = complex.GetRegion(static_cast<IndexType>(i));
      result.tetrahedra[next] = cell.vertices;
      result.regions[next] = region;
      ++next;
      for (unsigned int j = 0; j < 4; ++j)
      {
        const IndexType neighbor = cell.neighbors[j];
        if (sides[neighbor] < sides[i] || (sides[neighbor] == large && complex.GetRegion(neighbor) < region))
        {
          const auto & face = DelaunayRefinementComplex::OutwardFacets[j];
          parts[piece].triangles.push_back({ cell.vertices[face[0]], cell.vertices[face[1]], cell.vertices[face[2]] });
          parts[piece].regions.push_back({ region, sides[neighbor] == 0 ? 0 : complex.GetRegion(neighbor) });
        }
      }
    }
  });

  // Points are numbered as the tetrahedra use them.
  const DelaunayRefinementFirstUses uses(result.tetrahedra.empty() ? nullptr : result.tetrahedra.front().data(),
                                         4 * result.tetrahedra.size(),
                                         triangulation.GetNumberOfVertexIndexes(),
                                         threads);
  result.points.resize(uses.GetNumberOfUsed());
  result.pointKinds.resize(uses.GetNumberOfUsed());
  ForEach(threads, triangulation.GetNumberOfVertexIndexes(), [&](std::size_t i) {
    const auto          vertex = static_cast<IndexType>(i);
    const std::uint32_t number = uses.GetNumber(vertex);
    if (number != DelaunayRefinementFirstUses::None)
    {
      result.points[number] = complex.GetPoint(vertex);
      result.pointKinds[number] = complex.GetKind(vertex);
    }
  });
  ForEach(threads, result.tetrahedra.size(), [&](std::size_t i) {
    for (std::uint32_t & vertex : result.tetrahedra[i])
    {
      vertex = uses.GetNumber(vertex);
    }
  });

  for (std::size_t i = 0; i < numberOfPieces; ++i)
  {
    firsts[i + 1] = firsts[i] + parts[i].triangles.size();
  }
  result.boundaryTriangles.resize(firsts.back());
  result.boundaryRegions.resize(firsts.back());
  Threads::RunPieces(threads, numberOfPieces, 1, [&](std::size_t piece, std::size_t, std::size_t) {
    std::size_t next = firsts[piece];
    for (const TriangleType & t : parts[piece].triangles)
    {
      result.boundaryTriangles[next++] = { uses.GetNumber(t[0]), uses.GetNumber(t[1]), uses.GetNumber(t[2]) };
    }
    std::copy(parts[piece].regions.begin(),
              parts[piece].regions.end(),
              result.boundaryRegions.begin() + static_cast<std::ptrdiff_t>(firsts[piece]));
  });
  return result;
}
} // end namespace itk
