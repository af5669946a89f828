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

#include "itkDelaunayRefinementPredicates.h"
#include "itkDelaunayRefinementSpatialOrder.h"
#include "itkDelaunayRefinementWideLoops.h"

#include <algorithm>
#include <cassert>

namespace itk
{
namespace
{
using Predicates = DelaunayRefinementPredicates;
using PointType = DelaunayRefinementPoint;
using IndexType = DelaunayRefinementTriangulation::IndexType;

constexpr std::size_t InsertionsBetweenQuestions = 4096;

/** The vertices of the facet opposite to each vertex, counterclockwise as seen from that vertex. */
constexpr unsigned int FacetVertices[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };

/** Of finite cells that are flatter, or further from the origin for their size, the circumball decides nothing. Its
 * center is known to some 30 roundings times (longest edge)^3 / determinant of the radius, which leaves
 * DecidingShare a margin of ten. */
constexpr double FlattestDeciding = 1e-6;
constexpr double SmallestDeciding = 1e-7;

/** Has memory fetched that will be read soon. */
void
Prefetch(const void * address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

/** The vertices of a facet in the same sense, the smallest first. */
std::array<IndexType, 3>
RotateSmallestFirst(std::array<IndexType, 3> facet)
{
  std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  return facet;
}

/** The balls through the origin and three points u, v, w each, of several cells at once: one array for each number, so
 * that compilers do them together. */
struct BallsType
{
  static constexpr std::size_t Size = 4;
  using NumbersType = std::array<double, Size>;

  std::array<NumbersType, 3> u;
  std::array<NumbersType, 3> v;
  std::array<NumbersType, 3> w;
  std::array<NumbersType, 3> center;
  /** Negative where they decide nothing. */
  NumbersType signedSquaredRadius;

  BallsType()
  {
    for (std::size_t i = 0; i < Size; ++i)
    {
      this->SetAny(i);
    }
  }

  /** Something to compute with where there is no cell. */
  void
  SetAny(std::size_t i)
  {
    this->SetPoints(i, {}, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 });
  }

  void
  SetPoints(std::size_t i, const PointType & origin, const PointType & a, const PointType & b, const PointType & c)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      u[j][i] = a[j] - origin[j];
      v[j][i] = b[j] - origin[j];
      w[j][i] = c[j] - origin[j];
    }
  }

  ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
  void
  Compute(const PointType & origin)
  {
    const double far = SmallestDeciding * std::max({ std::abs(origin[0]), std::abs(origin[1]), std::abs(origin[2]) });
    const double squaredFar = far * far;
    for (std::size_t i = 0; i < Size; ++i)
    {
      const double ux = u[0][i];
      const double uy = u[1][i];
      const double uz = u[2][i];
      const double vx = v[0][i];
      const double vy = v[1][i];
      const double vz = v[2][i];
      const double wx = w[0][i];
      const double wy = w[1][i];
      const double wz = w[2][i];
      const double vwX = vy * wz - vz * wy;
      const double vwY = vz * wx - vx * wz;
      const double vwZ = vx * wy - vy * wx;
      const double uu = ux * ux + uy * uy + uz * uz;
      const double vv = vx * vx + vy * vy + vz * vz;
      const double ww = wx * wx + wy * wy + wz * wz;
      const double determinant = ux * vwX + uy * vwY + uz * vwZ;
      const double factor = 0.5 / determinant;
      const double x = factor * (uu * vwX + vv * (wy * uz - wz * uy) + ww * (uy * vz - uz * vy));
      const double y = factor * (uu * vwY + vv * (wz * ux - wx * uz) + ww * (uz * vx - ux * vz));
      const double z = factor * (uu * vwZ + vv * (wx * uy - wy * ux) + ww * (ux * vy - uy * vx));
      const double greater = uu > vv ? uu : vv;
      const double greatest = greater > ww ? greater : ww;
      const double flattest = FlattestDeciding * FlattestDeciding * greatest * greatest * greatest;
      const double squaredRadius = x * x + y * y + z * z;
      const double deciding = greatest > squaredFar ? squaredRadius : -squaredRadius;
      center[0][i] = x;
      center[1][i] = y;
      center[2][i] = z;
      signedSquaredRadius[i] = determinant * determinant > flattest ? deciding : -squaredRadius;
    }
  }

