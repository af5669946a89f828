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
#include "itkDelaunayRefinementRules.h"

#include <algorithm>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** Squared bounds are lowered by this factor, so that another formula for the same quantity agrees. */
constexpr double SquaredMargin = 1.0 - 2e-9;

/** No rule without a proof of its own makes edges shorter than this share of delta. */
constexpr double ShortestShare = 0.25;

/** No surface ball has a radius above this share of the largest delta, once R1 is done, with room for vertices that
 * were moved by a little. */
constexpr double LargestBallShare = 1.01;
} // namespace

DelaunayRefinementRules::DelaunayRefinementRules(const DelaunayRefinementOracle &        oracle,
                                                 const DelaunayRefinementParameters &    parameters,
                                                 const DelaunayRefinementComplex &       complex,
                                                 const DelaunayRefinementLocalDelta &    localDelta,
                                                 const DelaunayRefinementSurfaceSample & sample)
  : m_Oracle(oracle)
  , m_Parameters(parameters)
  , m_Complex(complex)
  , m_LocalDelta(localDelta)
  , m_Sample(sample)
  , m_LargestDihedralCosine(std::cos(parameters.minimumDihedralAngle * Geometry::RadiansPerDegree))
{
  if (oracle.KnowsAllSurface())
  {
    const double largestBall = LargestBallShare * localDelta.GetMaximum();
    m_SquaredLargestBall = largestBall * largestBall;
  }
}

void
DelaunayRefinementRules::Examine(IndexType cell, unsigned int facets, std::vector<FindingType> & findings) const
{
  if (m_Complex.GetTriangulation().IsInfinite(cell))
  {
    return;
  }
  const auto find = [&](RuleGroupEnum which, unsigned int facet) {
    const std::uint32_t generation = m_Complex.GetTriangulation().GetGeneration(cell);
    findings.push_back({ which, { cell, generation, facet }, m_Complex.FindBlock(cell) });
  };
  if (this->MayFireR2(cell))
  {
    // The object is in the box.
    const bool isInBox =
      m_Complex.GetRegion(cell) != 0 || m_Complex.IsStrictlyInsideBox(m_Complex.GetCircumcenter(cell));
    find(isInBox ? RuleGroupEnum::R2 : RuleGroupEnum::ENCROACHMENT, 0);
  }
  if (this->FiresR4(cell) || this->FiresCellSize(cell) || this->FiresR4Prime(cell))
  {
    find(RuleGroupEnum::R4, 0);
  }
  for (unsigned int i = 0; i < 4; ++i)
  {
    PointType center;
    if ((facets >> i & 1u) && this->IsBetweenRegions(cell, i) && this->FiresR3(cell, i, center))
    {
      find(RuleGroupEnum::R3, i);
    }
  }
}

bool
DelaunayRefinementRules::Fires(IndexType cell) const
{
  if (m_Complex.GetTriangulation().IsInfinite(cell))
  {
    return false;
  }
  bool fires = this->FiresR4(cell) || this->FiresCellSize(cell) || this->FiresR4Prime(cell) || this->FiresR2(cell);
  for (unsigned int i = 0; i < 4 && !fires; ++i)
  {
    PointType center;
    fires = this->FiresR3(cell, i, center);
  }
  return fires;
}

double
DelaunayRefinementRules::GetDeltaOfFeatures(const std::array<IndexType, 4> & vertices, unsigned int leftOut) const
{
  double delta = 0.0;
  for (unsigned int i = 0; i < 4; ++i)
  {
    if (i != leftOut && m_Complex.IsFeature(vertices[i]))
    {
      delta = std::max(delta, m_Complex.GetDelta(vertices[i]));
    }
  }
  return delta > 0.0 ? delta : m_LocalDelta.GetMaximum();
}

bool
DelaunayRefinementRules::HasFeatureVertex(IndexType cell) const
{
  const auto & vertices = m_Complex.GetTriangulation().GetCell(cell).vertices;
  return std::any_of(
    vertices.begin(), vertices.end(), [this](IndexType vertex) { return m_Complex.IsFeature(vertex); });
}

