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
#include "itkDelaunayRefinementTriangulation.h"

#include "itkDelaunayRefinementBalls.h"
#include "itkDelaunayRefinementPredicates.h"
#include "itkDelaunayRefinementTriangulationPart.h"
#include "itkDelaunayRefinementTriangulationScratch.h"

#include <algorithm>
#include <cassert>

namespace itk
{
namespace
{
using Predicates = DelaunayRefinementPredicates;
using PointType = DelaunayRefinementPoint;
using IndexType = DelaunayRefinementTriangulation::IndexType;

/** The side of a point that is exactly on a circumsphere, once all points are moved by amounts that fall off quickly in
 * lexicographical order. */
bool
IsInsidePerturbed(const std::array<const PointType *, 4> & tetrahedron, const PointType & point)
{
  std::array<const PointType *, 5> points{ tetrahedron[0], tetrahedron[1], tetrahedron[2], tetrahedron[3], &point };
  std::sort(points.begin(), points.end(), [](const PointType * a, const PointType * b) { return *a < *b; });
  // The two greatest always decide, as the tetrahedron is not flat.
  for (unsigned int i = 4; i > 2; --i)
  {
    if (points[i] == &point)
    {
      return false;
    }
    auto moved = tetrahedron;
    *std::find(moved.begin(), moved.end(), points[i]) = &point;
    const int side = Predicates::Orientation(*moved[0], *moved[1], *moved[2], *moved[3]);
    if (side != 0)
    {
      return side > 0;
    }
  }
  return false;
}
} // namespace

DelaunayRefinementTriangulation::DelaunayRefinementTriangulation()
{
  this->SetNumberOfThreads(1);
  m_Points.push_back({});
  m_CellOfVertex.push_back(None);
}

DelaunayRefinementTriangulation::~DelaunayRefinementTriangulation() = default;

void
DelaunayRefinementTriangulation::SetNumberOfThreads(unsigned int numberOfThreads)
{
  while (m_Scratches.size() < numberOfThreads)
  {
    m_Scratches.push_back(std::make_unique<ScratchType>());
  }
}

bool
DelaunayRefinementTriangulation::FindStar(const PointType & point,
                                          IndexType         hint,
                                          StarType &        star,
                                          unsigned int      thread) const
{
  return this->FindStarIn(WholeType(), point, hint, star, *m_Scratches[thread]);
}

template <typename TDomain>
bool
DelaunayRefinementTriangulation::FindStarIn(const TDomain &   domain,
                                            const PointType & point,
                                            IndexType         hint,
                                            StarType &        star,
                                            ScratchType &     scratch) const
{
  const IndexType start = this->FindConflict(domain, point, hint);
  star.cavity.assign(1, start == None ? hint : start);
  if (start == None || !domain.MayChange(m_Cells[start]))
  {
    return false;
  }
  star.point = point;
  return this->FindCavity(domain, start, star, scratch);
}

bool
DelaunayRefinementTriangulation::MakeStar(const PointType & point, IndexType hint)
{
  if (!this->FindStar(point, hint, m_Star, 0))
  {
    return false;
  }
  this->Take(m_Star);
  this->Fill(m_Star, 0);
  this->Finish(m_Star);
  return true;
}

void
DelaunayRefinementTriangulation::StartBatch()
{
  LengthenDelaunayRefinementArray(m_Batches, m_Cells.size());
  ++m_NumberOfBatches;
}

bool
DelaunayRefinementTriangulation::Reserve(StarType & star)
{
  // As long as no cell beyond one cavity is in another, no new cell of one star is in conflict with the other's vertex:
  // cells in conflict are linked to each other by their facets. Cells beyond both are left alone by both.
  const auto isInBatch = [this](IndexType cell) { return m_Batches[cell] == m_NumberOfBatches; };
  if (std::any_of(star.cavity.begin(), star.cavity.end(), isInBatch))
  {
    return false;
  }
  for (const IndexType cell : star.cavity)
  {
    m_Batches[cell] = m_NumberOfBatches;
  }
  for (const BoundaryType & facet : star.boundary)
  {
    m_Batches[facet.beyond] = m_NumberOfBatches;
  }
  this->Take(star);
  return true;
}

void
DelaunayRefinementTriangulation::Take(StarType & star)
{
  if (star.vertex == None)
  {
    star.vertex = static_cast<IndexType>(m_Points.size());
    m_Points.push_back(star.point);
    m_CellOfVertex.push_back(None);
  }
  this->TakeCells(star, [this] { return this->TakeCell(); }, m_FreeCells);
}

void
DelaunayRefinementTriangulation::Fill(StarType & star, unsigned int thread)
{
  m_Scratches[thread]->vertexPlaces.resize(m_Points.size(), 0);
  for (std::size_t i = 0; i < star.cells.size(); ++i)
  {
    const BoundaryType & facet = star.boundary[i];
    CellType &           cell = m_Cells[star.cells[i]];
    for (const IndexType vertex : facet.vertices)
    {
      DelaunayRefinementMemory::Fetch(&m_Scratches[thread]->vertexPlaces[vertex]);
      DelaunayRefinementMemory::Fetch(&m_Points[vertex]);
    }
    cell.vertices = facet.vertices;
    cell.vertices[facet.slot] = star.vertex;
    cell.neighbors[facet.slot] = facet.beyond;
    m_Cells[facet.beyond].neighbors[facet.mirror] = star.cells[i];
  }
  this->LinkStar(star, *m_Scratches[thread]);
  this->ComputeBallsOfStar(star);
}

void
DelaunayRefinementTriangulation::Finish(const StarType & star)
{
  m_CellOfVertex[star.vertex] = star.cells.front();
  for (const auto & [vertex, cell] : star.cellsOfVertices)
  {
    m_CellOfVertex[vertex] = cell;
  }
}

IndexType
DelaunayRefinementTriangulation::Insert(const PointType & point, IndexType hint)
{
  m_Star.vertex = None;
  if (!this->MakeStar(point, hint))
  {
    return None;
  }
  this->CollectNewCells();
  return m_Star.vertex;
}

bool
DelaunayRefinementTriangulation::Reinsert(IndexType vertex, const PointType & point, IndexType hint)
{
  m_Points[vertex] = point;
  m_Star.vertex = vertex;
  if (!this->MakeStar(point, hint))
  {
    return false;
  }
  this->CollectNewCells();
  return true;
}

void
DelaunayRefinementTriangulation::CollectNewCells()
{
  m_NewCells.assign(m_Star.cells.begin(), m_Star.cells.end());
  for (const IndexType cell : m_NewCells)
  {
    this->MendBall(cell);
  }
}

template <typename TDomain>
IndexType
DelaunayRefinementTriangulation::FindConflict(const TDomain & domain, const PointType & point, IndexType hint) const
{
  if (this->IsInConflict(hint, point))
  {
    return hint;
  }
  const IndexType cell = this->Locate(domain, point, hint);
  if (cell == None)
  {
    return None;
  }
  for (const IndexType vertex : m_Cells[cell].vertices)
  {
    if (vertex != InfiniteVertex && m_Points[vertex] == point)
    {
      return None;
    }
  }
  return cell;
}

template <typename TDomain>
IndexType
DelaunayRefinementTriangulation::Locate(const TDomain & domain, const PointType & point, IndexType start) const
{
  // Towards any facet that the point is beyond: in a Delaunay triangulation this never goes round in circles.
  IndexType cell = start;
  IndexType previous = None;
  while (true)
  {
    const CellType &   current = m_Cells[cell];
    CornersType        corners;
    const unsigned int infinite = this->GetCorners(cell, point, corners);
    if (infinite < 4)
    {
      if (previous != None || Predicates::Orientation(*corners[0], *corners[1], *corners[2], *corners[3]) > 0)
      {
        return cell;
      }
      cell = current.neighbors[infinite];
      continue;
    }
    IndexType next = None;
    bool      isOutOfSight = false;
    for (unsigned int i = 0; i < 4 && next == None; ++i)
    {
      const bool maySee = domain.MaySeeBeyond(current, i);
      if (maySee && current.neighbors[i] == previous)
      {
        continue;
      }
      const PointType * const corner = corners[i];
      corners[i] = &point;
      if (Predicates::Orientation(*corners[0], *corners[1], *corners[2], *corners[3]) < 0)
      {
        next = maySee ? current.neighbors[i] : None;
        isOutOfSight = !maySee || isOutOfSight;
      }
      corners[i] = corner;
    }
    if (next == None)
    {
      return isOutOfSight ? None : cell;
    }
    previous = cell;
    cell = next;
  }
}

unsigned int
DelaunayRefinementTriangulation::GetCorners(IndexType cell, const PointType & point, CornersType & corners) const
{
  unsigned int infinite = 4;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const IndexType vertex = m_Cells[cell].vertices[i];
    corners[i] = vertex == InfiniteVertex ? &point : &m_Points[vertex];
    infinite = vertex == InfiniteVertex ? i : infinite;
  }
  return infinite;
}

