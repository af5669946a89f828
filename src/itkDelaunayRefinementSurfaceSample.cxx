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
#include "itkDelaunayRefinementSurfaceSample.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** R1 inserts points at this share of delta from others, so that what is left over is certainly within delta. */
constexpr double Separation = 0.98;

/** Edge of the cubes in which vertices are looked up, over delta. */
constexpr double CubeSize = 2.0;

/** Patches smaller than this share of delta are judged by their point alone. */
constexpr double SmallestPatch = 1e-5;

/** So are those of this level, before their indexes overflow. */
constexpr unsigned int DeepestLevel = 22;

/** More vertices around a group make it worth looking for those around each patch. */
constexpr std::size_t MostNearbyPoints = 64;

constexpr std::size_t VisitsBetweenQuestions = 16384;

/** Patches no larger than this share of delta are sampled in a random order, which keeps the sample sparse. */
constexpr double SampledPatch = 0.75;

/** So many patches that follow each other, and lie close together, are shuffled: they fit into a cache. */
constexpr std::size_t ShuffledPatches = 4096;

/** A part is sampled if its center is no further than this share of its radius inside the covered part of space. */
constexpr double HopefulShare = 0.35;

/** Surface points are within this share of delta of a vertex, those included that were replaced by one nearby. */
constexpr double CoverageShare = 1.01;

/** Patches smaller than this share of delta are held to belong to one component. */
constexpr double SmallPatch = 0.3;
} // namespace

DelaunayRefinementSurfaceSample::DelaunayRefinementSurfaceSample(const DelaunayRefinementOracle &     oracle,
                                                                 const DelaunayRefinementLocalDelta & localDelta,
                                                                 bool                                 roundToFloat)
  : m_Oracle(oracle)
  , m_LocalDelta(localDelta)
  , m_RoundToFloat(roundToFloat)
  , m_Grid(oracle.GetSurfaceBounds().minimum, oracle.GetSurfaceBounds().maximum, CubeSize * localDelta.GetMaximum())
{}

std::vector<std::uint32_t>
DelaunayRefinementSurfaceSample::MakeRandomOrder(std::size_t length)
{
  std::vector<std::uint32_t> order(length);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(length);
  for (std::size_t begin = 0; begin < length; begin += ShuffledPatches)
  {
    // Written out, as the standard leaves the outcome of std::shuffle open.
    for (std::size_t i = std::min(ShuffledPatches, length - begin); i > 1; --i)
    {
      std::swap(order[begin + i - 1], order[begin + random() % i]);
    }
  }
  return order;
}

bool
DelaunayRefinementSurfaceSample::IsUniform(const PatchType & patch) const
{
  return m_LocalDelta.IsUniform() ||
         m_LocalDelta.GetMinimumWithin(patch.center, patch.radius) == m_LocalDelta.GetMaximum();
}

double
DelaunayRefinementSurfaceSample::GetLeastDelta(const PatchesType & patches, std::size_t number, bool isUniform) const
{
  if (isUniform)
  {
    return m_LocalDelta.GetMaximum();
  }
  const PatchType patch = patches.Get(number);
  return patch.radius < SmallPatch * m_LocalDelta.GetMinimum()
           ? m_LocalDelta.GetAt(patch.center)
           : m_LocalDelta.GetMinimumWithin(patch.center, patch.radius);
}

