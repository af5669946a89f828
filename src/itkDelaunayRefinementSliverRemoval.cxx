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
#include "itkDelaunayRefinementSliverRemoval.h"

#include <algorithm>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** New free vertices keep this share of delta to others, vertices that were moved this one, or what they had. */
constexpr double NewFreeSpacing = 0.5;
constexpr double FreeSpacing = 0.25;

/** The same for feature vertices among each other, where nothing else helps and where they were moved. */
constexpr double NewFeatureSpacing = 0.25;
constexpr double FeatureSpacing = 0.8;

/** Points around the circumcenter, and how far from it as a share of the radius. */
constexpr unsigned int NumberOfFreePoints = 3;
constexpr double       FreeReach = 0.4;
constexpr unsigned int NumberOfFeaturePoints = 50;
constexpr unsigned int NumberOfFeatureReaches = 10;

/** Steps of vertices, as shares of their shortest edge. */
constexpr double LeastStep = 0.05;
constexpr double GreatestStep = 0.4;

/** Steps tried for a vertex, at last, and the best places to go to. */
constexpr unsigned int NumberOfSteps = 12;
constexpr unsigned int NumberOfLastSteps = 200;
constexpr unsigned int MostPlaces = 3;

constexpr unsigned int NumberOfInsertionPasses = 2;
constexpr unsigned int MostPasses = 60;

/** A pass is idle if it helps fewer slivers than this share; so many idle ones come before the last things are tried,
 * for so many slivers at most: the bound is out of reach if there are more. */
constexpr double       LeastShare = 0.05;
constexpr unsigned int MostIdlePasses = 2;
constexpr std::size_t  MostLastSlivers = 500;

constexpr std::size_t TriesBetweenQuestions = 64;
constexpr std::size_t CellsPerPiece = 4096;
} // namespace

DelaunayRefinementSliverRemoval::DelaunayRefinementSliverRemoval(const DelaunayRefinementParameters & parameters,
                                                                 const DelaunayRefinementOracle &     oracle,
                                                                 const DelaunayRefinementLocalDelta & localDelta,
                                                                 const DelaunayRefinementRules &      rules,
                                                                 DelaunayRefinementManifoldRepair &   repair,
                                                                 DelaunayRefinementSurfaceSample &    sample,
                                                                 DelaunayRefinementComplex &          complex,
                                                                 DelaunayRefinementThreads &          threads)
  : m_Parameters(parameters)
  , m_Oracle(oracle)
  , m_LocalDelta(localDelta)
  , m_Sample(sample)
  , m_Complex(complex)
  , m_Threads(threads)
  , m_Trial(parameters, oracle, rules, repair, complex)
{}

std::vector<DelaunayRefinementSliverRemoval::IndexType>
DelaunayRefinementSliverRemoval::FindSlivers() const
{
  const auto &                        triangulation = m_Complex.GetTriangulation();
  const std::size_t                   size = triangulation.GetNumberOfCellIndexes();
  std::vector<std::vector<IndexType>> found(DelaunayRefinementThreads::CountPieces(size, CellsPerPiece));
  const auto                          visitPiece = [&](std::size_t piece, std::size_t begin, std::size_t end) {
    for (auto cell = static_cast<IndexType>(begin); cell < end; ++cell)
    {
      if (triangulation.IsAlive(cell) && m_Trial.ComputeBadness(cell) > 0.0)
      {
        found[piece].push_back(cell);
      }
    }
  };
  DelaunayRefinementThreads::RunPieces(&m_Threads, size, CellsPerPiece, visitPiece);
  std::vector<IndexType> slivers;
  for (const auto & some : found)
  {
    slivers.insert(slivers.end(), some.begin(), some.end());
  }
  return slivers;
}

bool
DelaunayRefinementSliverRemoval::Run(const std::function<bool()> & keepGoing)
{
  std::vector<SliverType> slivers;
  for (const IndexType cell : this->FindSlivers())
  {
    slivers.push_back({ cell, m_Complex.GetTriangulation().GetGeneration(cell) });
  }
  std::size_t  numberOfTries = 0;
  unsigned int numberOfIdlePasses = 0;
  bool         isChanged = false;
  for (unsigned int i = 0; i < MostPasses && numberOfIdlePasses <= MostIdlePasses && !slivers.empty(); ++i)
  {
    const PassEnum pass = i < NumberOfInsertionPasses            ? PassEnum::INSERT
                          : numberOfIdlePasses == MostIdlePasses ? PassEnum::LAST
                                                                 : PassEnum::MOVE;
    if (pass == PassEnum::LAST && slivers.size() > MostLastSlivers)
    {
      break;
    }
    std::size_t numberOfChanges = 0;
    m_Next.clear();
    for (const SliverType & sliver : slivers)
    {
      if ((pass == PassEnum::LAST || ++numberOfTries % TriesBetweenQuestions == 0) && !keepGoing())
      {
        return isChanged;
      }
      if (!this->IsThere(sliver))
      {
        continue;
      }
      if (this->Mend(pass, sliver))
      {
        isChanged = true;
        ++numberOfChanges;
      }
      else if (this->IsThere(sliver))
      {
        m_Next.push_back(sliver);
      }
    }
    const bool isIdle = pass != PassEnum::INSERT &&
                        static_cast<double>(numberOfChanges) <= LeastShare * static_cast<double>(slivers.size());
    numberOfIdlePasses = isIdle ? numberOfIdlePasses + 1 : 0;
    std::swap(slivers, m_Next);
  }
  m_NumberOfLeft = slivers.size();
  return isChanged;
}