bool
DelaunayRefinementTriangulation::IsInConflictExactly(IndexType cell, const PointType & point) const
{
  CornersType        corners;
  const unsigned int infinite = this->GetCorners(cell, point, corners);
  if (infinite < 4)
  {
    const int side = Predicates::Orientation(*corners[0], *corners[1], *corners[2], *corners[3]);
    // In the plane of the facet, the circumsphere of the cell behind it decides.
    return side != 0 ? side > 0 : this->IsInConflict(m_Cells[cell].neighbors[infinite], point);
  }
  const int side = Predicates::ExactSideOfSphere(*corners[0], *corners[1], *corners[2], *corners[3], point);
  return side != 0 ? side > 0 : IsInsidePerturbed(corners, point);
}

template <typename TDomain>
bool
DelaunayRefinementTriangulation::FindCavity(const TDomain & domain,
                                            IndexType       start,
                                            StarType &      star,
                                            ScratchType &   scratch) const
{
  // Processors can't tell which cells are in conflict: what is found is written down either way, and kept by counting.
  using MarkEnum = ScratchType::MarkEnum;
  scratch.cellMarks.resize(m_Cells.size(), MarkEnum::NONE);
  MarkEnum * const       marks = scratch.cellMarks.data();
  const CellType * const cells = m_Cells.data();
  const PointType        point = star.point;
  std::size_t            numberIn = 1;
  std::size_t            numberSeen = 1;
  bool                   mayChangeAll = true;
  star.cavity.resize(ScratchType::LeastRoom);
  scratch.seen.resize(ScratchType::LeastRoom);
  scratch.seen[0] = start;
  marks[start] = MarkEnum::IN;
  for (std::size_t i = 0; i < numberIn && mayChangeAll; ++i)
  {
    if (star.cavity.size() < numberIn + 4)
    {
      star.cavity.resize(2 * star.cavity.size());
    }
    if (scratch.seen.size() < numberSeen + 4)
    {
      scratch.seen.resize(2 * scratch.seen.size());
    }
    for (const IndexType neighbor : cells[star.cavity[i]].neighbors)
    {
      if (marks[neighbor] != MarkEnum::NONE)
      {
        continue;
      }
      const bool isIn = this->IsInConflict(neighbor, point);
      mayChangeAll = mayChangeAll && (!isIn || domain.MayChange(cells[neighbor]));
      marks[neighbor] = isIn ? MarkEnum::IN : MarkEnum::OUT;
      scratch.seen[numberSeen++] = neighbor;
      star.cavity[numberIn] = neighbor;
      numberIn += isIn ? 1 : 0;
      // Not of cells that may not be changed: others may be writing there.
      for (const IndexType next : cells[isIn && mayChangeAll ? neighbor : start].neighbors)
      {
        DelaunayRefinementMemory::Fetch(&cells[next]);
      }
    }
  }
  star.cavity.resize(numberIn);
  if (mayChangeAll)
  {
    this->FindBoundary(star, scratch);
  }
  scratch.seen.resize(numberSeen);
  scratch.ClearMarks(scratch.seen);
  return mayChangeAll;
}

