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
#include "itkDelaunayRefinementFidelity.h"

#include <algorithm>
#include <queue>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using PointType = DelaunayRefinementPoint;
using TriangleType = DelaunayRefinementTriangleGrid::TriangleType;

/** Points farther than this share of the bound are too far. */
constexpr double FarShare = 0.9;

/** Pieces with a radius below this share of the bound are asked for a point of their own. */
constexpr double SmallShare = 0.5;

/** Pieces with a radius below the first of these shares of the bound are split only where larger ones are too far in
 * next to no places, and so on. */
constexpr double SmallestShares[] = { 2.0, 1.0, 0.25, 0.0 };

/** So many places for each facet are next to none. */
constexpr double FewPlaces = 0.05;

/** Delta is lowered within this share of it around what is too far. */
constexpr double ReachShare = 0.5;

/** Delta counts as greater than the least one beyond this factor. */
constexpr double LeastDeltaMargin = 1.01;

/** Delta is lowered to this share of the bound at most. */
constexpr double LeastDeltaShare = 0.125;

constexpr std::size_t PiecesAtATime = 1024;

/** A piece of either surface, by how far it may be from the other at most: in a queue the farthest is next. */
template <typename TPiece>
struct PieceType
{
  double most;
  TPiece piece;

  bool
  operator<(const PieceType & other) const
  {
    return most < other.most;
  }
};

/** Around a triangle, its center the centroid. */
struct BallType
{
  PointType center;
  double    radius;
};

BallType
FindBall(const TriangleType & triangle)
{
  BallType ball{ {}, 0.0 };
  for (unsigned int i = 0; i < 3; ++i)
  {
    ball.center[i] = (triangle[0][i] + triangle[1][i] + triangle[2][i]) / 3.0;
  }
  for (const PointType & point : triangle)
  {
    ball.radius = std::max(ball.radius, Geometry::Distance(ball.center, point));
  }
  return ball;
}

/** No point of a triangle is farther from the nearest vertex: for acute ones that is the circumradius at most. */
double
GetReachOfVertices(const TriangleType & triangle)
{
  constexpr double ofLongest = 0.57735026918962577;
  return ofLongest * std::max({ Geometry::Distance(triangle[0], triangle[1]),
                                Geometry::Distance(triangle[1], triangle[2]),
                                Geometry::Distance(triangle[2], triangle[0]) });
}

std::array<TriangleType, 4>
Split(const TriangleType & triangle)
{
  const auto middle = [&](unsigned int i, unsigned int j) {
    return Geometry::AddScaled(triangle[i], 0.5, Geometry::Subtract(triangle[j], triangle[i]));
  };
  const PointType ab = middle(0, 1);
  const PointType bc = middle(1, 2);
  const PointType ca = middle(2, 0);
  return { TriangleType{ triangle[0], ab, ca },
           TriangleType{ ab, triangle[1], bc },
           TriangleType{ ca, bc, triangle[2] },
           TriangleType{ ab, bc, ca } };
}
} // namespace

DelaunayRefinementFidelity::DelaunayRefinementFidelity(const DelaunayRefinementOracle &     oracle,
                                                       const DelaunayRefinementParameters & parameters,
                                                       double                               bound,
                                                       const DelaunayRefinementComplex &    complex,
                                                       const DelaunayRefinementLocalDelta & localDelta,
                                                       DelaunayRefinementThreads &          threads)
  : m_Oracle(oracle)
  , m_Parameters(parameters)
  , m_Complex(complex)
  , m_LocalDelta(localDelta)
  , m_Threads(threads)
  , m_Bound(bound)
{
  const auto patches = oracle.GetSurfacePatches();
  m_Pieces.reserve(patches.GetSize());
  for (std::size_t i = 0; i < patches.GetSize(); ++i)
  {
    m_Pieces.push_back({ patches.Get(i), {} });
  }
}

DelaunayRefinementFidelity::BoundType
DelaunayRefinementFidelity::GetBound(double delta) const
{
  const BoundType bound{ m_Bound, LeastDeltaShare * m_Bound };
  if (!(delta > LeastDeltaMargin * m_Parameters.leastDelta))
  {
    return bound;
  }
  const double deviation = std::max(m_Parameters.deviationShare * delta, m_Parameters.leastDeviation);
  return deviation < m_Bound ? BoundType{ deviation, m_Parameters.leastDelta } : bound;
}

std::vector<DelaunayRefinementFidelity::PlaceType>
DelaunayRefinementFidelity::FindFarPlaces()
{
  std::vector<PlaceType> places;
  this->FindFacets();
  for (const double share : SmallestShares)
  {
    if (static_cast<double>(places.size()) <= FewPlaces * static_cast<double>(m_Facets.size()))
    {
      this->CertifySurface(share, places);
      this->CertifyFacets(share, places);
    }
  }
  return places;
}

bool
DelaunayRefinementFidelity::PartsRegions(const FacetType & facet) const
{
  const auto & triangulation = m_Complex.GetTriangulation();
  return facet.cell != DelaunayRefinementComplex::None && triangulation.GetGeneration(facet.cell) == facet.generation &&
         m_Complex.GetRegion(facet.cell) !=
           m_Complex.GetRegion(triangulation.GetCell(facet.cell).neighbors[facet.slot]);
}

