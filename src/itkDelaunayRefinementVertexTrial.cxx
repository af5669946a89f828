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
#include "itkDelaunayRefinementVertexTrial.h"

#include "itkDelaunayRefinementBalls.h"

#include <algorithm>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using IndexType = DelaunayRefinementComplex::IndexType;
using VertexKind = DelaunayRefinementEnums::VertexKind;

/** Bounds are kept with some room. */
constexpr double RatioShare = 0.99;
constexpr double SizeShare = 0.999;
constexpr double LargestBoundaryCosine = 0.86339555; // of 30.3 degrees

constexpr const auto & Facets = DelaunayRefinementComplex::OutwardFacets;

/** Stands for the vertex that is to come. */
constexpr IndexType NewVertex = DelaunayRefinementComplex::None - 1;

std::array<IndexType, 3>
GetFacet(const std::array<IndexType, 4> & vertices, unsigned int opposite)
{
  const auto & slots = Facets[opposite];
  return { vertices[slots[0]], vertices[slots[1]], vertices[slots[2]] };
}
} // namespace

DelaunayRefinementVertexTrial::DelaunayRefinementVertexTrial(const DelaunayRefinementParameters & parameters,
                                                             const DelaunayRefinementOracle &     oracle,
                                                             const DelaunayRefinementRules &      rules,
                                                             DelaunayRefinementManifoldRepair &   repair,
                                                             DelaunayRefinementComplex &          complex)
  : m_Parameters(parameters)
  , m_Oracle(oracle)
  , m_Rules(rules)
  , m_Repair(repair)
  , m_Complex(complex)
  , m_Angles(parameters.minimumDihedralAngle)
{}

double
DelaunayRefinementVertexTrial::ComputeBadness(IndexType cell) const
{
  if (m_Complex.GetRegion(cell) == 0)
  {
    return 0.0;
  }
  const auto p = m_Complex.GetPoints(cell);
  return m_Angles.ComputeBadness(p[0], p[1], p[2], p[3]);
}

bool
DelaunayRefinementVertexTrial::IsTooLarge(double squaredRadius, double squaredShortestEdge) const
{
  const double ratio = RatioShare * m_Parameters.radiusEdgeRatioBound;
  const double size = SizeShare * m_Parameters.cellSize;
  return squaredRadius >= ratio * ratio * squaredShortestEdge || squaredRadius >= size * size;
}

bool
DelaunayRefinementVertexTrial::IsTooLarge(IndexType cell) const
{
  const auto p = m_Complex.GetPoints(cell);
  return m_Complex.GetRegion(cell) != 0 &&
         this->IsTooLarge(m_Complex.GetSquaredRadius(cell),
                          Geometry::ComputeSquaredShortestEdge(p[0], p[1], p[2], p[3]));
}

bool
DelaunayRefinementVertexTrial::MayPartRegions(const PointType & first, IndexType second, IndexType third) const
{
  return m_Complex.IsFeature(second) && m_Complex.IsFeature(third) &&
         Geometry::ComputeLargestCosine(first, m_Complex.GetPoint(second), m_Complex.GetPoint(third)) <
           LargestBoundaryCosine;
}

void
DelaunayRefinementVertexTrial::CloseHole()
{
  m_Vertex = None;
  m_Hole.clear();
  ++m_HoleMark;
  m_KeptRegions.clear();
  m_StarFacets.Clear();
  m_StarBadness = 0.0;
  m_HoleBadness = 0.0;
  m_NumberOfTooLarge = 0;
  m_IsUniform = true;
}

bool
DelaunayRefinementVertexTrial::MayInsert(const PointType & point, VertexKind kind, IndexType hint, double spacing)
{
  this->CloseHole();
  m_Region = m_Complex.GetRegion(hint);
  return this->MayBeAt(point, kind, hint, spacing, -LeastGain);
}

bool
DelaunayRefinementVertexTrial::MayInsertFeature(const PointType & point, IndexType hint)
{
  this->CloseHole();
  return this->MayBeAt(point, VertexKind::FEATURE, hint, 0.0, std::numeric_limits<double>::infinity());
}

bool
DelaunayRefinementVertexTrial::MayPut(const PointType & point, double spacing)
{
  return this->MayBeAt(point, m_Complex.GetKind(m_Vertex), m_Hole.front().first, spacing, -LeastGain);
}

