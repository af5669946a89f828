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

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>

namespace itk
{
namespace
{
using GeometryKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
  CGAL::Triangulation_vertex_base_with_info_3<DelaunayRefinementTriangulation::IndexType, GeometryKernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<DelaunayRefinementTriangulation::IndexType,
                                                           GeometryKernel,
                                                           CGAL::Delaunay_triangulation_cell_base_3<GeometryKernel>>;
using DelaunayType =
  CGAL::Delaunay_triangulation_3<GeometryKernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using CellHandle = DelaunayType::Cell_handle;
using VertexHandle = DelaunayType::Vertex_handle;

constexpr std::size_t InsertionsBetweenQuestions = 4096;

GeometryKernel::Point_3
ToKernel(const DelaunayRefinementPoint & point)
{
  return { point[0], point[1], point[2] };
}

bool
Precedes(const CellHandle & a, const CellHandle & b)
{
  for (int i = 0; i < 4; ++i)
  {
    if (a->vertex(i)->info() != b->vertex(i)->info())
    {
      return a->vertex(i)->info() < b->vertex(i)->info();
    }
  }
  return false;
}

/** Puts the smallest vertex first and keeps the orientation, so that no order depends on addresses. */
void
RotateSmallestVertexFirst(const CellHandle & cell)
{
  int smallest = 0;
  for (int i = 1; i < 4; ++i)
  {
    if (cell->vertex(i)->info() < cell->vertex(smallest)->info())
    {
      smallest = i;
    }
  }
  std::array<int, 4> order{ 0, 1, 2, 3 };
  if (smallest > 0)
  {
    // Two swaps keep the orientation.
    std::swap(order[0], order[smallest]);
    const int a = smallest == 1 ? 2 : 1;
    const int b = smallest == 3 ? 2 : 3;
    std::swap(order[a], order[b]);
  }
  // A cyclic shift of the last three keeps it too.
  const auto info = [&](int i) { return cell->vertex(order[i])->info(); };
  while (info(1) > info(2) || info(1) > info(3))
  {
    std::rotate(order.begin() + 1, order.begin() + 2, order.end());
  }
  std::array<VertexHandle, 4> vertices;
  std::array<CellHandle, 4>   neighbors;
  for (int i = 0; i < 4; ++i)
  {
    vertices[i] = cell->vertex(order[i]);
    neighbors[i] = cell->neighbor(order[i]);
  }
  cell->set_vertices(vertices[0], vertices[1], vertices[2], vertices[3]);
  cell->set_neighbors(neighbors[0], neighbors[1], neighbors[2], neighbors[3]);
}
} // namespace

/** CGAL's triangulation, and the handles of the cells and vertices by index. */
class DelaunayRefinementTriangulation::Kernel
{
public:
  explicit Kernel(DelaunayRefinementTriangulation & owner)
    : m_Owner(owner)
  {
    m_Triangulation.infinite_vertex()->info() = InfiniteVertex;
    m_Vertices.push_back(m_Triangulation.infinite_vertex());
  }

  DelaunayType &
  GetTriangulation()
  {
    return m_Triangulation;
  }

  CellHandle
  GetCell(IndexType cell) const
  {
    return m_Cells[cell];
  }

  VertexHandle
  GetVertex(IndexType vertex) const
  {
    return m_Vertices[vertex];
  }

  void
  AddVertex(VertexHandle vertex, const PointType & point)
  {
    vertex->info() = static_cast<IndexType>(m_Vertices.size());
    m_Vertices.push_back(vertex);
    m_Owner.m_Points.push_back(point);
    m_Owner.m_CellOfVertex.push_back(None);
  }

  void
  RemoveVertex(IndexType vertex)
  {
    m_Vertices[vertex] = VertexHandle();
    m_Owner.m_CellOfVertex[vertex] = None;
  }

  /** Gives indexes to new cells and copies them, and what their neighbors say of them, to the owner's arrays. */
  void
  Register(const std::vector<CellHandle> & cells)
  {
    m_Owner.m_NewCells.clear();
    for (const CellHandle & cell : cells)
    {
      cell->info() = TakeIndex();
      m_Cells[cell->info()] = cell;
      m_Owner.m_NewCells.push_back(cell->info());
    }
    for (const CellHandle & cell : cells)
    {
      CellType & copy = m_Owner.m_Cells[cell->info()];
      for (int i = 0; i < 4; ++i)
      {
        const CellHandle neighbor = cell->neighbor(i);
        copy.vertices[i] = cell->vertex(i)->info();
        copy.neighbors[i] = neighbor->info();
        m_Owner.m_Cells[neighbor->info()].neighbors[neighbor->index(cell)] = cell->info();
        m_Owner.m_CellOfVertex[copy.vertices[i]] = cell->info();
      }
    }
  }

private:
  IndexType
  TakeIndex()
  {
    IndexType index;
    if (m_Owner.m_FreeCells.empty())
    {
      index = static_cast<IndexType>(m_Owner.m_Cells.size());
      m_Owner.m_Cells.emplace_back();
      m_Owner.m_Generations.push_back(0);
      m_Cells.emplace_back();
    }
    else
    {
      index = m_Owner.m_FreeCells.back();
      m_Owner.m_FreeCells.pop_back();
    }
    ++m_Owner.m_Generations[index];
    return index;
  }