bool
DelaunayRefinementSurfaceSample::CollectPatches(const PatchesType &            roots,
                                                DelaunayRefinementPatchCover & cover,
                                                const MayVisitType &           mayVisit)
{
  DelaunayRefinementArray<float> deltas;
  PatchesType &                  patches = cover.GetMarks().GetPatches();
  PatchesType                    wholes;
  patches.Reserve(8 * roots.GetSize());
  for (const std::uint32_t number : cover.GetOrder())
  {
    const bool isUniform = this->IsUniform(roots.Get(number));
    wholes.Clear(roots.GetOrigin());
    wholes.Add(roots, number);
    while (wholes.GetSize() > 0)
    {
      if (!mayVisit(wholes.GetSize()))
      {
        return false;
      }
      m_Parts.Clear(roots.GetOrigin());
      for (std::size_t i = 0; i < wholes.GetSize(); ++i)
      {
        const double delta = this->GetLeastDelta(wholes, i, isUniform);
        if (wholes.GetRadii()[i] > SampledPatch * delta && wholes.GetIdentifier(i).level < DeepestLevel)
        {
          m_Oracle.SplitSurfacePatch(wholes.GetIdentifier(i), m_Parts);
        }
        else
        {
          patches.Add(wholes, i);
          deltas.push_back(static_cast<float>(delta));
        }
      }
      std::swap(wholes, m_Parts);
    }
    cover.EndGroup(isUniform);
  }
  cover.GetMarks().Start(cover.GetExtent(), HopefulShare, std::move(deltas));
  return true;
}

template <typename TVertices>
DelaunayRefinementSurfaceSample::OutcomeEnum
DelaunayRefinementSurfaceSample::Sample(const PatchesType::IdentifierType & patch,
                                        bool                                isUniform,
                                        const TVertices &                   vertices,
                                        DelaunayRefinementPatchCover &      cover,
                                        std::vector<PointType> &            points)
{
  PointType point;
  if (!m_Oracle.FindPointOfPatch(patch, point))
  {
    return OutcomeEnum::EMPTY;
  }
  const double own = isUniform ? m_LocalDelta.GetMaximum() : m_LocalDelta.GetAt(point);
  if (vertices.HasPointWithin(point, Separation * own))
  {
    return OutcomeEnum::TOO_NEAR;
  }
  if (m_RoundToFloat)
  {
    std::transform(point.begin(), point.end(), point.begin(), Geometry::RoundToFloat);
  }
  m_Grid.Add(point);
  points.push_back(point);
  cover.CoverFrom(point);
  return OutcomeEnum::INSERTED;
}

void
DelaunayRefinementSurfaceSample::FindNearby(const PointType & center, const PointType & halfExtents)
{
  m_Found.clear();
  m_Grid.FindWithinOfBox(center, halfExtents, m_LocalDelta.GetMaximum(), m_Found);
}

bool
DelaunayRefinementSurfaceSample::CoverGroup(const DelaunayRefinementPatchCover::GroupType & group,
                                            DelaunayRefinementPatchCover &                  cover,
                                            std::vector<PointType> &                        points,
                                            const MayVisitType &                            mayVisit)
{
  const DelaunayRefinementPatchMarks & marks = cover.GetMarks();
  std::uint32_t                        begin = group.begin;
  while (begin < group.end && marks.IsCovered(begin))
  {
    ++begin;
  }
  if (begin == group.end)
  {
    return true;
  }
  this->FindNearby(group.center, group.halfExtents);
  if (m_Found.size() <= MostNearbyPoints)
  {
    return this->CoverPatches(group, cover, points, mayVisit);
  }
  // Delta is small against the group: one patch at a time has fewer around it.
  for (std::uint32_t i = begin; i < group.end; ++i)
  {
    if (!marks.IsCovered(i))
    {
      const PatchType patch = marks.GetPatches().Get(i);
      this->FindNearby(patch.center, patch.halfExtents);
      if (!this->CoverPatches({ patch.center, patch.halfExtents, i, i + 1, group.isUniform }, cover, points, mayVisit))
      {
        return false;
      }
    }
  }
  return true;
}