std::vector<DelaunayRefinementPoint>
DelaunayRefinementSliverRemoval::Cover(const std::vector<PointType> & points)
{
  std::vector<PointType> left;
  IndexType              hint = m_Complex.GetTriangulation().GetCellOfVertex(1);
  for (const PointType & point : points)
  {
    if (m_Complex.GetNumberOfVertices() < m_Parameters.maximumNumberOfVertices &&
        m_Trial.MayInsertFeature(point, hint) &&
        m_Trial.Insert(point, VertexKind::FEATURE, m_LocalDelta.GetAt(point), hint) != DelaunayRefinementComplex::None)
    {
      hint = m_Complex.GetNewCells().front();
    }
    else
    {
      left.push_back(point);
      hint = m_Complex.GetTriangulation().GetCellOfVertex(1);
    }
  }
  return left;
}

bool
DelaunayRefinementSliverRemoval::Mend(PassEnum pass, const SliverType & sliver)
{
  switch (pass)
  {
    case PassEnum::INSERT:
      return this->InsertFree(sliver.cell);
    case PassEnum::MOVE:
      return this->Move(sliver.cell, pass);
    case PassEnum::LAST:
      break;
  }
  // What fails may have put another tetrahedron in its place.
  return m_Trial.GiveAway(sliver.cell) || this->InsertFeature(sliver.cell) ||
         (this->IsThere(sliver) && this->Move(sliver.cell, pass));
}

bool
DelaunayRefinementSliverRemoval::InsertFree(IndexType cell)
{
  const auto      generation = m_Complex.GetTriangulation().GetGeneration(cell);
  const PointType center = m_Complex.GetCircumcenter(cell);
  const double    reach = FreeReach * std::sqrt(m_Complex.GetSquaredRadius(cell));
  for (unsigned int i = 0; i < NumberOfFreePoints && this->IsThere({ cell, generation }); ++i)
  {
    const PointType point = m_Complex.Round(i == 0 ? center : this->MoveAtRandom(center, reach));
    if (m_Oracle.Classify(point) == m_Complex.GetRegion(cell) &&
        this->Insert(point, VertexKind::FREE, 0.0, NewFreeSpacing * this->GetFreeLength(point), cell))
    {
      return true;
    }
  }
  return false;
}

bool
DelaunayRefinementSliverRemoval::InsertFeature(IndexType cell)
{
  const PointType center = m_Complex.GetCircumcenter(cell);
  const double    radius = std::sqrt(m_Complex.GetSquaredRadius(cell));
  const auto      generation = m_Complex.GetTriangulation().GetGeneration(cell);
  for (unsigned int i = 0; i < NumberOfFeaturePoints && this->IsThere({ cell, generation }); ++i)
  {
    const double    reach = static_cast<double>(i % NumberOfFeatureReaches) / NumberOfFeatureReaches;
    const PointType from = this->MoveAtRandom(center, reach * radius);
    PointType       closest;
    if (!m_Oracle.FindClosestSurfacePoint(from, radius, closest))
    {
      continue;
    }
    const PointType point = m_Complex.Round(closest);
    const double    delta = m_LocalDelta.GetAt(point);
    if (this->Insert(point, VertexKind::FEATURE, delta, NewFeatureSpacing * delta, cell))
    {
      m_Sample.Add(point);
      return true;
    }
  }
  return false;
}

bool
DelaunayRefinementSliverRemoval::Insert(const PointType & point,
                                        VertexKind        kind,
                                        double            delta,
                                        double            spacing,
                                        IndexType         cell)
{
  if (m_Complex.GetNumberOfVertices() >= m_Parameters.maximumNumberOfVertices ||
      !m_Trial.MayInsert(point, kind, cell, spacing))
  {
    return false;
  }
  const bool isInserted = m_Trial.Insert(point, kind, delta, cell) != DelaunayRefinementComplex::None;
  m_NumberOfInsertions += isInserted ? 1 : 0;
  this->QueueSlivers();
  return isInserted;
}