bool
DelaunayRefinementRules::MayFireR2(IndexType cell) const
{
  const double delta = m_LocalDelta.GetMaximum();
  return m_Complex.GetSquaredRadius(cell) >= 4.0 * delta * delta * SquaredMargin &&
         (m_Parameters.refineOutside || (m_Complex.GetRegion(cell) != 0 && this->HasFeatureVertex(cell)));
}

bool
DelaunayRefinementRules::FiresR2(IndexType cell) const
{
  if (!this->MayFireR2(cell))
  {
    return false;
  }
  if (this->HasFeatureVertex(cell))
  {
    return true;
  }
  const auto   ball = m_Complex.GetBall(cell);
  const double radius = std::sqrt(ball.squaredRadius);
  return m_Sample.MayHaveSurfaceWithin(ball.center, radius) && m_Oracle.IsSurfaceWithin(ball.center, radius);
}

double
DelaunayRefinementRules::ComputeSquaredR3Threshold(IndexType cell, unsigned int i) const
{
  const auto & vertices = m_Complex.GetTriangulation().GetCell(cell).vertices;
  const auto   a = vertices[(i + 1) & 3];
  const auto   b = vertices[(i + 2) & 3];
  const auto   c = vertices[(i + 3) & 3];
  const double squaredEdge = std::min({ Geometry::SquaredDistance(m_Complex.GetPoint(a), m_Complex.GetPoint(b)),
                                        Geometry::SquaredDistance(m_Complex.GetPoint(b), m_Complex.GetPoint(c)),
                                        Geometry::SquaredDistance(m_Complex.GetPoint(c), m_Complex.GetPoint(a)) });
  const bool   isOnSurface = m_Complex.IsFeature(a) && m_Complex.IsFeature(b) && m_Complex.IsFeature(c);
  const bool   isMixed = m_Parameters.radiusEdgeRatioBound >= 2.0 && !isOnSurface;
  if (!isMixed && squaredEdge > m_SquaredLargestBall)
  {
    return std::numeric_limits<double>::infinity();
  }
  const double delta = this->GetDeltaOfFeatures(vertices, i);
  const double squaredThreshold = std::min(delta * delta, squaredEdge) * SquaredMargin;
  const double shortest = ShortestShare * std::min(delta, m_Parameters.cellSize);
  return isMixed ? std::min(squaredThreshold, shortest * shortest) : squaredThreshold;
}

