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
#include "itkDelaunayRefinementPredicates.h"
#include "itkDelaunayRefinementTriangulationScratch.h"

#include <algorithm>
#include <cassert>

namespace itk
{
namespace
{
using IndexType = DelaunayRefinementTriangulation::IndexType;
using Predicates = DelaunayRefinementPredicates;

/** The vertices of a facet in the same sense, the smallest first. */
std::array<IndexType, 3>
RotateSmallestFirst(std::array<IndexType, 3> facet)
{
  std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  return facet;
}
} // namespace

void
DelaunayRefinementTriangulation::FindCellsOfVertex(IndexType vertex, StarType & star)
{
  using MarkEnum = ScratchType::MarkEnum;
  auto & marks = m_Scratches.front()->cellMarks;
  marks.resize(m_Cells.size(), MarkEnum::NONE);
  star.boundary.clear();
  star.cavity.assign(1, m_CellOfVertex[vertex]);
  marks[star.cavity.front()] = MarkEnum::IN;
  for (std::size_t i = 0; i < star.cavity.size(); ++i)
  {
    const IndexType cell = star.cavity[i];
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      const IndexType neighbor = m_Cells[cell].neighbors[slot];
      if (m_Cells[cell].vertices[slot] == vertex)
      {
        star.boundary.push_back(this->MakeBoundary(cell, slot));
      }
      else if (marks[neighbor] != MarkEnum::IN)
      {
        marks[neighbor] = MarkEnum::IN;
        star.cavity.push_back(neighbor);
      }
    }
  }
  m_Scratches.front()->ClearMarks(star.cavity);
}

DelaunayRefinementTriangulation::OrientedFacetType
DelaunayRefinementTriangulation::GetOrientedFacet(IndexType cell, unsigned int slot) const
{
  const auto & v = m_Cells[cell].vertices;
  const auto & slots = FacetVertices[slot];
  return { RotateSmallestFirst({ v[slots[0]], v[slots[1]], v[slots[2]] }), cell, static_cast<std::uint8_t>(slot) };
}

