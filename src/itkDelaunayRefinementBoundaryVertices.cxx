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
#include "itkDelaunayRefinementBoundaryVertices.h"

#include <algorithm>
#include <numeric>

namespace itk
{
namespace
{
using IndexType = DelaunayRefinementComplex::IndexType;
using RegionType = DelaunayRefinementComplex::RegionType;

constexpr std::size_t CellsPerPiece = 16384;
constexpr std::size_t VerticesPerPiece = 4096;

/** A facet between two regions, turned as its side in \c region sees it. */
struct FacetType
{
  std::array<IndexType, 3> vertices;
  RegionType               region;
  RegionType               other;
};

/** The edge of a facet that is opposite to one of its vertices. */
struct EdgeType
{
  IndexType  from;
  IndexType  to;
  RegionType region;
  RegionType other;
};

std::vector<FacetType>
FindFacets(const DelaunayRefinementComplex & complex, IndexType begin, IndexType end)
{
  const auto &           triangulation = complex.GetTriangulation();
  std::vector<FacetType> facets;
  for (IndexType index = begin; index < end; ++index)
  {
    const RegionType region = triangulation.IsAlive(index) ? complex.GetRegion(index) : 0;
    for (unsigned int i = 0; i < 4 && region != 0; ++i)
    {
      const auto &     cell = triangulation.GetCell(index);
      const RegionType other = complex.GetRegion(cell.neighbors[i]);
      if (other < region)
      {
        const auto & face = DelaunayRefinementComplex::OutwardFacets[i];
        facets.push_back({ { cell.vertices[face[0]], cell.vertices[face[1]], cell.vertices[face[2]] }, region, other });
      }
    }
  }
  return facets;
}

/** Whether some edges, each once and in its direction, are one closed curve without a point twice. */
bool
AreOneCurve(const std::vector<std::pair<IndexType, IndexType>> & edges)
{
  std::size_t steps = 1;
  IndexType   at = edges.front().second;
  while (at != edges.front().first)
  {
    const auto next = std::find_if(edges.begin(), edges.end(), [at](const auto & edge) { return edge.first == at; });
    if (next == edges.end() || ++steps > edges.size())
    {
      return false;
    }
    at = next->second;
  }
  return steps == edges.size();
}

/** Whether the edges opposite to a vertex are one curve for each region; \c curve is for what is between. */
bool
IsManifold(const EdgeType * begin, const EdgeType * end, std::vector<std::pair<IndexType, IndexType>> & curve)
{
  const auto isCurveOf = [&](RegionType region) {
    curve.clear();
    for (const EdgeType * edge = begin; edge != end; ++edge)
    {
      if (edge->region == region)
      {
        curve.emplace_back(edge->from, edge->to);
      }
      else if (edge->other == region)
      {
        curve.emplace_back(edge->to, edge->from);
      }
    }
    return AreOneCurve(curve);
  };
  bool isManifold = true;
  for (const EdgeType * edge = begin; edge != end && isManifold; ++edge)
  {
    // Each region once, at the first of its edges.
    for (const RegionType region : { edge->region, edge->other })
    {
      const bool isKnown = std::any_of(
        begin, edge, [region](const EdgeType & before) { return before.region == region || before.other == region; });
      isManifold = isManifold && (region == 0 || isKnown || isCurveOf(region));
    }
  }
  return isManifold;
}
} // namespace

std::vector<IndexType>
FindNonManifoldDelaunayRefinementVertices(const DelaunayRefinementComplex & complex,
                                          DelaunayRefinementThreads &       threads)
{
  using Threads = DelaunayRefinementThreads;
  const std::size_t                   numberOfCells = complex.GetTriangulation().GetNumberOfCellIndexes();
  const std::size_t                   numberOfVertices = complex.GetTriangulation().GetNumberOfVertexIndexes();
  std::vector<std::vector<FacetType>> facets(Threads::CountPieces(numberOfCells, CellsPerPiece));
  Threads::RunPieces(
    &threads, numberOfCells, CellsPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      facets[piece] = FindFacets(complex, static_cast<IndexType>(begin), static_cast<IndexType>(end));
    });

  // The edges opposite to a vertex, one vertex after another.
  std::vector<std::size_t> ends(numberOfVertices + 1, 0);
  for (const auto & some : facets)
  {
    for (const FacetType & facet : some)
    {
      for (const IndexType vertex : facet.vertices)
      {
        ++ends[vertex + 1];
      }
    }
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::size_t>          next(ends.begin(), ends.end() - 1);
  DelaunayRefinementArray<EdgeType> edges(ends.back());
  for (const auto & some : facets)
  {
    for (const FacetType & facet : some)
    {
      for (unsigned int i = 0; i < 3; ++i)
      {
        edges[next[facet.vertices[i]]++] = {
          facet.vertices[(i + 1) % 3], facet.vertices[(i + 2) % 3], facet.region, facet.other
        };
      }
    }
  }

  std::vector<std::vector<IndexType>> found(Threads::CountPieces(numberOfVertices, VerticesPerPiece));
  Threads::RunPieces(
    &threads, numberOfVertices, VerticesPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      std::vector<std::pair<IndexType, IndexType>> curve;
      for (std::size_t vertex = begin; vertex < end; ++vertex)
      {
        if (!IsManifold(edges.data() + ends[vertex], edges.data() + ends[vertex + 1], curve))
        {
          found[piece].push_back(static_cast<IndexType>(vertex));
        }
      }
    });
  std::vector<IndexType> all;
  for (const auto & some : found)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}
} // end namespace itk