  PointType
  GetCenter(std::size_t i, const PointType & origin) const
  {
    return { origin[0] + center[0][i], origin[1] + center[1][i], origin[2] + center[2][i] };
  }
};

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
  : m_Matrix(MostVerticesOfMatrix * MostVerticesOfMatrix)
{
  m_Points.push_back({});
  m_CellOfVertex.push_back(None);
}

bool
DelaunayRefinementTriangulation::InsertMany(const std::vector<PointType> & points,
                                            const std::function<bool()> &  keepGoing)
{
  m_Points.insert(m_Points.end(), points.begin(), points.end());
  m_CellOfVertex.resize(m_Points.size(), None);
  std::vector<IndexType> order = ComputeDelaunayRefinementSpatialOrder(points);
  for (IndexType & vertex : order)
  {
    ++vertex;
  }

  // Points in space have some seven cells each; more will follow.
  constexpr std::size_t cellsPerPoint = 12;
  m_Cells.reserve(cellsPerPoint * points.size());
  m_Generations.reserve(cellsPerPoint * points.size());

  // The first that make a tetrahedron go to the front.
  const auto find = [&](std::size_t place, const auto & isGood) {
    const auto found = std::find_if(order.begin() + static_cast<std::ptrdiff_t>(place), order.end(), isGood);
    assert(found != order.end());
    std::rotate(order.begin() + static_cast<std::ptrdiff_t>(place), found, found + 1);
  };
  const auto point = [&](std::size_t place) -> const PointType & { return m_Points[order[place]]; };
  find(2, [&](IndexType vertex) {
    const PointType u = DelaunayRefinementGeometry::Subtract(point(1), point(0));
    const PointType v = DelaunayRefinementGeometry::Subtract(m_Points[vertex], point(0));
    const PointType normal = DelaunayRefinementGeometry::Cross(u, v);
    return DelaunayRefinementGeometry::Dot(normal, normal) > 0.0;
  });
  find(3,
       [&](IndexType vertex) { return Predicates::Orientation(point(0), point(1), point(2), m_Points[vertex]) != 0; });
  this->MakeFirstCells({ order[0], order[1], order[2], order[3] });

  IndexType last = order[3];
  for (std::size_t i = 4; i < order.size(); ++i)
  {
    if (i % InsertionsBetweenQuestions == 0 && !keepGoing())
    {
      return false;
    }
    this->MakeStar(order[i], this->FindConflict(m_Points[order[i]], m_CellOfVertex[last]));
    last = order[i];
  }
  m_NewCells.clear();
  for (IndexType cell = 0; cell < this->GetNumberOfCellIndexes(); ++cell)
  {
    if (this->IsAlive(cell))
    {
      this->MendBall(cell);
      m_NewCells.push_back(cell);
    }
  }
  return true;
}

IndexType
DelaunayRefinementTriangulation::Insert(const PointType & point, IndexType hint)
{
  const IndexType start = this->FindConflict(point, hint);
  if (start == None)
  {
    return None;
  }
  const auto vertex = static_cast<IndexType>(m_Points.size());
  m_Points.push_back(point);
  m_CellOfVertex.push_back(None);
  this->MakeStar(vertex, start);
  for (const IndexType cell : m_NewCells)
  {
    this->MendBall(cell);
  }
  return vertex;
}