void
DelaunayRefinementTriangulation::FindBoundary(StarType & star, ScratchType & scratch) const
{
  const auto * const marks = scratch.cellMarks.data();
  scratch.facets.resize(4 * star.cavity.size());
  std::size_t number = 0;
  for (const IndexType cell : star.cavity)
  {
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      scratch.facets[number] = { cell, slot };
      number += marks[m_Cells[cell].neighbors[slot]] == ScratchType::MarkEnum::OUT ? 1 : 0;
    }
  }
  star.boundary.resize(number);
  for (std::size_t i = 0; i < number; ++i)
  {
    const auto & [cell, slot] = scratch.facets[i];
    star.boundary[i] = this->MakeBoundary(cell, slot);
  }
}

void
DelaunayRefinementTriangulation::LinkStar(StarType & star, ScratchType & scratch)
{
  // Euler: a sphere of n triangles has n / 2 + 2 vertices.
  const std::size_t numberOfVertices = star.cells.size() / 2 + 2;
  const bool        isLarge = numberOfVertices > ScratchType::MostVerticesOfMatrix;
  scratch.facetPlaces.resize(star.cells.size());
  scratch.matrix.resize(std::max(scratch.matrix.size(), isLarge ? 0 : numberOfVertices * numberOfVertices));
  star.cellsOfVertices.resize(numberOfVertices);
  const std::uint64_t number = ++scratch.numberOfStars;
  std::uint32_t       numberOfPlaces = 0;
  for (std::size_t i = 0; i < star.cells.size(); ++i)
  {
    const IndexType index = star.cells[i];
    const auto &    slots = FacetVertices[star.boundary[i].slot];
    const auto &    vertices = star.boundary[i].vertices;
    auto &          places = scratch.facetPlaces[i];
    for (unsigned int j = 0; j < 3; ++j)
    {
      const IndexType vertex = vertices[slots[j]];
      std::uint64_t & place = scratch.vertexPlaces[vertex];
      if (place >> 32 != number)
      {
        star.cellsOfVertices[numberOfPlaces] = { vertex, index };
        place = number << 32 | numberOfPlaces++;
      }
      places[j] = static_cast<std::uint32_t>(place);
    }
    if (!isLarge)
    {
      // The cavity's boundary is oriented: each of its edges is passed once in either direction.
      scratch.matrix[places[0] * numberOfVertices + places[1]] = index;
      scratch.matrix[places[1] * numberOfVertices + places[2]] = index;
      scratch.matrix[places[2] * numberOfVertices + places[0]] = index;
    }
  }
  if (isLarge)
  {
    this->LinkLargeStar(star, scratch);
    return;
  }
  for (std::size_t i = 0; i < star.cells.size(); ++i)
  {
    const auto & slots = FacetVertices[star.boundary[i].slot];
    const auto & places = scratch.facetPlaces[i];
    auto &       neighbors = m_Cells[star.cells[i]].neighbors;
    neighbors[slots[2]] = scratch.matrix[places[1] * numberOfVertices + places[0]];
    neighbors[slots[0]] = scratch.matrix[places[2] * numberOfVertices + places[1]];
    neighbors[slots[1]] = scratch.matrix[places[0] * numberOfVertices + places[2]];
  }
}