bool
DelaunayRefinementVertexTrial::MayBeAt(const PointType & point,
                                       VertexKind        kind,
                                       IndexType         hint,
                                       double            spacing,
                                       double            mostChange)
{
  const bool isFree = kind == VertexKind::FREE;
  if ((isFree && !m_IsUniform) || !m_Complex.FindStar(point, hint, m_Star, 0) || !this->ExamineCavity(isFree) ||
      !this->KeepsSpacing(point, isFree, spacing) || !this->FindShapes(point, isFree, m_BadnessBefore + mostChange))
  {
    return false;
  }
  return isFree || this->KeepsBoundary(point);
}

bool
DelaunayRefinementVertexTrial::ExamineCavity(bool isFree)
{
  const std::size_t size = m_Complex.GetTriangulation().GetNumberOfCellIndexes();
  m_CavityMarks.resize(size, 0);
  m_HoleMarks.resize(size, 0);
  ++m_CavityMark;
  double      badness = 0.0;
  std::size_t numberOfTooLarge = 0;
  for (const IndexType cell : m_Star.cavity)
  {
    if ((isFree && m_Complex.GetRegion(cell) != m_Region) || m_Repair.IsChanged(cell))
    {
      return false;
    }
    m_CavityMarks[cell] = m_CavityMark;
    badness += this->ComputeBadness(cell);
    numberOfTooLarge += m_NumberOfTooLarge > 0 && m_HoleMarks[cell] == m_HoleMark && this->IsTooLarge(cell) ? 1 : 0;
  }
  // Of all cells that are other ones before and after.
  m_BadnessBefore = badness + m_StarBadness - m_HoleBadness;
  return numberOfTooLarge == m_NumberOfTooLarge;
}

bool
DelaunayRefinementVertexTrial::KeepsSpacing(const PointType & point, bool isFree, double spacing) const
{
  return std::all_of(m_Star.boundary.begin(), m_Star.boundary.end(), [&](const auto & facet) {
    const auto vertices = GetFacet(facet.vertices, facet.slot);
    return std::all_of(vertices.begin(), vertices.end(), [&](IndexType other) {
      return !(isFree || m_Complex.IsFeature(other)) ||
             Geometry::SquaredDistance(point, m_Complex.GetPoint(other)) >= spacing * spacing;
    });
  });
}

bool
DelaunayRefinementVertexTrial::FindShapes(const PointType & point, bool isFree, double most)
{
  const std::size_t size = m_Star.boundary.size();
  m_Shapes.resize(size);
  double                  badness = 0.0;
  DelaunayRefinementBalls balls;
  for (std::size_t first = 0; first < size; first += DelaunayRefinementBalls::Size)
  {
    const std::size_t                number = std::min(DelaunayRefinementBalls::Size, size - first);
    std::array<FacetVerticesType, 4> facets;
    const auto                       getPoint = [&](std::size_t i, unsigned int corner) -> const PointType & {
      return m_Complex.GetPoint(facets[i][corner]);
    };
    for (std::size_t i = 0; i < number; ++i)
    {
      facets[i] = GetFacet(m_Star.boundary[first + i].vertices, m_Star.boundary[first + i].slot);
      balls.SetPoints(i, point, getPoint(i, 0), getPoint(i, 1), getPoint(i, 2));
    }
    balls.Compute(point);
    for (std::size_t i = 0; i < number; ++i)
    {
      const PointType & a = getPoint(i, 0);
      const PointType & b = getPoint(i, 1);
      const PointType & c = getPoint(i, 2);
      ShapeType &       shape = m_Shapes[first + i];
      shape.center = balls.GetCenter(i, point);
      shape.squaredRadius = balls.GetSignedSquaredRadius(i);
      if (!(shape.squaredRadius > 0.0))
      {
        // In the order that the cell would have, so that rounding is the same.
        const auto &             facet = m_Star.boundary[first + i];
        std::array<PointType, 4> p;
        for (unsigned int corner = 0; corner < 4; ++corner)
        {
          p[corner] = corner == facet.slot ? point : m_Complex.GetPoint(facet.vertices[corner]);
        }
        const auto ball = Geometry::ComputeCircumsphere(p[0], p[1], p[2], p[3]);
        shape.center = ball.center;
        shape.squaredRadius = ball.squaredRadius;
      }
      shape.region = this->FindKeptRegion(facets[i], m_Oracle.Classify(shape.center));
      if (isFree && shape.region != m_Region)
      {
        return false;
      }
      if (shape.region != 0)
      {
        badness += m_Angles.ComputeBadness(point, a, b, c);
        if (badness > most ||
            this->IsTooLarge(shape.squaredRadius, Geometry::ComputeSquaredShortestEdge(point, a, b, c)))
        {
          return false;
        }
      }
    }
  }
  m_Change = badness - m_BadnessBefore;
  return true;
}

