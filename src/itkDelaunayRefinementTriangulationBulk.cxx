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
#include "itkDelaunayRefinementSpatialOrder.h"
#include "itkDelaunayRefinementThreads.h"
#include "itkDelaunayRefinementTriangulationPart.h"
#include "itkDelaunayRefinementTriangulationScratch.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <numeric>

namespace itk
{
namespace
{
using Predicates = DelaunayRefinementPredicates;

constexpr std::size_t InsertionsBetweenQuestions = 4096;

/** The last rounds are inserted by parts if there are enough points. */
constexpr unsigned int NumberOfRoundsByParts = 2;
constexpr std::size_t  LeastToPart = 16384;

/** Space is parted in one way after the other. About a tenth of 80,000 points on a surface change cells between two
 * halves, half as many of four times the points. */
constexpr unsigned int NumberOfPartings = 2;
constexpr unsigned int PartsPerAxis = 3;
constexpr unsigned int NumberOfParts = PartsPerAxis * PartsPerAxis * PartsPerAxis;
constexpr std::size_t  LeastForTwoAxes = 200'000;
constexpr std::size_t  LeastForThreeAxes = 800'000;

/** Leaves what is at the end in the last part. */
constexpr double NearlyOne = 0.999;

/** Points in space have some seven cells each. */
constexpr std::size_t CellsPerPoint = 8;
} // namespace

/** \class DelaunayRefinementTriangulation::BulkType
 * \brief The insertion of many points.
 *
 * The first rounds are inserted one point after the other. Then each part of space gets its own points, but for those
 * that would change cells between parts; these are tried once more with other parts, and what is left is inserted one
 * after the other. What is done in one part does not depend on the others, so that the cells are the same for any
 * number of threads. */
class DelaunayRefinementTriangulation::BulkType
{
public:
  BulkType(DelaunayRefinementTriangulation & owner,
           const std::function<bool()> &     keepGoing,
           DelaunayRefinementThreads *       threads)
    : m_Owner(owner)
    , m_KeepGoing(keepGoing)
    , m_Threads(threads)
  {
    m_Owner.SetNumberOfThreads(threads != nullptr ? threads->GetNumberOfThreads() : 1);
  }

  bool
  Insert(const std::vector<PointType> & points);

private:
  using OrderType = DelaunayRefinementSpatialOrder;

  /** A part, its points, and the cells it may take. */
  struct ShareType
  {
    PartType                                     domain;
    IndexType                                    last{ None }; // vertex inserted
    std::vector<IndexType>                       vertices{};
    std::vector<IndexType>                       leftOver{};
    std::vector<IndexType>                       freeCells{};
    std::vector<std::pair<IndexType, IndexType>> cellsOfOthers{}; // of vertices of no part
    StarType                                     star{};
  };

  /** Puts four that make a tetrahedron to the front, and inserts them. */
  void
  StartWithTetrahedron(std::vector<IndexType> & vertices);

  /** The finite cell of four points and the infinite ones around it. */
  void
  MakeFirstCells(std::array<IndexType, 4> v);

  /** One after the other, the first near a vertex. */
  bool
  InsertInOrder(const std::vector<IndexType> & vertices, IndexType last);

  /** Sets the part of each vertex. */
  void
  PartSpace(unsigned int parting);

  std::vector<ShareType>
  MakeShares(const std::vector<IndexType> & vertices);

  /** Inserts vertices part by part; returns those that change cells of several. */
  std::vector<IndexType>
  InsertParts(const std::vector<IndexType> & vertices, unsigned int parting);

  void
  InsertShare(ShareType & share, unsigned int thread);

  /** Takes cells for a share's star; false if it has too few. */
  bool
  Take(ShareType & share) const;

  /** All cells are new. */
  void
  ListCells();

