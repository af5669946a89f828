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
#include "itkDelaunayRefinementAccuracy.h"

#include "itkDelaunayRefinementMeshTopology.h"
#include "itkDelaunayRefinementMissingComponents.h"

#include <algorithm>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** Delta gets this share of itself, unless that is next to nothing. */
constexpr double DeltaStep = 0.5;
constexpr double SmallestStep = 0.01;

constexpr unsigned int MaximumNumberOfRounds = 40;

/** How well distances are measured, over what was asked for. */
constexpr double ToleranceShare = 0.1;

/** Bounds on the distance that are tried for the sake of topology: the first one over the least delta, and each later
 * one over that before. */
constexpr double FirstTopologyBound = 8.0;
constexpr double TopologyStep = 0.5;

/** Delta is lowered within this share of it around surface that the boundary does not show. */
constexpr double HiddenShare = 0.5;
} // namespace

DelaunayRefinementAccuracy::DelaunayRefinementAccuracy(const DelaunayRefinementOracle &     oracle,
                                                       const DelaunayRefinementParameters & parameters,
                                                       const DelaunayRefinementComplex &    complex,
                                                       DelaunayRefinementLocalDelta &       localDelta,
                                                       DelaunayRefinementThreads &          threads)
  : m_Oracle(oracle)
  , m_Parameters(parameters)
  , m_Complex(complex)
  , m_LocalDelta(localDelta)
  , m_Threads(threads)
  , m_Bound(parameters.hausdorffBound)
{}

bool
DelaunayRefinementAccuracy::Improve(DelaunayRefinementStatistics & statistics)
{
  if (this->ImproveDistance())
  {
    return true;
  }
  if (std::isfinite(m_Parameters.topologySize) && this->ImproveTopology(statistics))
  {
    return true;
  }
  double asked = m_Parameters.hausdorffBound;
  if (std::isfinite(m_Parameters.leastDelta))
  {
    asked =
      std::min(asked, std::max(m_Parameters.deviationShare * m_LocalDelta.GetMinimum(), m_Parameters.leastDeviation));
  }
  if (std::isfinite(asked))
  {
    statistics.meshToSurface = m_Fidelity->MeasureFromFacets(ToleranceShare * asked);
    statistics.surfaceToMesh = m_Fidelity->MeasureFromSurface(ToleranceShare * asked);
  }
  return false;
}

bool
DelaunayRefinementAccuracy::ImproveDistance()
{
  if (std::isinf(m_Bound) && std::isinf(m_Parameters.leastDelta))
  {
    return false;
  }
  if (m_Fidelity == nullptr)
  {
    m_Fidelity =
      std::make_unique<DelaunayRefinementFidelity>(m_Oracle, m_Parameters, m_Bound, m_Complex, m_LocalDelta, m_Threads);
  }
  return this->Lower(m_Fidelity->FindFarPlaces());
}

bool
DelaunayRefinementAccuracy::ImproveTopology(DelaunayRefinementStatistics & statistics)
{
  if (!statistics.imageTopology.isKnown)
  {
    statistics.imageTopology = m_Oracle.CountTopology();
  }
  statistics.meshTopology = CountDelaunayRefinementMeshTopology(m_Complex);
  if (statistics.meshTopology == statistics.imageTopology)
  {
    return false;
  }
  if (this->Lower(this->FindPlacesOfOtherTopology(statistics)))
  {
    return true;
  }
  // What is left is seen by its distance.
  const double bound = std::min(TopologyStep * m_Bound, FirstTopologyBound * m_Parameters.topologySize);
  if (bound < m_Parameters.topologySize)
  {
    return false;
  }
  m_Bound = bound;
  m_Fidelity.reset();
  return this->ImproveDistance() || this->ImproveTopology(statistics);
}

std::vector<DelaunayRefinementAccuracy::PlaceType>
DelaunayRefinementAccuracy::FindPlacesOfOtherTopology(const DelaunayRefinementStatistics & statistics) const
{
  const double           least = m_Parameters.topologySize;
  std::vector<PlaceType> places;
  const auto             addBox = [&](const DelaunayRefinementOracle::BoundsType & box) {
    const PointType center = Geometry::AddScaled(box.minimum, 0.5, Geometry::Subtract(box.maximum, box.minimum));
    places.push_back({ center, Geometry::Distance(box.maximum, center), least });
  };
  const auto addPoint = [&](const PointType & point) {
    places.push_back({ point, HiddenShare * m_LocalDelta.GetAt(point), least });
  };
  for (const std::uint32_t component : statistics.missingComponents)
  {
    addBox(m_Oracle.GetComponentBounds(component));
  }
  // Smoothing may have filled some.
  if (statistics.meshTopology.cavities < statistics.imageTopology.cavities)
  {
    for (const std::uint32_t cavity : FindMissingDelaunayRefinementCavities(m_Oracle, m_Complex, m_Threads))
    {
      addBox(m_Oracle.GetCavityBounds(cavity));
    }
  }
  for (const PointType & point : FindHiddenDelaunayRefinementSurface(m_Oracle, m_Complex, m_Threads))
  {
    addPoint(point);
  }
  for (const auto cell : FindSuperfluousDelaunayRefinementParts(m_Oracle, m_Complex))
  {
    for (const auto vertex : m_Complex.GetTriangulation().GetCell(cell).vertices)
    {
      if (m_Complex.IsFeature(vertex))
      {
        addPoint(m_Complex.GetPoint(vertex));
      }
    }
  }
  return places;
}

bool
DelaunayRefinementAccuracy::Lower(const std::vector<PlaceType> & places)
{
  std::vector<double> deltas;
  deltas.reserve(places.size());
  for (const auto & place : places)
  {
    deltas.push_back(m_LocalDelta.GetAt(place.center));
  }
  bool isLowered = false;
  for (std::size_t i = 0; i < places.size() && m_NumberOfRounds < MaximumNumberOfRounds; ++i)
  {
    // Another place nearby may have seen to it.
    const double lowered = std::max(DeltaStep * deltas[i], places[i].leastDelta);
    if (lowered < (1.0 - SmallestStep) * m_LocalDelta.GetAt(places[i].center))
    {
      m_LocalDelta.LowerAround(places[i].center, places[i].radius, lowered);
      isLowered = true;
    }
  }
  if (isLowered)
  {
    m_LocalDelta.Grade();
    ++m_NumberOfRounds;
  }
  return isLowered;
}
} // end namespace itk