DelaunayRefinementFidelity::TriangleType
DelaunayRefinementFidelity::GetTriangle(const FacetType & facet) const
{
  const auto & vertices = m_Complex.GetTriangulation().GetCell(facet.cell).vertices;
  return { m_Complex.GetPoint(vertices[(facet.slot + 1) & 3]),
           m_Complex.GetPoint(vertices[(facet.slot + 2) & 3]),
           m_Complex.GetPoint(vertices[(facet.slot + 3) & 3]) };
}

void
DelaunayRefinementFidelity::FindFacets()
{
  const auto &              triangulation = m_Complex.GetTriangulation();
  std::vector<TriangleType> triangles;
  m_Facets.clear();
  for (IndexType cell = 0; cell < triangulation.GetNumberOfCellIndexes(); ++cell)
  {
    const auto region = triangulation.IsAlive(cell) ? m_Complex.GetRegion(cell) : 0;
    for (std::uint32_t slot = 0; slot < 4 && region != 0; ++slot)
    {
      if (m_Complex.GetRegion(triangulation.GetCell(cell).neighbors[slot]) < region)
      {
        m_Facets.push_back({ cell, triangulation.GetGeneration(cell), slot });
        triangles.push_back(this->GetTriangle(m_Facets.back()));
      }
    }
  }
  m_Grid.Start(std::move(triangles));
}

void
DelaunayRefinementFidelity::CertifySurface(double smallest, std::vector<PlaceType> & places)
{
  using Threads = DelaunayRefinementThreads;
  std::vector<PartType> parts(Threads::CountPieces(m_Pieces.size(), PiecesAtATime));
  Threads::RunPieces(
    &m_Threads, m_Pieces.size(), PiecesAtATime, [&](std::size_t number, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (this->PartsRegions(m_Pieces[i].facet))
        {
          parts[number].pieces.push_back(m_Pieces[i]);
        }
        else if (parts[number].IsInLastPlace(m_Pieces[i].patch.center))
        {
          parts[number].pieces.push_back({ m_Pieces[i].patch, {} });
        }
        else
        {
          this->CertifyPatch(m_Pieces[i].patch, smallest, parts[number]);
        }
      }
    });
  m_Pieces.clear();
  for (const PartType & part : parts)
  {
    m_Pieces.insert(m_Pieces.end(), part.pieces.begin(), part.pieces.end());
    places.insert(places.end(), part.places.begin(), part.places.end());
  }
}

bool
DelaunayRefinementFidelity::CertifyPatch(const PatchType & patch, double smallest, PartType & part) const
{
  const BoundType bound = this->GetBound(m_LocalDelta.GetRange(patch).least);
  if (std::isinf(bound.distance))
  {
    part.pieces.push_back({ patch, {} });
    return true;
  }
  const double room = bound.distance - patch.radius;
  const double far = FarShare * bound.distance;
  const auto   near = m_Grid.Find(patch.center, room, bound.distance + patch.radius, part.nearest);
  if (near.number != DelaunayRefinementTriangleGrid::None)
  {
    part.nearest = near.number;
  }
  if (near.distance <= room)
  {
    part.pieces.push_back({ patch, m_Facets[near.number] });
    return true;
  }
  if (patch.radius < SmallShare * bound.distance || near.distance - patch.radius > far)
  {
    PointType point;
    if (!m_Oracle.FindPointOfPatch(patch.identifier, point))
    {
      return true;
    }
    if (m_Grid.Find(point, far, bound.distance, part.nearest).distance > far)
    {
      part.pieces.push_back({ patch, {} });
      part.places.push_back({ point, ReachShare * m_LocalDelta.GetAt(point), bound.leastDelta });
      return false;
    }
  }
  if (patch.radius < smallest * bound.distance)
  {
    part.pieces.push_back({ patch, {} });
    return true;
  }
  DelaunayRefinementSurfacePatches parts(patch.center);
  m_Oracle.SplitSurfacePatch(patch.identifier, parts);
  bool isNear = true;
  for (std::size_t i = 0; i < parts.GetSize(); ++i)
  {
    if (isNear)
    {
      isNear = this->CertifyPatch(parts.Get(i), smallest, part);
    }
    else
    {
      part.pieces.push_back({ parts.Get(i), {} });
    }
  }
  return isNear;
}