void
DelaunayRefinementTriangulation::Remove(IndexType vertex)
{
  this->FindCellsOfVertex(vertex, m_Star);
  auto & around = m_Scratches.front()->around;
  around.clear();
  for (const BoundaryType & facet : m_Star.boundary)
  {
    for (const unsigned int slot : FacetVertices[facet.slot])
    {
      around.push_back(facet.vertices[slot]);
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());

  for (const IndexType cell : m_Star.cavity)
  {
    this->ReleaseCell(cell);
  }
  m_CellOfVertex[vertex] = None;
  m_NewCells.clear();
  if (around.front() == InfiniteVertex)
  {
    this->FillHoleAtHull(around);
  }
  else
  {
    this->FillHole(around);
  }
}

void
DelaunayRefinementTriangulation::FillHole(const std::vector<IndexType> & around)
{
  // Gift wrapping: beyond a facet is the cell with a vertex around whose ball holds no other one on that side.
  auto & open = m_Scratches.front()->openFacets;
  open.clear();
  for (const BoundaryType & facet : m_Star.boundary)
  {
    const auto & slots = FacetVertices[facet.slot];
    open.push_back(
      { { facet.vertices[slots[0]], facet.vertices[slots[1]], facet.vertices[slots[2]] }, facet.beyond, facet.mirror });
  }
  while (!open.empty())
  {
    const OrientedFacetType facet = open.back();
    open.pop_back();
    const IndexType index = this->TakeCell();
    CellType &      cell = m_Cells[index];
    cell.vertices = { facet.vertices[0], facet.vertices[1], facet.vertices[2], None };
    const PointType & a = m_Points[cell.vertices[0]];
    const PointType & b = m_Points[cell.vertices[1]];
    const PointType & c = m_Points[cell.vertices[2]];
    for (const IndexType apex : around)
    {
      if (Predicates::Orientation(a, b, c, m_Points[apex]) > 0 &&
          (cell.vertices[3] == None || this->IsInConflict(index, m_Points[apex])))
      {
        cell.vertices[3] = apex;
        this->ComputeBall(index);
      }
    }
    assert(cell.vertices[3] != None);
    this->MendBall(index);
    this->UpdateCellOfVertices(index);
    m_NewCells.push_back(index);
    cell.neighbors[3] = facet.cell;
    m_Cells[facet.cell].neighbors[facet.slot] = index;
    for (std::uint8_t slot = 0; slot < 3; ++slot)
    {
      // As the cell beyond sees it.
      const auto &             slots = FacetVertices[slot];
      std::array<IndexType, 3> vertices{ cell.vertices[slots[0]], cell.vertices[slots[2]], cell.vertices[slots[1]] };
      const auto               other = std::find_if(open.begin(), open.end(), [&](const OrientedFacetType & candidate) {
        return std::is_permutation(vertices.begin(), vertices.end(), candidate.vertices.begin());
      });
      if (other == open.end())
      {
        open.push_back({ vertices, index, slot });
        continue;
      }
      cell.neighbors[slot] = other->cell;
      m_Cells[other->cell].neighbors[other->slot] = index;
      *other = open.back();
      open.pop_back();
    }
  }
}

void
DelaunayRefinementTriangulation::FillHoleAtHull(const std::vector<IndexType> & around)
{
  // The cells are among those of the triangulation of the vertices around.
  std::vector<PointType> points;
  for (std::size_t i = 1; i < around.size(); ++i)
  {
    points.push_back(m_Points[around[i]]);
  }
  DelaunayRefinementTriangulation filler;
  filler.InsertMany(points, [] { return true; });
  const auto toLocal = [&around](IndexType global) {
    return static_cast<IndexType>(std::lower_bound(around.begin(), around.end(), global) - around.begin());
  };

  std::vector<OrientedFacetType> facets;
  for (const IndexType cell : filler.m_NewCells)
  {
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      facets.push_back(filler.GetOrientedFacet(cell, slot));
    }
  }
  std::sort(facets.begin(), facets.end());

  constexpr IndexType                   unknown = None;
  std::vector<IndexType>                globals(filler.m_Cells.size(), unknown);
  std::vector<std::array<IndexType, 4>> beyond(filler.m_Cells.size(), { unknown, unknown, unknown, unknown });
  std::vector<IndexType>                filling;
  for (std::size_t i = 0; i < m_Star.boundary.size(); ++i)
  {
    const auto &            v = m_Star.boundary[i].vertices;
    const auto &            slots = FacetVertices[m_Star.boundary[i].slot];
    const OrientedFacetType wanted{
      RotateSmallestFirst({ toLocal(v[slots[0]]), toLocal(v[slots[1]]), toLocal(v[slots[2]]) }), unknown, 0
    };
    const auto found = std::lower_bound(facets.begin(), facets.end(), wanted);
    assert(found != facets.end() && found->vertices == wanted.vertices);
    beyond[found->cell][found->slot] = static_cast<IndexType>(i);
    if (globals[found->cell] == unknown)
    {
      globals[found->cell] = 0;
      filling.push_back(found->cell);
    }
  }
  for (std::size_t i = 0; i < filling.size(); ++i)
  {
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      const IndexType neighbor = filler.m_Cells[filling[i]].neighbors[slot];
      if (beyond[filling[i]][slot] == unknown && globals[neighbor] == unknown)
      {
        globals[neighbor] = 0;
        filling.push_back(neighbor);
      }
    }
  }

  for (const IndexType local : filling)
  {
    globals[local] = this->TakeCell();
    m_NewCells.push_back(globals[local]);
  }
  for (const IndexType local : filling)
  {
    CellType & cell = m_Cells[globals[local]];
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      cell.vertices[slot] = around[filler.m_Cells[local].vertices[slot]];
      if (beyond[local][slot] == unknown)
      {
        cell.neighbors[slot] = globals[filler.m_Cells[local].neighbors[slot]];
      }
      else
      {
        const BoundaryType & facet = m_Star.boundary[beyond[local][slot]];
        cell.neighbors[slot] = facet.beyond;
        m_Cells[facet.beyond].neighbors[facet.mirror] = globals[local];
      }
    }
    this->UpdateCellOfVertices(globals[local]);
    this->ComputeBall(globals[local]);
    this->MendBall(globals[local]);
  }
}
} // end namespace itk
