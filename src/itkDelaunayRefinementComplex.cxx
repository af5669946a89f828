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
#include "itkDelaunayRefinementComplex.h"

#include <algorithm>
#include <cmath>

namespace itk
{
DelaunayRefinementComplex::DelaunayRefinementComplex(const DelaunayRefinementOracle & oracle,
                                                     bool                             roundToFloat,
                                                     const BoundsType &               box)
  : m_Oracle(oracle)
  , m_RoundToFloat(roundToFloat)
  , m_Box(box)
  , m_Blocks(oracle.GetSurfaceBounds())
{}

bool
DelaunayRefinementComplex::Start(const std::vector<PointType> & features,
                                 const std::vector<double> &    deltas,
                                 const std::vector<PointType> & frees,
                                 DelaunayRefinementThreads &    threads,
                                 const std::function<bool()> &  keepGoing)
{
  std::vector<PointType> points;
  points.reserve(features.size() + frees.size() + 8);
  this->AddVertex(VertexKind::BOX_EDGE, 0.0); // the infinite vertex
  m_NumbersOfVertices = {};
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    PointType point;
    for (unsigned int i = 0; i < 3; ++i)
    {
      point[i] = (corner >> i & 1u) ? m_Box.maximum[i] : m_Box.minimum[i];
    }
    points.push_back(point);
    this->AddVertex(VertexKind::BOX_EDGE, 0.0);
  }
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    points.push_back(features[i]);
    this->AddVertex(VertexKind::FEATURE, deltas[i]);
  }
  for (const PointType & point : frees)
  {
    points.push_back(point);
    this->AddVertex(VertexKind::FREE, 0.0);
  }
  if (!m_Triangulation.InsertMany(points, keepGoing, &threads) || !keepGoing())
  {
    return false;
  }
  const auto & cells = m_Triangulation.GetNewCells();
  LengthenDelaunayRefinementArray(m_Regions, m_Triangulation.GetNumberOfCellIndexes());
  constexpr std::size_t cellsPerPiece = 4096;
  DelaunayRefinementThreads::RunPieces(
    &threads, cells.size(), cellsPerPiece, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::for_each(cells.data() + begin, cells.data() + end, [this](IndexType cell) { this->UpdateRegion(cell); });
    });
  return keepGoing();
}

bool
DelaunayRefinementComplex::Reserve(StarType & star, VertexKind kind, double delta)
{
  star.vertex = None;
  if (!m_Triangulation.Reserve(star))
  {
    return false;
  }
  this->AddVertex(kind, delta);
  LengthenDelaunayRefinementArray(m_Regions, m_Triangulation.GetNumberOfCellIndexes());
  return true;
}

void
DelaunayRefinementComplex::Fill(StarType & star, unsigned int thread)
{
  for (const auto & facet : star.boundary)
  {
    this->FetchRegion(facet.beyond);
  }
  m_Triangulation.Fill(star, thread);
  for (const IndexType cell : star.cells)
  {
    m_Triangulation.MendBall(cell);
    this->UpdateRegion(cell);
  }
}

bool
DelaunayRefinementComplex::IsStrictlyInsideBox(const PointType & point) const
{
  return point[0] > m_Box.minimum[0] && point[1] > m_Box.minimum[1] && point[2] > m_Box.minimum[2] &&
         point[0] < m_Box.maximum[0] && point[1] < m_Box.maximum[1] && point[2] < m_Box.maximum[2];
}

DelaunayRefinementComplex::IndexType
DelaunayRefinementComplex::Insert(const PointType & point, VertexKind kind, double delta, IndexType hint)
{
  const IndexType vertex = m_Triangulation.Insert(point, hint);
  if (vertex != None)
  {
    this->AddVertex(kind, delta);
    this->UpdateRegions(m_Triangulation.GetNewCells());
  }
  return vertex;
}

bool
DelaunayRefinementComplex::Reinsert(IndexType vertex, const PointType & point, double delta, IndexType hint)
{
  if (!m_Triangulation.Reinsert(vertex, point, hint))
  {
    return false;
  }
  m_Deltas[vertex] = delta;
  if (vertex < m_NumberOfPlaced && m_Kinds[vertex] == VertexKind::FREE && !m_PlacesOfFree.HasPointWithin(point, 0.0))
  {
    m_PlacesOfFree.Add(point);
  }
  ++m_NumbersOfVertices[static_cast<std::size_t>(m_Kinds[vertex])];
  this->UpdateRegions(m_Triangulation.GetNewCells());
  return true;
}

void
DelaunayRefinementComplex::Remove(IndexType vertex)
{
  m_Triangulation.Remove(vertex);
  --m_NumbersOfVertices[static_cast<std::size_t>(m_Kinds[vertex])];
  this->UpdateRegions(m_Triangulation.GetNewCells());
}