bool
DelaunayRefinementSliverRemoval::Move(IndexType cell, PassEnum pass)
{
  // Free vertices first: moving them changes no boundary.
  std::array<IndexType, 4> vertices = m_Complex.GetTriangulation().GetCell(cell).vertices;
  std::stable_partition(vertices.begin(), vertices.end(), [this](IndexType vertex) {
    return m_Complex.GetKind(vertex) == VertexKind::FREE;
  });
  return std::any_of(
    vertices.begin(), vertices.end(), [&](IndexType vertex) { return this->MoveVertex(vertex, pass); });
}

bool
DelaunayRefinementSliverRemoval::MoveVertex(IndexType vertex, PassEnum pass)
{
  const PointType old = m_Complex.GetPoint(vertex);
  const bool      isFeature = m_Complex.IsFeature(vertex);
  if (!m_Trial.TakeOut(vertex, pass == PassEnum::LAST))
  {
    return false;
  }
  m_Places.clear();
  const unsigned int numberOfSteps = pass == PassEnum::LAST ? NumberOfLastSteps : NumberOfSteps;
  for (unsigned int i = 0; i < numberOfSteps; ++i)
  {
    const double share = static_cast<double>(i % NumberOfSteps) / (NumberOfSteps - 1);
    const double step = (LeastStep + (GreatestStep - LeastStep) * share) * m_Trial.GetShortestEdge();
    PointType    place;
    double       spacing;
    if (this->ProposePlace(vertex, old, step, place, spacing) && m_Trial.MayPut(place, spacing))
    {
      m_Places.push_back({ place, m_Trial.GetChange() });
      if (m_Trial.WouldMendAll())
      {
        break;
      }
    }
  }
  std::stable_sort(
    m_Places.begin(), m_Places.end(), [](const PlaceType & a, const PlaceType & b) { return a.change < b.change; });
  for (std::size_t i = 0; i < m_Places.size() && i < MostPlaces; ++i)
  {
    const PointType place = m_Places[i].point;
    if (m_Trial.Put(place, isFeature ? m_LocalDelta.GetAt(place) : m_Complex.GetDelta(vertex)))
    {
      if (isFeature)
      {
        m_Sample.Forget(old);
        m_Sample.Add(place);
      }
      ++m_NumberOfMoves;
      this->QueueSlivers();
      return true;
    }
  }
  m_Trial.PutBack();
  this->QueueSlivers();
  return false;
}

bool
DelaunayRefinementSliverRemoval::ProposePlace(IndexType         vertex,
                                              const PointType & old,
                                              double            step,
                                              PointType &       place,
                                              double &          spacing)
{
  place = this->MoveAtRandom(old, step);
  if (!m_Complex.IsFeature(vertex))
  {
    place = m_Complex.Round(place);
    spacing = std::min(FreeSpacing * this->GetFreeLength(place), m_Trial.GetShortestEdge());
    return true;
  }
  // Along the surface: where the normal that passes the place meets it. Clefts that the mesh closes have none.
  const PointType & normal = m_Trial.GetNormal();
  const PointType   offset = Geometry::Subtract(place, old);
  const PointType   tangent = Geometry::AddScaled(offset, -Geometry::Dot(offset, normal), normal);
  const double      length = std::sqrt(Geometry::Dot(tangent, tangent));
  const PointType   middle = Geometry::AddScaled(old, length > 0.0 ? step / length : 0.0, tangent);
  const bool        isFound = normal == PointType{} ? m_Oracle.FindClosestSurfacePoint(middle, step, place)
                                                    : m_Oracle.FindFirstCrossing(Geometry::AddScaled(middle, step, normal),
                                                                          Geometry::AddScaled(middle, -step, normal),
                                                                          place);
  if (!isFound)
  {
    return false;
  }
  place = m_Complex.Round(place);
  spacing = std::min(FeatureSpacing * m_LocalDelta.GetAt(place), m_Trial.GetNearestFeature());
  return true;
}

void
DelaunayRefinementSliverRemoval::QueueSlivers()
{
  for (const IndexType cell : m_Trial.GetCells())
  {
    if (m_Trial.ComputeBadness(cell) > 0.0)
    {
      m_Next.push_back({ cell, m_Complex.GetTriangulation().GetGeneration(cell) });
    }
  }
}

DelaunayRefinementPoint
DelaunayRefinementSliverRemoval::MoveAtRandom(const PointType & from, double distance)
{
  // A direction from the ball, so that all are as likely.
  PointType direction;
  double    squared = 0.0;
  while (!(squared <= 1.0 && squared > 0.01))
  {
    for (double & coordinate : direction)
    {
      coordinate = 2.0 * static_cast<double>(m_Random() >> 11) * 0x1p-53 - 1.0;
    }
    squared = Geometry::Dot(direction, direction);
  }
  return Geometry::AddScaled(from, distance / std::sqrt(squared), direction);
}
} // end namespace itk