  DelaunayRefinementTriangulation & m_Owner;
  const std::function<bool()> &     m_KeepGoing;
  DelaunayRefinementThreads *       m_Threads;
  std::vector<std::uint8_t>         m_Parts{}; // of vertices
  std::atomic<bool>                 m_IsStopped{ false };
};

bool
DelaunayRefinementTriangulation::InsertMany(const std::vector<PointType> & points,
                                            const std::function<bool()> &  keepGoing,
                                            DelaunayRefinementThreads *    threads)
{
  return BulkType(*this, keepGoing, threads).Insert(points);
}

bool
DelaunayRefinementTriangulation::BulkType::Insert(const std::vector<PointType> & points)
{
  m_Owner.m_Points.insert(m_Owner.m_Points.end(), points.begin(), points.end());
  m_Owner.m_CellOfVertex.resize(m_Owner.m_Points.size(), None);

  // More points will follow.
  constexpr std::size_t cellsPerPoint = 12;
  m_Owner.m_Cells.reserve(cellsPerPoint * points.size());
  m_Owner.m_Generations.reserve(cellsPerPoint * points.size());

  const OrderType        order(points, m_Threads);
  std::vector<IndexType> vertices(points.size());
  for (std::size_t place = 0; place < points.size(); ++place)
  {
    vertices[place] = order[place] + 1;
  }
  this->StartWithTetrahedron(vertices);
  const bool isParted = points.size() >= LeastToPart;
  const auto end = isParted
                     ? vertices.begin() +
                         static_cast<std::ptrdiff_t>(order.GetBegin(OrderType::NumberOfRounds - NumberOfRoundsByParts))
                     : vertices.end();
  if (!this->InsertInOrder({ vertices.begin() + 4, end }, vertices[3]))
  {
    return false;
  }
  if (isParted)
  {
    std::vector<IndexType> rest(end, vertices.end());
    for (unsigned int parting = 0; parting < NumberOfPartings; ++parting)
    {
      rest = this->InsertParts(rest, parting);
    }
    if (m_IsStopped || !this->InsertInOrder(rest, vertices[3]))
    {
      return false;
    }
  }
  this->ListCells();
  return true;
}

void
DelaunayRefinementTriangulation::BulkType::StartWithTetrahedron(std::vector<IndexType> & vertices)
{
  const auto find = [&](std::size_t place, const auto & isGood) {
    const auto found = std::find_if(vertices.begin() + static_cast<std::ptrdiff_t>(place), vertices.end(), isGood);
    assert(found != vertices.end());
    std::rotate(vertices.begin() + static_cast<std::ptrdiff_t>(place), found, found + 1);
  };
  const auto point = [&](std::size_t place) -> const PointType & { return m_Owner.m_Points[vertices[place]]; };
  find(2, [&](IndexType vertex) {
    const PointType u = DelaunayRefinementGeometry::Subtract(point(1), point(0));
    const PointType v = DelaunayRefinementGeometry::Subtract(m_Owner.m_Points[vertex], point(0));
    const PointType normal = DelaunayRefinementGeometry::Cross(u, v);
    return DelaunayRefinementGeometry::Dot(normal, normal) > 0.0;
  });
  find(3, [&](IndexType vertex) {
    return Predicates::Orientation(point(0), point(1), point(2), m_Owner.m_Points[vertex]) != 0;
  });
  this->MakeFirstCells({ vertices[0], vertices[1], vertices[2], vertices[3] });
}

void
DelaunayRefinementTriangulation::BulkType::MakeFirstCells(std::array<IndexType, 4> v)
{
  if (Predicates::Orientation(
        m_Owner.m_Points[v[0]], m_Owner.m_Points[v[1]], m_Owner.m_Points[v[2]], m_Owner.m_Points[v[3]]) < 0)
  {
    std::swap(v[2], v[3]);
  }
  const IndexType finite = m_Owner.TakeCell();
  m_Owner.m_Cells[finite].vertices = v;
  std::array<IndexType, 4> infinite;
  for (unsigned int i = 0; i < 4; ++i)
  {
    infinite[i] = m_Owner.TakeCell();
    // An odd permutation of the finite cell, as it lies on the other side of the facet.
    auto & vertices = m_Owner.m_Cells[infinite[i]].vertices;
    vertices = v;
    vertices[i] = InfiniteVertex;
    std::swap(vertices[(i + 1) & 3], vertices[(i + 2) & 3]);
    m_Owner.m_Cells[infinite[i]].neighbors[i] = finite;
    m_Owner.m_Cells[finite].neighbors[i] = infinite[i];
  }
  for (unsigned int i = 0; i < 4; ++i)
  {
    for (unsigned int slot = 0; slot < 4; ++slot)
    {
      if (slot != i)
      {
        // Opposite to vertex j of the finite cell is the infinite cell j.
        const IndexType vertex = m_Owner.m_Cells[infinite[i]].vertices[slot];
        const auto      j = std::find(v.begin(), v.end(), vertex) - v.begin();
        m_Owner.m_Cells[infinite[i]].neighbors[slot] = infinite[j];
      }
    }
  }
  for (const IndexType cell : { finite, infinite[0], infinite[1], infinite[2], infinite[3] })
  {
    m_Owner.UpdateCellOfVertices(cell);
    m_Owner.ComputeBall(cell);
  }
}

bool
DelaunayRefinementTriangulation::BulkType::InsertInOrder(const std::vector<IndexType> & vertices, IndexType last)
{
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (i % InsertionsBetweenQuestions == 0 && !m_KeepGoing())
    {
      return false;
    }
    m_Owner.m_Star.vertex = vertices[i];
    if (m_Owner.MakeStar(m_Owner.m_Points[vertices[i]], m_Owner.m_CellOfVertex[last]))
    {
      last = vertices[i];
    }
  }
  return true;
}