void
DelaunayRefinementTriangulation::MakeFirstCells(std::array<IndexType, 4> v)
{
  if (Predicates::Orientation(m_Points[v[0]], m_Points[v[1]], m_Points[v[2]], m_Points[v[3]]) < 0)
  {
    std::swap(v[2], v[3]);
  }
  const IndexType finite = this->TakeCell();
  m_Cells[finite].vertices = v;
  std::array<IndexType, 4> infinite;
  for (unsigned int i = 0; i < 4; ++i)
  {
    infinite[i] = this->TakeCell();
    // An odd permutation of the finite cell, as it lies on the other side of the facet.
    auto & vertices = m_Cells[infinite[i]].vertices;
    vertices = v;
    vertices[i] = InfiniteVertex;
    std::swap(vertices[(i + 1) & 3], vertices[(i + 2) & 3]);
    m_Cells[infinite[i]].neighbors[i] = finite;
    m_Cells[finite].neighbors[i] = infinite[i];
  }
  for (unsigned int i = 0; i < 4; ++i)
  {
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      if (slot != i)
      {
        // Opposite to vertex j of the finite cell is the infinite cell j.
        const IndexType vertex = m_Cells[infinite[i]].vertices[slot];
        const auto      j = std::find(v.begin(), v.end(), vertex) - v.begin();
        m_Cells[infinite[i]].neighbors[slot] = infinite[j];
      }
    }
  }
  for (const IndexType cell : { finite, infinite[0], infinite[1], infinite[2], infinite[3] })
  {
    this->UpdateCellOfVertices(cell);
    this->ComputeBall(cell);
  }
}

IndexType
DelaunayRefinementTriangulation::FindConflict(const PointType & point, IndexType hint) const
{
  if (this->IsInConflict(hint, point))
  {
    return hint;
  }
  const IndexType cell = this->Locate(point, hint);
  for (const IndexType vertex : m_Cells[cell].vertices)
  {
    if (vertex != InfiniteVertex && m_Points[vertex] == point)
    {
      return None;
    }
  }
  return cell;
}

IndexType
DelaunayRefinementTriangulation::Locate(const PointType & point, IndexType start) const
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
    for (unsigned int i = 0; i < 4 && next == None; ++i)
    {
      if (current.neighbors[i] != previous)
      {
        const PointType * const corner = corners[i];
        corners[i] = &point;
        if (Predicates::Orientation(*corners[0], *corners[1], *corners[2], *corners[3]) < 0)
        {
          next = current.neighbors[i];
        }
        corners[i] = corner;
      }
    }
    if (next == None)
    {
      return cell;
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

void
DelaunayRefinementTriangulation::AddBoundary(IndexType cell, unsigned int slot)
{
  const IndexType beyond = m_Cells[cell].neighbors[slot];
  const auto &    neighbors = m_Cells[beyond].neighbors;
  unsigned int    mirror = 0;
  while (neighbors[mirror] != cell)
  {
    ++mirror;
  }
  m_Boundary.push_back(
    { m_Cells[cell].vertices, beyond, static_cast<std::uint8_t>(slot), static_cast<std::uint8_t>(mirror) });
}

void
DelaunayRefinementTriangulation::FindCavity(const PointType & point, IndexType start)
{
  m_CellMarks.resize(m_Cells.size(), MarkEnum::NONE);
  m_Cavity.assign(1, start);
  m_Boundary.clear();
  m_CellMarks[start] = MarkEnum::IN;
  for (std::size_t i = 0; i < m_Cavity.size(); ++i)
  {
    const IndexType cell = m_Cavity[i];
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      const IndexType neighbor = m_Cells[cell].neighbors[slot];
      MarkEnum &      mark = m_CellMarks[neighbor];
      if (mark == MarkEnum::IN)
      {
        continue;
      }
      if (mark == MarkEnum::NONE)
      {
        if (this->IsInConflict(neighbor, point))
        {
          mark = MarkEnum::IN;
          m_Cavity.push_back(neighbor);
          for (const IndexType next : m_Cells[neighbor].neighbors)
          {
            Prefetch(&m_Cells[next]);
          }
          continue;
        }
        mark = MarkEnum::OUT;
      }
      this->AddBoundary(cell, slot);
    }
  }
  this->ClearMarks();
}

void
DelaunayRefinementTriangulation::ClearMarks()
{
  for (const IndexType cell : m_Cavity)
  {
    m_CellMarks[cell] = MarkEnum::NONE;
  }
  for (const BoundaryType & facet : m_Boundary)
  {
    m_CellMarks[facet.beyond] = MarkEnum::NONE;
  }
}