bool
DelaunayRefinementVertexTrial::AddFacets(IndexType                                      cell,
                                         const DelaunayRefinementArray<std::uint32_t> & marks,
                                         std::uint32_t                                  mark,
                                         FacetsType &                                   facets,
                                         bool                                           areNew) const
{
  const auto & own = m_Complex.GetTriangulation().GetCell(cell);
  for (unsigned int i = 0; i < 4; ++i)
  {
    if (marks[own.neighbors[i]] != mark)
    {
      const auto       facet = GetFacet(own.vertices, i);
      const RegionType region = m_Complex.GetRegion(cell);
      const RegionType beyond = m_Complex.GetRegion(own.neighbors[i]);
      if (areNew && region != beyond && !this->MayPartRegions(facet))
      {
        return false;
      }
      facets.Add(facet, region, beyond);
    }
  }
  return true;
}

bool
DelaunayRefinementVertexTrial::KeepsBoundary(const PointType & point)
{
  const IndexType vertex = m_Vertex == None ? NewVertex : m_Vertex;
  m_FacetsAfter.Clear();
  m_Edges.clear();
  for (std::uint32_t i = 0; i < m_Star.boundary.size(); ++i)
  {
    const auto       facet = GetFacet(m_Star.boundary[i].vertices, m_Star.boundary[i].slot);
    const RegionType beyond = m_Complex.GetRegion(m_Star.boundary[i].beyond);
    if (beyond != m_Shapes[i].region && !this->MayPartRegions(facet))
    {
      return false;
    }
    m_FacetsAfter.Add(facet, m_Shapes[i].region, beyond);
    for (unsigned int j = 0; j < 3; ++j)
    {
      const auto ends = std::minmax(facet[j], facet[(j + 1) % 3]);
      m_Edges.push_back({ { ends.first, ends.second }, i });
    }
  }
  std::sort(m_Edges.begin(), m_Edges.end(), [](const EdgeType & a, const EdgeType & b) { return a.ends < b.ends; });
  for (std::size_t i = 0; i + 1 < m_Edges.size(); i += 2)
  {
    const auto &     ends = m_Edges[i].ends;
    const RegionType one = m_Shapes[m_Edges[i].shape].region;
    const RegionType other = m_Shapes[m_Edges[i + 1].shape].region;
    if (one != other && !this->MayPartRegions(point, ends[0], ends[1]))
    {
      return false;
    }
    m_FacetsAfter.Add({ vertex, ends[0], ends[1] }, one, other);
  }
  m_FacetsBefore = m_StarFacets;
  for (const IndexType cell : m_Star.cavity)
  {
    if (m_HoleMarks[cell] != m_HoleMark)
    {
      this->AddFacets(cell, m_HoleMarks, m_HoleMark, m_FacetsBefore, false);
    }
  }
  for (const auto & [cell, generation] : m_Hole)
  {
    if (m_CavityMarks[cell] != m_CavityMark && !this->AddFacets(cell, m_CavityMarks, m_CavityMark, m_FacetsAfter, true))
    {
      return false;
    }
  }
  return m_Topology.AreEqual(m_FacetsBefore, m_FacetsAfter, vertex, m_Vertex == None);
}

bool
DelaunayRefinementVertexTrial::IsHarmless(VertexKind kind)
{
  if (kind == VertexKind::FREE && m_Vertex == None)
  {
    // All cells are in one region, as they were, and small enough; dual edges of facets beside them became shorter.
    return std::none_of(m_Cells.begin(), m_Cells.end(), [this](IndexType cell) { return m_Rules.FiresR2(cell); });
  }
  return !this->FiresAny() && (kind == VertexKind::FREE || this->IsManifoldWhereAsked());
}

bool
DelaunayRefinementVertexTrial::FiresAny()
{
  m_Given.clear();
  const auto giveBack = [this](IndexType cell) {
    if (m_Repair.IsChanged(cell))
    {
      m_Given.emplace_back(cell, m_Complex.GetRegion(cell));
      m_Complex.SetRegion(cell, m_Repair.GetOwnRegion(cell));
    }
  };
  for (const IndexType cell : m_Cells)
  {
    giveBack(cell);
    const auto & neighbors = m_Complex.GetTriangulation().GetCell(cell).neighbors;
    std::for_each(neighbors.begin(), neighbors.end(), giveBack);
  }
  const bool fires =
    std::any_of(m_Cells.begin(), m_Cells.end(), [this](IndexType cell) { return m_Rules.Fires(cell); });
  // Cells may be there more than once.
  for (auto given = m_Given.rbegin(); given != m_Given.rend(); ++given)
  {
    m_Complex.SetRegion(given->first, given->second);
  }
  return fires;
}