void
DelaunayRefinementTriangulation::BulkType::PartSpace(unsigned int parting)
{
  const auto & points = m_Owner.m_Points;
  PointType    minimum = points[1];
  PointType    maximum = points[1];
  for (IndexType vertex = 2; vertex < points.size(); ++vertex)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      minimum[i] = std::min(minimum[i], points[vertex][i]);
      maximum[i] = std::max(maximum[i], points[vertex][i]);
    }
  }
  // Into halves along the longest axes first; then along all, these with borders in the middle of the first parts.
  const unsigned int numberOfAxes = points.size() < LeastForTwoAxes ? 1 : points.size() < LeastForThreeAxes ? 2 : 3;
  std::array<unsigned int, 3> axes{ 0, 1, 2 };
  std::sort(axes.begin(), axes.end(), [&](unsigned int a, unsigned int b) {
    return maximum[a] - minimum[a] > maximum[b] - minimum[b];
  });
  PointType partsPerLength{};
  PointType shift{};
  for (unsigned int i = 0; i < 3; ++i)
  {
    const bool   isLong = i < numberOfAxes;
    const double number = isLong || parting > 0 ? 2.0 : 1.0;
    partsPerLength[axes[i]] = NearlyOne * number / (maximum[axes[i]] - minimum[axes[i]]);
    shift[axes[i]] = isLong ? 0.5 * parting : 0.0;
  }
  m_Parts.resize(points.size());
  for (IndexType vertex = 1; vertex < points.size(); ++vertex)
  {
    unsigned int part = 0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double place = (points[vertex][i] - minimum[i]) * partsPerLength[i] + shift[i];
      part = part * PartsPerAxis + static_cast<unsigned int>(place);
    }
    m_Parts[vertex] = static_cast<std::uint8_t>(part);
  }
  // Cells at the convex hull may be long: its vertices are no reason to keep parts apart.
  m_Parts[InfiniteVertex] = PartType::NoPart;
  for (IndexType cell = 0; cell < m_Owner.GetNumberOfCellIndexes(); ++cell)
  {
    if (m_Owner.IsAlive(cell) && m_Owner.IsInfinite(cell))
    {
      for (const IndexType vertex : m_Owner.m_Cells[cell].vertices)
      {
        m_Parts[vertex] = PartType::NoPart;
      }
    }
  }
}

std::vector<DelaunayRefinementTriangulation::BulkType::ShareType>
DelaunayRefinementTriangulation::BulkType::MakeShares(const std::vector<IndexType> & vertices)
{
  std::vector<ShareType> shares;
  for (std::uint8_t part = 0; part < NumberOfParts; ++part)
  {
    shares.push_back({ PartType(m_Parts, part) });
  }
  for (IndexType vertex = 1; vertex < m_Parts.size(); ++vertex)
  {
    if (m_Parts[vertex] != PartType::NoPart && m_Owner.m_CellOfVertex[vertex] != None)
    {
      shares[m_Parts[vertex]].last = vertex;
    }
  }
  for (const IndexType vertex : vertices)
  {
    shares[m_Parts[vertex]].vertices.push_back(vertex);
  }
  auto & freeCells = m_Owner.m_FreeCells;
  for (ShareType & share : shares)
  {
    const std::size_t number = CellsPerPoint * share.vertices.size();
    const std::size_t numberOfNew = number - std::min(number, freeCells.size());
    const auto        firstNew = m_Owner.GetNumberOfCellIndexes();
    m_Owner.m_Cells.resize(firstNew + numberOfNew);
    m_Owner.m_Generations.resize(firstNew + numberOfNew, 0);
    // The last ones go first.
    share.freeCells.resize(numberOfNew);
    std::iota(share.freeCells.rbegin(), share.freeCells.rend(), firstNew);
    const auto old = freeCells.end() - static_cast<std::ptrdiff_t>(number - numberOfNew);
    share.freeCells.insert(share.freeCells.end(), old, freeCells.end());
    freeCells.erase(old, freeCells.end());
  }
  // The large ones first, so that none is left alone at the end.
  std::stable_sort(shares.begin(), shares.end(), [](const ShareType & a, const ShareType & b) {
    return a.vertices.size() > b.vertices.size();
  });
  return shares;
}