void
DelaunayRefinementComplex::FindVerticesWithin(IndexType vertex, double radius, std::vector<IndexType> & found)
{
  // From any vertex of a Delaunay triangulation some edge leads nearer to a given other one, so that links between
  // vertices of the ball reach all of them.
  found.clear();
  LengthenDelaunayRefinementArray(m_VertexMarks, m_Triangulation.GetNumberOfVertexIndexes());
  LengthenDelaunayRefinementArray(m_CellMarks, m_Triangulation.GetNumberOfCellIndexes());
  ++m_NumberOfSearches;
  const PointType center = this->GetPoint(vertex);
  const double    squaredRadius = radius * radius;

  std::vector<IndexType> hubs{ vertex };
  std::vector<IndexType> cells;
  m_VertexMarks[vertex] = m_NumberOfSearches;
  for (std::size_t next = 0; next < hubs.size(); ++next)
  {
    const IndexType hub = hubs[next];
    ++m_NumberOfStars;
    cells.assign(1, m_Triangulation.GetCellOfVertex(hub));
    m_CellMarks[cells.front()] = m_NumberOfStars;
    while (!cells.empty())
    {
      const auto & cell = m_Triangulation.GetCell(cells.back());
      cells.pop_back();
      for (unsigned int i = 0; i < 4; ++i)
      {
        const IndexType other = cell.vertices[i];
        if (other == hub)
        {
          continue;
        }
        if (other != DelaunayRefinementTriangulation::InfiniteVertex && m_VertexMarks[other] != m_NumberOfSearches)
        {
          m_VertexMarks[other] = m_NumberOfSearches;
          if (DelaunayRefinementGeometry::SquaredDistance(center, this->GetPoint(other)) < squaredRadius)
          {
            hubs.push_back(other);
            found.push_back(other);
          }
        }
        const IndexType neighbor = cell.neighbors[i];
        if (m_CellMarks[neighbor] != m_NumberOfStars)
        {
          m_CellMarks[neighbor] = m_NumberOfStars;
          cells.push_back(neighbor);
        }
      }
    }
  }
}

void
DelaunayRefinementComplex::FindFreeVerticesWithin(IndexType vertex, double radius, std::vector<IndexType> & found)
{
  found.clear();
  if (this->GetNumberOfVertices(VertexKind::FREE) == 0)
  {
    return;
  }
  // Cubes for so many, and for as many more as make them too full.
  if (m_PlacesOfFree.GetPoints().size() >= m_MostPlaces)
  {
    constexpr double      cubesPerVertex = 16.0;
    constexpr std::size_t growth = 8;
    const PointType       extent = DelaunayRefinementGeometry::Subtract(m_Box.maximum, m_Box.minimum);
    const auto            number = static_cast<double>(this->GetNumberOfVertices(VertexKind::FREE));
    const double          volume = extent[0] * extent[1] * extent[2] / (cubesPerVertex * number);
    m_PlacesOfFree.Start(m_Box.minimum, m_Box.maximum, std::max(radius, std::cbrt(volume)));
    m_MostPlaces = growth * this->GetNumberOfVertices(VertexKind::FREE);
    m_NumberOfPlaced = 0;
  }
  for (; m_NumberOfPlaced < m_Kinds.size(); ++m_NumberOfPlaced)
  {
    if (m_Kinds[m_NumberOfPlaced] == VertexKind::FREE && m_Triangulation.GetCellOfVertex(m_NumberOfPlaced) != None)
    {
      m_PlacesOfFree.Add(this->GetPoint(m_NumberOfPlaced));
    }
  }
  if (m_PlacesOfFree.HasPointWithin(this->GetPoint(vertex), radius))
  {
    this->FindVerticesWithin(vertex, radius, found);
    const auto isOther = [this](IndexType other) { return m_Kinds[other] != VertexKind::FREE; };
    found.erase(std::remove_if(found.begin(), found.end(), isOther), found.end());
  }
}

void
DelaunayRefinementComplex::AddVertex(VertexKind kind, double delta)
{
  m_Kinds.push_back(kind);
  m_Deltas.push_back(delta);
  ++m_NumbersOfVertices[static_cast<std::size_t>(kind)];
}

void
DelaunayRefinementComplex::UpdateRegions(const DelaunayRefinementArray<IndexType> & cells)
{
  LengthenDelaunayRefinementArray(m_Regions, m_Triangulation.GetNumberOfCellIndexes());
  for (const IndexType cell : cells)
  {
    this->UpdateRegion(cell);
  }
}
} // end namespace itk