void
DelaunayRefinementTriangulation::MakeStar(IndexType vertex, IndexType start)
{
  this->FindCavity(m_Points[vertex], start);
  const std::size_t size = m_Boundary.size();
  m_NewCells.resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    // Most of them take the places of cells that are gone.
    IndexType index;
    if (i < m_Cavity.size())
    {
      index = m_Cavity[i];
      m_Generations[index] += 2;
    }
    else
    {
      index = this->TakeCell();
    }
    const BoundaryType & facet = m_Boundary[i];
    CellType &           cell = m_Cells[index];
    cell.vertices = facet.vertices;
    cell.vertices[facet.slot] = vertex;
    cell.neighbors[facet.slot] = facet.beyond;
    m_Cells[facet.beyond].neighbors[facet.mirror] = index;
    m_NewCells[i] = index;
  }
  for (std::size_t i = size; i < m_Cavity.size(); ++i)
  {
    this->ReleaseCell(m_Cavity[i]);
  }
  m_CellOfVertex[vertex] = m_NewCells.front();
  this->LinkStar();
  this->ComputeBallsOfStar(vertex);
}

void
DelaunayRefinementTriangulation::LinkStar()
{
  // The cavity's boundary is oriented: each of its edges is passed once in either direction.
  m_VertexPlaces.resize(m_Points.size(), 0);
  ++m_NumberOfStars;
  std::uint32_t numberOfPlaces = 0;
  m_FacetPlaces.resize(m_NewCells.size());
  for (std::size_t i = 0; i < m_NewCells.size(); ++i)
  {
    const IndexType index = m_NewCells[i];
    const auto &    slots = FacetVertices[m_Boundary[i].slot];
    const auto &    vertices = m_Boundary[i].vertices;
    auto &          places = m_FacetPlaces[i];
    for (unsigned int j = 0; j < 3; ++j)
    {
      const IndexType vertex = vertices[slots[j]];
      std::uint64_t & place = m_VertexPlaces[vertex];
      if (place >> 32 != m_NumberOfStars)
      {
        place = static_cast<std::uint64_t>(m_NumberOfStars) << 32 | numberOfPlaces++;
        m_CellOfVertex[vertex] = index;
      }
      places[j] = static_cast<std::uint32_t>(place);
    }
    if (numberOfPlaces <= MostVerticesOfMatrix)
    {
      m_Matrix[places[0] * MostVerticesOfMatrix + places[1]] = index;
      m_Matrix[places[1] * MostVerticesOfMatrix + places[2]] = index;
      m_Matrix[places[2] * MostVerticesOfMatrix + places[0]] = index;
    }
  }
  if (numberOfPlaces > MostVerticesOfMatrix)
  {
    this->LinkLargeStar();
    return;
  }
  for (std::size_t i = 0; i < m_NewCells.size(); ++i)
  {
    const auto & slots = FacetVertices[m_Boundary[i].slot];
    const auto & places = m_FacetPlaces[i];
    auto &       neighbors = m_Cells[m_NewCells[i]].neighbors;
    neighbors[slots[2]] = m_Matrix[places[1] * MostVerticesOfMatrix + places[0]];
    neighbors[slots[0]] = m_Matrix[places[2] * MostVerticesOfMatrix + places[1]];
    neighbors[slots[1]] = m_Matrix[places[0] * MostVerticesOfMatrix + places[2]];
  }
}