void
DelaunayRefinementTriangulation::LinkLargeStar(const StarType & star, ScratchType & scratch)
{
  auto & sharedEdges = scratch.sharedEdges;
  sharedEdges.clear();
  for (std::size_t i = 0; i < star.cells.size(); ++i)
  {
    const auto & slots = FacetVertices[star.boundary[i].slot];
    const auto & vertices = star.boundary[i].vertices;
    for (unsigned int j = 0; j < 3; ++j)
    {
      const auto ends = std::minmax(vertices[slots[j]], vertices[slots[(j + 1) % 3]]);
      sharedEdges.push_back({ static_cast<std::uint64_t>(ends.first) << 32 | ends.second,
                              star.cells[i],
                              static_cast<std::uint8_t>(slots[(j + 2) % 3]) });
    }
  }
  using SharedEdgeType = ScratchType::SharedEdgeType;
  std::sort(sharedEdges.begin(), sharedEdges.end(), [](const SharedEdgeType & a, const SharedEdgeType & b) {
    return a.vertices < b.vertices;
  });
  for (std::size_t i = 0; i + 1 < sharedEdges.size(); i += 2)
  {
    const SharedEdgeType & one = sharedEdges[i];
    const SharedEdgeType & other = sharedEdges[i + 1];
    m_Cells[one.cell].neighbors[one.slot] = other.cell;
    m_Cells[other.cell].neighbors[other.slot] = one.cell;
  }
}

IndexType
DelaunayRefinementTriangulation::TakeCell()
{
  IndexType index;
  if (m_FreeCells.empty())
  {
    index = static_cast<IndexType>(m_Cells.size());
    m_Cells.emplace_back();
    m_Generations.push_back(0);
  }
  else
  {
    index = m_FreeCells.back();
    m_FreeCells.pop_back();
  }
  ++m_Generations[index];
  return index;
}

void
DelaunayRefinementTriangulation::ReleaseCell(IndexType cell)
{
  ++m_Generations[cell];
  m_FreeCells.push_back(cell);
}