bool
DelaunayRefinementSurfaceSample::CoverPatches(const DelaunayRefinementPatchCover::GroupType & group,
                                              DelaunayRefinementPatchCover &                  cover,
                                              std::vector<PointType> &                        points,
                                              const MayVisitType &                            mayVisit)
{
  const DelaunayRefinementPatchMarks & marks = cover.GetMarks();
  m_Nearby.Start(group.center, std::sqrt(Geometry::Dot(group.halfExtents, group.halfExtents)));
  std::for_each(m_Found.begin(), m_Found.end(), [this](const PointType & vertex) { m_Nearby.Add(vertex); });
  m_Parts.Clear(group.center);
  for (std::size_t i = group.begin; i < group.end; ++i)
  {
    if (!marks.IsCovered(i))
    {
      m_Oracle.SplitSurfacePatch(marks.GetPatches().GetIdentifier(i), m_Parts);
    }
  }
  while (m_Parts.GetSize() > 0)
  {
    std::swap(m_Wholes, m_Parts);
    m_Parts.Clear(group.center);
    if (!mayVisit(m_Wholes.GetSize()))
    {
      return false;
    }
    for (std::size_t i = 0; i < m_Wholes.GetSize(); ++i)
    {
      const double delta = this->GetLeastDelta(m_Wholes, i, group.isUniform);
      const auto   answer = m_Nearby.Ask(m_Wholes, i, delta, HopefulShare);
      if (answer == AnswerEnum::COVERED)
      {
        continue;
      }
      // Points of a patch whose center is well covered are likely to be too near.
      const bool isSmallest =
        m_Wholes.GetRadii()[i] < SmallestPatch * delta || m_Wholes.GetIdentifier(i).level >= DeepestLevel;
      if (answer == AnswerEnum::FAR || isSmallest)
      {
        const OutcomeEnum outcome = this->Sample(m_Wholes.GetIdentifier(i), group.isUniform, m_Nearby, cover, points);
        if (outcome == OutcomeEnum::INSERTED)
        {
          m_Nearby.Add(points.back());
        }
        if ((outcome == OutcomeEnum::INSERTED &&
             m_Nearby.Ask(m_Wholes, i, delta, HopefulShare) == AnswerEnum::COVERED) ||
            outcome == OutcomeEnum::EMPTY || (outcome == OutcomeEnum::TOO_NEAR && isSmallest))
        {
          continue;
        }
      }
      m_Oracle.SplitSurfacePatch(m_Wholes.GetIdentifier(i), m_Parts);
    }
  }
  return true;
}

bool
DelaunayRefinementSurfaceSample::MayHaveSurfaceWithin(const PointType & point, double radius) const
{
  return m_Grid.HasPointWithin(point, radius + CoverageShare * m_LocalDelta.GetMaximum());
}

void
DelaunayRefinementSurfaceSample::Add(const PointType & point)
{
  m_Grid.Add(point);
}

bool
DelaunayRefinementSurfaceSample::Certify(std::vector<PointType> & points, const std::function<bool()> & keepGoing)
{
  std::size_t        numberOfVisits = 0;
  const MayVisitType mayVisit = [&](std::size_t numberOfPatches) {
    const std::size_t before = numberOfVisits / VisitsBetweenQuestions;
    numberOfVisits += numberOfPatches;
    return numberOfVisits / VisitsBetweenQuestions == before || keepGoing();
  };
  const PatchesType            roots = m_Oracle.GetSurfacePatches();
  DelaunayRefinementPatchCover cover(roots, m_LocalDelta.GetMaximum());
  if (!this->CollectPatches(roots, cover, mayVisit))
  {
    return false;
  }
  for (const PointType & vertex : m_Grid.GetPoints())
  {
    cover.CoverFrom(vertex);
  }
  auto & marks = cover.GetMarks();
  for (const std::uint32_t i : MakeRandomOrder(marks.GetPatches().GetSize()))
  {
    if (!mayVisit(1))
    {
      return false;
    }
    if (!marks.IsCoveredOrNear(i) &&
        this->Sample(marks.GetPatches().GetIdentifier(i), m_LocalDelta.IsUniform(), m_Grid, cover, points) ==
          OutcomeEnum::EMPTY)
    {
      marks.SetCovered(i);
    }
  }
  for (const auto & group : cover.GetGroups())
  {
    if (!this->CoverGroup(group, cover, points, mayVisit))
    {
      return false;
    }
  }
  return true;
}
} // end namespace itk