void
DelaunayRefinementTriangulation::LinkLargeStar()
{
  m_SharedEdges.clear();
  for (std::size_t i = 0; i < m_NewCells.size(); ++i)
  {
    const auto & slots = FacetVertices[m_Boundary[i].slot];
    const auto & vertices = m_Cells[m_NewCells[i]].vertices;
    for (unsigned int j = 0; j < 3; ++j)
    {
      const auto ends = std::minmax(vertices[slots[j]], vertices[slots[(j + 1) % 3]]);
      m_SharedEdges.push_back({ static_cast<std::uint64_t>(ends.first) << 32 | ends.second,
                                m_NewCells[i],
                                static_cast<std::uint8_t>(slots[(j + 2) % 3]) });
    }
  }
  std::sort(m_SharedEdges.begin(), m_SharedEdges.end(), [](const SharedEdgeType & a, const SharedEdgeType & b) {
    return a.vertices < b.vertices;
  });
  for (std::size_t i = 0; i + 1 < m_SharedEdges.size(); i += 2)
  {
    const SharedEdgeType & one = m_SharedEdges[i];
    const SharedEdgeType & other = m_SharedEdges[i + 1];
    m_Cells[one.cell].neighbors[one.slot] = other.cell;
    m_Cells[other.cell].neighbors[other.slot] = one.cell;
  }
}

void
DelaunayRefinementTriangulation::FindStar(IndexType vertex)
{
  m_CellMarks.resize(m_Cells.size(), MarkEnum::NONE);
  m_Boundary.clear();
  m_Cavity.assign(1, m_CellOfVertex[vertex]);
  m_CellMarks[m_Cavity.front()] = MarkEnum::IN;
  for (std::size_t i = 0; i < m_Cavity.size(); ++i)
  {
    const IndexType cell = m_Cavity[i];
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      const IndexType neighbor = m_Cells[cell].neighbors[slot];
      if (m_Cells[cell].vertices[slot] == vertex)
      {
        this->AddBoundary(cell, slot);
      }
      else if (m_CellMarks[neighbor] != MarkEnum::IN)
      {
        m_CellMarks[neighbor] = MarkEnum::IN;
        m_Cavity.push_back(neighbor);
      }
    }
  }
  this->ClearMarks();
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
  // The cells that fill the hole are those of the triangulation of the vertices around it.
  this->FindStar(vertex);
  std::vector<IndexType> around{ InfiniteVertex };
  for (const BoundaryType & facet : m_Boundary)
  {
    for (const unsigned int slot : FacetVertices[facet.slot])
    {
      around.push_back(facet.vertices[slot]);
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
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
  for (std::size_t i = 0; i < m_Boundary.size(); ++i)
  {
    const auto &            v = m_Boundary[i].vertices;
    const auto &            slots = FacetVertices[m_Boundary[i].slot];
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

  for (const IndexType cell : m_Cavity)
  {
    this->ReleaseCell(cell);
  }
  m_CellOfVertex[vertex] = None;
  m_NewCells.clear();
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
        const BoundaryType & facet = m_Boundary[beyond[local][slot]];
        cell.neighbors[slot] = facet.beyond;
        m_Cells[facet.beyond].neighbors[facet.mirror] = globals[local];
      }
    }
    this->UpdateCellOfVertices(globals[local]);
    this->ComputeBall(globals[local]);
    this->MendBall(globals[local]);
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
DelaunayRefinementTriangulation::ComputeBallsOfStar(IndexType vertex)
{
  const PointType & origin = m_Points[vertex];
  BallsType         balls;
  for (std::size_t first = 0; first < m_NewCells.size(); first += BallsType::Size)
  {
    const std::size_t size = std::min(BallsType::Size, m_NewCells.size() - first);
    for (std::size_t i = 0; i < size; ++i)
    {
      const BoundaryType & facet = m_Boundary[first + i];
      const auto &         slots = FacetVertices[facet.slot];
      if (this->IsInfinite(m_NewCells[first + i]))
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
      CellType & cell = m_Cells[m_NewCells[first + i]];
      cell.center = balls.GetCenter(i, origin);
      cell.signedSquaredRadius = balls.signedSquaredRadius[i];
      if (this->IsInfinite(m_NewCells[first + i]))
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
    const PointType & origin = m_Points[cell.vertices[0]];
    BallsType         balls;
    balls.SetPoints(0, origin, m_Points[cell.vertices[1]], m_Points[cell.vertices[2]], m_Points[cell.vertices[3]]);
    balls.Compute(origin);
    cell.center = balls.GetCenter(0, origin);
    cell.signedSquaredRadius = balls.signedSquaredRadius[0];
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