bool
DelaunayRefinementVertexTrial::IsManifoldWhereAsked()
{
  const auto & vertices = m_Topology.GetVerticesToAsk();
  return std::all_of(vertices.begin(), vertices.end(), [this](IndexType vertex) {
    m_VertexStar.Find(m_Complex, vertex);
    return m_VertexStar.CountBadPlaces() == 0;
  });
}

DelaunayRefinementVertexTrial::IndexType
DelaunayRefinementVertexTrial::Insert(const PointType & point, VertexKind kind, double delta, IndexType hint)
{
  const IndexType vertex = m_Complex.Insert(point, kind, delta, hint);
  m_Cells.assign(m_Complex.GetNewCells().begin(), m_Complex.GetNewCells().end());
  if (this->IsHarmless(kind))
  {
    return vertex;
  }
  m_Complex.Remove(vertex);
  m_Cells.assign(m_Complex.GetNewCells().begin(), m_Complex.GetNewCells().end());
  return None;
}

bool
DelaunayRefinementVertexTrial::TakeOut(IndexType vertex, bool keepRegions)
{
  this->CloseHole();
  m_Vertex = vertex;
  m_OldPoint = m_Complex.GetPoint(vertex);
  m_OldDelta = m_Complex.GetDelta(vertex);
  const VertexKind kind = m_Complex.GetKind(vertex);
  if ((kind != VertexKind::FREE && kind != VertexKind::FEATURE) || !this->DescribeStar(keepRegions))
  {
    return false;
  }
  this->OpenHole();
  return true;
}

bool
DelaunayRefinementVertexTrial::DescribeStar(bool keepRegions)
{
  const auto & triangulation = m_Complex.GetTriangulation();
  m_VertexStar.Find(m_Complex, m_Vertex);
  double squaredShortest = std::numeric_limits<double>::infinity();
  double squaredNearest = std::numeric_limits<double>::infinity();
  m_Normal = {};
  m_Region = m_VertexStar.GetRegions().front();
  RegionType other = m_Region;
  for (const auto & cellOfStar : m_VertexStar.GetCells())
  {
    const IndexType  cell = cellOfStar.index;
    const auto &     own = triangulation.GetCell(cell);
    const RegionType region = m_Complex.GetRegion(cell);
    other = region != m_Region && m_IsUniform ? region : other;
    if (region != m_Region && region != other)
    {
      // Junctions stay where they are.
      return false;
    }
    m_IsUniform = m_IsUniform && region == m_Region;
    m_StarBadness += this->ComputeBadness(cell);
    for (unsigned int i = 0; i < 4; ++i)
    {
      const auto       facet = GetFacet(own.vertices, i);
      const RegionType beyond = m_Complex.GetRegion(own.neighbors[i]);
      m_StarFacets.Add(facet, region, beyond);
      if (own.vertices[i] == m_Vertex)
      {
        if (keepRegions || m_Repair.IsChanged(cell))
        {
          m_KeptRegions.emplace_back(facet, region);
          std::sort(m_KeptRegions.back().first.begin(), m_KeptRegions.back().first.end());
        }
        continue;
      }
      const double squared = Geometry::SquaredDistance(m_OldPoint, m_Complex.GetPoint(own.vertices[i]));
      squaredShortest = std::min(squaredShortest, squared);
      squaredNearest = m_Complex.IsFeature(own.vertices[i]) ? std::min(squaredNearest, squared) : squaredNearest;
      if (region > beyond)
      {
        const PointType & a = m_Complex.GetPoint(facet[0]);
        m_Normal = Geometry::AddScaled(m_Normal,
                                       1.0,
                                       Geometry::Cross(Geometry::Subtract(m_Complex.GetPoint(facet[1]), a),
                                                       Geometry::Subtract(m_Complex.GetPoint(facet[2]), a)));
      }
    }
  }
  const double area = std::sqrt(Geometry::Dot(m_Normal, m_Normal));
  m_Normal = area > 0.0 ? PointType{ m_Normal[0] / area, m_Normal[1] / area, m_Normal[2] / area } : PointType{};
  m_ShortestEdge = std::sqrt(squaredShortest);
  m_NearestFeature = std::sqrt(squaredNearest);
  // Vertices of tetrahedra outside alone are nobody's business.
  return !m_IsUniform || m_Region != 0;
}