bool
DelaunayRefinementRules::FiresR3(IndexType cell, unsigned int i, PointType & center) const
{
  const auto &    triangulation = m_Complex.GetTriangulation();
  const IndexType neighbor = triangulation.GetCell(cell).neighbors[i];
  if (!this->IsBetweenRegions(cell, i) || triangulation.IsInfinite(cell))
  {
    return false;
  }
  // The neighbor last: it may be anywhere in memory.
  const double squaredThreshold = this->ComputeSquaredR3Threshold(cell, i);
  if (!std::isfinite(squaredThreshold) || triangulation.IsInfinite(neighbor) ||
      std::max(m_Complex.GetSquaredRadius(cell), m_Complex.GetSquaredRadius(neighbor)) < squaredThreshold)
  {
    return false;
  }

  // Along the dual edge the squared distance to the facet's vertices is a parabola: s^2 |d|^2 + 2 s (d . w) + |w|^2.
  const PointType from = m_Complex.GetCircumcenter(cell);
  const PointType to = m_Complex.GetCircumcenter(neighbor);
  const PointType vertex = m_Complex.GetPoint(triangulation.GetCell(cell).vertices[(i + 1) & 3]);
  const PointType direction = Geometry::Subtract(to, from);
  const PointType w = Geometry::Subtract(from, vertex);
  const double    squaredLength = Geometry::Dot(direction, direction);
  if (!(squaredLength > 0.0))
  {
    return false;
  }
  const double lowest = -Geometry::Dot(direction, w) / squaredLength;
  const double squaredAtLowest = Geometry::Dot(w, w) - lowest * lowest * squaredLength;
  const double room = squaredThreshold - squaredAtLowest;

  if (!(room > 0.0))
  {
    // All surface balls are large enough, and as the regions differ there is one.
    this->FindCrossing(from, to, center);
    return true;
  }
  // Only the parts of the dual edge with radii of at least the threshold matter, from both ends inwards, and no farther
  // from vertices than R1 leaves surface.
  const double half = std::sqrt(room / squaredLength);
  const double reach = std::sqrt(std::max(0.0, m_SquaredLargestBall - squaredAtLowest) / squaredLength);
  const double ends[2] = { std::clamp(lowest - half, 0.0, 1.0), std::clamp(lowest + half, 0.0, 1.0) };
  const double starts[2] = { std::min(std::max(lowest - reach, 0.0), ends[0]),
                             std::max(std::min(lowest + reach, 1.0), ends[1]) };
  double       largest = squaredThreshold;
  bool         fires = false;
  for (int side = 0; side < 2; ++side)
  {
    const PointType outer = Geometry::AddScaled(from, starts[side], direction);
    const PointType inner = Geometry::AddScaled(from, ends[side], direction);
    PointType       crossing;
    if (outer != inner && m_Oracle.FindFirstCrossing(outer, inner, crossing))
    {
      const double squared = Geometry::SquaredDistance(crossing, vertex);
      if (squared >= largest)
      {
        largest = squared;
        center = crossing;
        fires = true;
      }
    }
  }
  return fires;
}

void
DelaunayRefinementRules::FindCrossing(const PointType & from, const PointType & to, PointType & crossing) const
{
  if (m_Oracle.FindFirstCrossing(from, to, crossing))
  {
    return;
  }
  // Rounding hid it: it is where the region changes.
  const auto   region = m_Oracle.Classify(from);
  const double length = Geometry::Distance(from, to);
  PointType    low = from;
  PointType    high = to;
  for (double width = length; width > 1e-9 * length; width *= 0.5)
  {
    const PointType middle = Geometry::AddScaled(low, 0.5, Geometry::Subtract(high, low));
    (m_Oracle.Classify(middle) == region ? low : high) = middle;
  }
  crossing = high;
}

bool
DelaunayRefinementRules::FiresR4(IndexType cell) const
{
  if (m_Complex.GetRegion(cell) == 0)
  {
    return false;
  }
  const auto   p = m_Complex.GetPoints(cell);
  const double squaredEdge = Geometry::ComputeSquaredShortestEdge(p[0], p[1], p[2], p[3]);
  const double rhoBar = m_Parameters.radiusEdgeRatioBound;
  return m_Complex.GetSquaredRadius(cell) >= rhoBar * rhoBar * squaredEdge * SquaredMargin;
}

bool
DelaunayRefinementRules::FiresCellSize(IndexType cell) const
{
  return m_Complex.GetRegion(cell) != 0 &&
         m_Complex.GetSquaredRadius(cell) >= m_Parameters.cellSize * m_Parameters.cellSize * SquaredMargin;
}

bool
DelaunayRefinementRules::FiresR4Prime(IndexType cell) const
{
  if (!m_Parameters.paperSlivers || m_Complex.GetRegion(cell) == 0)
  {
    return false;
  }
  const double delta = this->GetDeltaOfFeatures(m_Complex.GetTriangulation().GetCell(cell).vertices, 4);
  const double shortest = ShortestShare * delta;
  if (m_Complex.GetSquaredRadius(cell) < shortest * shortest)
  {
    return false;
  }
  const auto p = m_Complex.GetPoints(cell);
  return Geometry::ComputeLargestDihedralCosine(p[0], p[1], p[2], p[3]) > m_LargestDihedralCosine;
}
} // end namespace itk