  DelaunayRefinementTriangulation & m_Owner;
  DelaunayType                      m_Triangulation{};
  std::vector<CellHandle>           m_Cells{};
  std::vector<VertexHandle>         m_Vertices{};
};

DelaunayRefinementTriangulation::DelaunayRefinementTriangulation()
  : m_Kernel(std::make_unique<Kernel>(*this))
{
  m_Points.push_back({});
  m_CellOfVertex.push_back(None);
}

DelaunayRefinementTriangulation::~DelaunayRefinementTriangulation() = default;

bool
DelaunayRefinementTriangulation::InsertMany(const std::vector<PointType> & points,
                                            const std::function<bool()> &  keepGoing)
{
  std::vector<GeometryKernel::Point_3> kernelPoints;
  kernelPoints.reserve(points.size());
  for (const PointType & point : points)
  {
    kernelPoints.push_back(ToKernel(point));
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  using PointMap = CGAL::Pointer_property_map<GeometryKernel::Point_3>::type;
  CGAL::spatial_sort(
    order.begin(),
    order.end(),
    CGAL::Spatial_sort_traits_adapter_3<GeometryKernel, PointMap>(CGAL::make_property_map(kernelPoints)));

  DelaunayType &            triangulation = m_Kernel->GetTriangulation();
  std::vector<VertexHandle> handles(points.size());
  VertexHandle              last;
  std::size_t               number = 0;
  for (const std::size_t i : order)
  {
    if (++number % InsertionsBetweenQuestions == 0 && !keepGoing())
    {
      return false;
    }
    last = last == VertexHandle() ? triangulation.insert(kernelPoints[i]) : triangulation.insert(kernelPoints[i], last);
    handles[i] = last;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    m_Kernel->AddVertex(handles[i], points[i]);
  }
  std::vector<CellHandle> cells;
  cells.reserve(triangulation.number_of_cells());
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
  {
    cells.push_back(cell);
  }
  m_Kernel->Register(cells);
  return true;
}

DelaunayRefinementTriangulation::IndexType
DelaunayRefinementTriangulation::Insert(const PointType & point, IndexType hint)
{
  DelaunayType &                triangulation = m_Kernel->GetTriangulation();
  const GeometryKernel::Point_3 kernelPoint = ToKernel(point);
  CellHandle                    start = m_Kernel->GetCell(hint);
  if (triangulation.side_of_sphere(start, kernelPoint) != CGAL::ON_BOUNDED_SIDE)
  {
    DelaunayType::Locate_type type;
    int                       i;
    int                       j;
    start = triangulation.locate(kernelPoint, type, i, j, start);
    if (type == DelaunayType::VERTEX)
    {
      return None;
    }
  }
  std::vector<CellHandle>          conflicts;
  std::vector<DelaunayType::Facet> boundary;
  conflicts.reserve(32);
  boundary.reserve(64);
  triangulation.find_conflicts(kernelPoint, start, std::back_inserter(boundary), std::back_inserter(conflicts));
  for (const CellHandle & cell : conflicts)
  {
    ReleaseCell(cell->info());
  }
  const VertexHandle vertex = triangulation.insert_in_hole(
    kernelPoint, conflicts.begin(), conflicts.end(), boundary.front().first, boundary.front().second);
  m_Kernel->AddVertex(vertex, point);
  conflicts.clear();
  triangulation.incident_cells(vertex, std::back_inserter(conflicts));
  m_Kernel->Register(conflicts);
  return vertex->info();
}

void
DelaunayRefinementTriangulation::Remove(IndexType vertex)
{
  DelaunayType &          triangulation = m_Kernel->GetTriangulation();
  std::vector<CellHandle> cells;
  triangulation.incident_cells(m_Kernel->GetVertex(vertex), std::back_inserter(cells));
  for (const CellHandle & cell : cells)
  {
    ReleaseCell(cell->info());
  }
  // CGAL fills the hole in an order that depends on addresses; the cells as a set do not.
  std::sort(m_FreeCells.end() - static_cast<std::ptrdiff_t>(cells.size()), m_FreeCells.end());
  cells.clear();
  triangulation.remove_and_give_new_cells(m_Kernel->GetVertex(vertex), std::back_inserter(cells));
  m_Kernel->RemoveVertex(vertex);
  for (const CellHandle & cell : cells)
  {
    RotateSmallestVertexFirst(cell);
  }
  std::sort(cells.begin(), cells.end(), Precedes);
  m_Kernel->Register(cells);
}

void
DelaunayRefinementTriangulation::ReleaseCell(IndexType cell)
{
  ++m_Generations[cell];
  m_FreeCells.push_back(cell);
}

bool
DelaunayRefinementTriangulation::IsValid() const
{
  return m_Kernel->GetTriangulation().is_valid();
}
} // end namespace itk