void
DelaunayRefinementTriangulation::UpdateCellOfVertices(IndexType cell)
{
  for (const IndexType vertex : m_Cells[cell].vertices)
  {
    m_CellOfVertex[vertex] = cell;
  }
}

void
DelaunayRefinementTriangulation::ComputeBallsOfStar(const StarType & star)
{
  const PointType &       origin = star.point;
  DelaunayRefinementBalls balls;
  for (std::size_t first = 0; first < star.cells.size(); first += DelaunayRefinementBalls::Size)
  {
    const std::size_t size = std::min(DelaunayRefinementBalls::Size, star.cells.size() - first);
    for (std::size_t i = 0; i < size; ++i)
    {
      const BoundaryType & facet = star.boundary[first + i];
      const auto &         slots = FacetVertices[facet.slot];
      if (this->IsInfinite(star.cells[first + i]))
      {
        balls.SetAny(i);
        continue;
      }
      balls.SetPoints(i,
                      origin,
                      m_Points[facet.vertices[slots[0]]],
                      m_Points[facet.vertices[slots[1]]],
                      m_Points[facet.vertices[slots[2]]]);
    }
    balls.Compute(origin);
    for (std::size_t i = 0; i < size; ++i)
    {
      CellType & cell = m_Cells[star.cells[first + i]];
      cell.center = balls.GetCenter(i, origin);
      cell.signedSquaredRadius = balls.GetSignedSquaredRadius(i);
      if (this->IsInfinite(star.cells[first + i]))
      {
        cell.center = {};
        cell.signedSquaredRadius = 0.0;
      }
    }
  }
}

void
DelaunayRefinementTriangulation::ComputeBall(IndexType index)
{
  CellType & cell = m_Cells[index];
  cell.center = {};
  cell.signedSquaredRadius = 0.0;
  if (!this->IsInfinite(index))
  {
    const PointType &       origin = m_Points[cell.vertices[0]];
    DelaunayRefinementBalls balls;
    balls.SetPoints(0, origin, m_Points[cell.vertices[1]], m_Points[cell.vertices[2]], m_Points[cell.vertices[3]]);
    balls.Compute(origin);
    cell.center = balls.GetCenter(0, origin);
    cell.signedSquaredRadius = balls.GetSignedSquaredRadius(0);
  }
}

void
DelaunayRefinementTriangulation::MendBall(IndexType index)
{
  CellType & cell = m_Cells[index];
  if (cell.signedSquaredRadius > 0.0 || this->IsInfinite(index))
  {
    return;
  }
  const auto &     v = cell.vertices;
  const SphereType ball =
    DelaunayRefinementGeometry::ComputeCircumsphere(m_Points[v[0]], m_Points[v[1]], m_Points[v[2]], m_Points[v[3]]);
  cell.center = ball.center;
  cell.signedSquaredRadius = -ball.squaredRadius;
}

template bool
DelaunayRefinementTriangulation::FindStarIn(const PartType &, const PointType &, IndexType, StarType &, ScratchType &)
  const;

bool
DelaunayRefinementTriangulation::IsValid() const
{
  for (IndexType index = 0; index < this->GetNumberOfCellIndexes(); ++index)
  {
    if (!this->IsAlive(index))
    {
      continue;
    }
    const CellType & cell = m_Cells[index];
    const auto       corner = [&](unsigned int i) -> const PointType & { return m_Points[cell.vertices[i]]; };
    const bool       isInfinite = this->IsInfinite(index);
    if (!isInfinite && Predicates::Orientation(corner(0), corner(1), corner(2), corner(3)) <= 0)
    {
      return false;
    }
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      const IndexType neighbor = cell.neighbors[slot];
      if (!this->IsAlive(neighbor))
      {
        return false;
      }
      const auto & back = m_Cells[neighbor].neighbors;
      const auto   mirror = std::find(back.begin(), back.end(), index) - back.begin();
      if (mirror == 4)
      {
        return false;
      }
      // The same facet from the other side.
      auto one = this->GetOrientedFacet(index, slot).vertices;
      std::swap(one[1], one[2]);
      if (one != this->GetOrientedFacet(neighbor, static_cast<unsigned int>(mirror)).vertices)
      {
        return false;
      }
      const IndexType opposite = m_Cells[neighbor].vertices[mirror];
      if (opposite != InfiniteVertex && this->IsInConflictExactly(index, m_Points[opposite]))
      {
        return false;
      }
    }
  }
  return true;
}
} // end namespace itk