std::vector<DelaunayRefinementTriangulation::IndexType>
DelaunayRefinementTriangulation::BulkType::InsertParts(const std::vector<IndexType> & vertices, unsigned int parting)
{
  this->PartSpace(parting);
  std::vector<ShareType> shares = this->MakeShares(vertices);
  const auto insertShare = [&](std::size_t i, unsigned int thread) { this->InsertShare(shares[i], thread); };
  if (m_Threads != nullptr)
  {
    m_Threads->Run(shares.size(), insertShare);
  }
  else
  {
    for (std::size_t i = 0; i < shares.size(); ++i)
    {
      insertShare(i, 0);
    }
  }
  std::vector<IndexType> leftOver;
  for (const ShareType & share : shares)
  {
    leftOver.insert(leftOver.end(), share.leftOver.begin(), share.leftOver.end());
    m_Owner.m_FreeCells.insert(m_Owner.m_FreeCells.end(), share.freeCells.begin(), share.freeCells.end());
    for (const auto & [vertex, cell] : share.cellsOfOthers)
    {
      m_Owner.m_CellOfVertex[vertex] = cell;
    }
  }
  return leftOver;
}

void
DelaunayRefinementTriangulation::BulkType::InsertShare(ShareType & share, unsigned int thread)
{
  if (share.last == None)
  {
    share.leftOver = share.vertices;
    return;
  }
  StarType &    star = share.star;
  ScratchType & scratch = *m_Owner.m_Scratches[thread];
  IndexType     hint = m_Owner.m_CellOfVertex[share.last];
  for (std::size_t i = 0; i < share.vertices.size() && !m_IsStopped; ++i)
  {
    if (thread == 0 && i % InsertionsBetweenQuestions == 0 && !m_KeepGoing())
    {
      m_IsStopped = true;
      return;
    }
    const IndexType   vertex = share.vertices[i];
    const PointType & point = m_Owner.m_Points[vertex];
    star.vertex = vertex;
    if (!m_Owner.FindStarIn(share.domain, point, hint, star, scratch) || !this->Take(share))
    {
      hint = star.cavity.front();
      share.leftOver.push_back(vertex);
      continue;
    }
    m_Owner.Fill(star, thread);
    m_Owner.m_CellOfVertex[vertex] = star.cells.front();
    for (const auto & [around, cell] : star.cellsOfVertices)
    {
      if (share.domain.Has(around))
      {
        m_Owner.m_CellOfVertex[around] = cell;
      }
      else
      {
        share.cellsOfOthers.emplace_back(around, cell);
      }
    }
    hint = star.cells.front();
  }
}

bool
DelaunayRefinementTriangulation::BulkType::Take(ShareType & share) const
{
  if (share.star.boundary.size() > share.star.cavity.size() + share.freeCells.size())
  {
    return false;
  }
  const auto takeCell = [&] {
    const IndexType cell = share.freeCells.back();
    share.freeCells.pop_back();
    ++m_Owner.m_Generations[cell];
    return cell;
  };
  m_Owner.TakeCells(share.star, takeCell, share.freeCells);
  return true;
}

void
DelaunayRefinementTriangulation::BulkType::ListCells()
{
  constexpr std::size_t    cellsPerPiece = 16384;
  const std::size_t        size = m_Owner.GetNumberOfCellIndexes();
  std::vector<std::size_t> places(DelaunayRefinementThreads::CountPieces(size, cellsPerPiece) + 1, 0);
  DelaunayRefinementThreads::RunPieces(
    m_Threads, size, cellsPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      for (auto cell = static_cast<IndexType>(begin); cell < end; ++cell)
      {
        if (m_Owner.IsAlive(cell))
        {
          m_Owner.MendBall(cell);
          ++places[piece + 1];
        }
      }
    });
  std::partial_sum(places.begin(), places.end(), places.begin());
  m_Owner.m_NewCells.resize(places.back());
  DelaunayRefinementThreads::RunPieces(
    m_Threads, size, cellsPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      IndexType * place = m_Owner.m_NewCells.data() + places[piece];
      for (auto cell = static_cast<IndexType>(begin); cell < end; ++cell)
      {
        if (m_Owner.IsAlive(cell))
        {
          *place++ = cell;
        }
      }
    });
}
} // end namespace itk