void
DelaunayRefinementFidelity::CertifyFacets(double smallest, std::vector<PlaceType> & places)
{
  using Threads = DelaunayRefinementThreads;
  m_CertifiedFacets.resize(4 * std::size_t{ m_Complex.GetTriangulation().GetNumberOfCellIndexes() }, 0);
  std::vector<std::vector<PlaceType>> found(Threads::CountPieces(m_Facets.size(), PiecesAtATime));
  Threads::RunPieces(
    &m_Threads, m_Facets.size(), PiecesAtATime, [&](std::size_t number, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const FacetType &    facet = m_Facets[i];
        const TriangleType & triangle = m_Grid.GetTriangles()[i];
        std::uint32_t &      certified = m_CertifiedFacets[4 * std::size_t{ facet.cell } + facet.slot];
        if (certified == facet.generation)
        {
          continue;
        }
        // Vertices are on the surface.
        const BallType   ball = FindBall(triangle);
        const BoundType  bound = this->GetBound(m_LocalDelta.GetAt(ball.center));
        PlaceType        place{ {}, 0.0, bound.leastDelta };
        const AnswerEnum answer = GetReachOfVertices(triangle) < bound.distance
                                    ? AnswerEnum::CERTIFIED
                                    : this->CertifyTriangle(triangle, bound.distance, smallest, place.center);
        if (answer == AnswerEnum::CERTIFIED)
        {
          certified = facet.generation;
        }
        else if (answer == AnswerEnum::TOO_FAR)
        {
          for (const PointType & vertex : triangle)
          {
            place.radius = std::max(place.radius, Geometry::Distance(vertex, place.center));
          }
          place.radius += ReachShare * m_LocalDelta.GetAt(place.center);
          found[number].push_back(place);
        }
      }
    });
  for (const auto & some : found)
  {
    places.insert(places.end(), some.begin(), some.end());
  }
}

DelaunayRefinementFidelity::AnswerEnum
DelaunayRefinementFidelity::CertifyTriangle(const TriangleType & triangle,
                                            double               bound,
                                            double               smallest,
                                            PointType &          place) const
{
  const BallType ball = FindBall(triangle);
  if (ball.radius < bound && m_Oracle.IsSurfaceWithin(ball.center, bound - ball.radius))
  {
    return AnswerEnum::CERTIFIED;
  }
  if (!m_Oracle.IsSurfaceWithin(ball.center, FarShare * bound))
  {
    place = ball.center;
    return AnswerEnum::TOO_FAR;
  }
  if (ball.radius < smallest * bound)
  {
    return AnswerEnum::OPEN;
  }
  AnswerEnum answer = AnswerEnum::CERTIFIED;
  for (const TriangleType & part : Split(triangle))
  {
    const AnswerEnum own = this->CertifyTriangle(part, bound, smallest, place);
    if (own == AnswerEnum::TOO_FAR)
    {
      return own;
    }
    answer = own == AnswerEnum::OPEN ? own : answer;
  }
  return answer;
}

DelaunayRefinementFidelity::DistanceType
DelaunayRefinementFidelity::MeasureFromFacets(double tolerance) const
{
  // Vertices are on the surface.
  std::priority_queue<PieceType<TriangleType>> queue;
  for (const TriangleType & triangle : m_Grid.GetTriangles())
  {
    queue.push({ GetReachOfVertices(triangle), triangle });
  }
  DistanceType greatest{ 0.0, {} };
  while (!queue.empty() && queue.top().most > greatest.distance + tolerance)
  {
    const auto     piece = queue.top();
    const BallType ball = FindBall(piece.piece);
    const double   enough = greatest.distance + tolerance - ball.radius;
    queue.pop();
    if (enough > 0.0 && m_Oracle.IsSurfaceWithin(ball.center, enough))
    {
      continue;
    }
    double most = piece.most;
    if (ball.radius <= tolerance)
    {
      // Well enough known by some questions: the closest point would take far longer.
      double low = std::max(enough, 0.0);
      double high = piece.most;
      while (high - low > 0.25 * tolerance)
      {
        const double middle = 0.5 * (low + high);
        (m_Oracle.IsSurfaceWithin(ball.center, middle) ? high : low) = middle;
      }
      if (low > greatest.distance)
      {
        greatest = { low, ball.center };
      }
      most = std::min(most, high + ball.radius);
    }
    for (const TriangleType & part : Split(piece.piece))
    {
      queue.push({ most, part });
    }
  }
  return greatest;
}

DelaunayRefinementFidelity::DistanceType
DelaunayRefinementFidelity::MeasureFromSurface(double tolerance) const
{
  DistanceType                              greatest{ 0.0, {} };
  std::priority_queue<PieceType<PatchType>> queue;
  const auto                                push = [&](const PatchType & patch) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double     enough = greatest.distance + tolerance - patch.radius;
    const double     distance = m_Grid.Find(patch.center, enough, infinity).distance;
    PointType        point;
    if (distance <= enough || !m_Oracle.FindPointOfPatch(patch.identifier, point))
    {
      return;
    }
    const double own = m_Grid.Find(point, greatest.distance, infinity).distance;
    if (own > greatest.distance)
    {
      greatest = { own, point };
    }
    queue.push({ distance + patch.radius, patch });
  };
  for (const CertifiedType & piece : m_Pieces)
  {
    push(piece.patch);
  }
  while (!queue.empty() && queue.top().most > greatest.distance + tolerance)
  {
    const PatchType patch = queue.top().piece;
    queue.pop();
    DelaunayRefinementSurfacePatches parts(patch.center);
    m_Oracle.SplitSurfacePatch(patch.identifier, parts);
    for (std::size_t i = 0; i < parts.GetSize(); ++i)
    {
      push(parts.Get(i));
    }
  }
  return greatest;
}
} // end namespace itk