void
DelaunayRefinementVertexTrial::OpenHole()
{
  if (m_Repair.GetNumberOfChanges() > 0)
  {
    m_VertexStar.Find(m_Complex, m_Vertex);
    for (const auto & cell : m_VertexStar.GetCells())
    {
      m_Repair.Forget(cell.index);
    }
  }
  m_Complex.Remove(m_Vertex);
  const auto & triangulation = m_Complex.GetTriangulation();
  m_HoleMarks.resize(triangulation.GetNumberOfCellIndexes(), 0);
  ++m_HoleMark;
  m_Hole.clear();
  m_HoleBadness = 0.0;
  m_NumberOfTooLarge = 0;
  for (const IndexType cell : m_Complex.GetNewCells())
  {
    m_Hole.emplace_back(cell, triangulation.GetGeneration(cell));
    m_HoleMarks[cell] = m_HoleMark;
    m_HoleBadness += this->ComputeBadness(cell);
    m_NumberOfTooLarge += this->IsTooLarge(cell) ? 1 : 0;
    m_IsUniform = m_IsUniform && m_Complex.GetRegion(cell) == m_Region;
  }
}

DelaunayRefinementVertexTrial::RegionType
DelaunayRefinementVertexTrial::FindKeptRegion(FacetVerticesType others, RegionType own) const
{
  if (m_KeptRegions.empty())
  {
    return own;
  }
  std::sort(others.begin(), others.end());
  const auto found =
    std::find_if(m_KeptRegions.begin(), m_KeptRegions.end(), [&](const auto & kept) { return kept.first == others; });
  return found == m_KeptRegions.end() ? own : found->second;
}

void
DelaunayRefinementVertexTrial::RestoreRegions()
{
  for (const IndexType cell : m_Complex.GetNewCells())
  {
    const auto &     vertices = m_Complex.GetTriangulation().GetCell(cell).vertices;
    const auto       slot = std::find(vertices.begin(), vertices.end(), m_Vertex) - vertices.begin();
    const RegionType own = m_Complex.GetRegion(cell);
    const RegionType kept = this->FindKeptRegion(GetFacet(vertices, static_cast<unsigned int>(slot)), own);
    if (kept != own)
    {
      m_Repair.Give(cell, kept);
    }
  }
}

bool
DelaunayRefinementVertexTrial::Put(const PointType & point, double delta)
{
  // The topology is asked again, as other places were asked for since; it lists what to look at.
  if (!this->MayPut(point, 0.0) || !m_Complex.Reinsert(m_Vertex, point, delta, m_Hole.front().first))
  {
    return false;
  }
  this->RestoreRegions();
  m_Cells.assign(m_Complex.GetNewCells().begin(), m_Complex.GetNewCells().end());
  for (const auto & [cell, generation] : m_Hole)
  {
    if (m_Complex.GetTriangulation().GetGeneration(cell) == generation)
    {
      m_Cells.push_back(cell);
    }
  }
  if (this->IsHarmless(m_Complex.GetKind(m_Vertex)))
  {
    return true;
  }
  this->OpenHole();
  return false;
}

void
DelaunayRefinementVertexTrial::PutBack()
{
  m_Complex.Reinsert(m_Vertex, m_OldPoint, m_OldDelta, m_Hole.front().first);
  this->RestoreRegions();
  m_Cells.assign(m_Complex.GetNewCells().begin(), m_Complex.GetNewCells().end());
}

bool
DelaunayRefinementVertexTrial::GiveAway(IndexType cell)
{
  const auto &     own = m_Complex.GetTriangulation().GetCell(cell);
  const RegionType region = m_Complex.GetRegion(cell);
  bool             mayPart = true;
  m_FacetsBefore.Clear();
  m_FacetsAfter.Clear();
  for (unsigned int i = 0; i < 4; ++i)
  {
    const auto       facet = GetFacet(own.vertices, i);
    const RegionType beyond = m_Complex.GetRegion(own.neighbors[i]);
    m_FacetsBefore.Add(facet, region, beyond);
    m_FacetsAfter.Add(facet, 0, beyond);
    mayPart = mayPart && (beyond == 0 || this->MayPartRegions(facet));
  }
  if (!mayPart || !m_Topology.AreEqual(m_FacetsBefore, m_FacetsAfter, NewVertex, false))
  {
    return false;
  }
  m_Repair.Give(cell, 0);
  if (!this->IsManifoldWhereAsked())
  {
    m_Repair.Give(cell, region);
    return false;
  }
  return true;
}
} // end namespace itk
