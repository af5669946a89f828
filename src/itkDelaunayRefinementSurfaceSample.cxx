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
constexpr double Separation = 0.999;

/** Edge of the cubes in which vertices are looked up, over delta. */
constexpr double CubeSize = 2.0;

/** Patches smaller than this share of delta are judged by their point alone. */
constexpr double SmallestPatch = 1e-5;

constexpr std::size_t VisitsBetweenQuestions = 16384;

/** Patches no larger than this share of delta are sampled in a random order, which keeps the sample sparse. */
constexpr double SampledPatch = 0.75;

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
  // Written out, as the standard leaves the outcome of std::shuffle open.
  std::vector<std::uint32_t> order(length);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(length);
  for (std::size_t i = length; i > 1; --i)
  {
    std::swap(order[i - 1], order[random() % i]);
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
DelaunayRefinementSurfaceSample::GetLeastDelta(const PatchType & patch, bool isUniform) const
{
  if (isUniform)
  {
    return m_LocalDelta.GetMaximum();
  }
  return patch.radius < SmallPatch * m_LocalDelta.GetMinimum()
           ? m_LocalDelta.GetAt(patch.center)
           : m_LocalDelta.GetMinimumWithin(patch.center, patch.radius);
}

bool
DelaunayRefinementSurfaceSample::CollectPatches(std::vector<DelaunayRefinementPatchCover::EntryType> & entries,
                                                const std::function<bool()> &                          mayVisit) const
{
  std::vector<PatchType> stack;
  for (const PatchType & patch : m_Oracle.GetSurfacePatches())
  {
    const bool isUniform = this->IsUniform(patch);
    stack.assign(1, patch);
    while (!stack.empty())
    {
      if (!mayVisit())
      {
        return false;
      }
      const PatchType top = stack.back();
      stack.pop_back();
      const double delta = this->GetLeastDelta(top, isUniform);
      if (top.radius > SampledPatch * delta)
      {
        m_Oracle.SplitSurfacePatch(top, stack);
      }
      else
      {
        entries.push_back({ top, delta, isUniform });
      }
    }
  }
  return true;
}

DelaunayRefinementSurfaceSample::OutcomeEnum
DelaunayRefinementSurfaceSample::Sample(const PatchType &              patch,
                                        bool                           isUniform,
                                        DelaunayRefinementPatchCover & cover,
                                        std::vector<PointType> &       points)
{
  PointType point;
  if (!m_Oracle.FindPointOfPatch(patch, point))
  {
    return OutcomeEnum::DONE;
  }
  const double own = isUniform ? m_LocalDelta.GetMaximum() : m_LocalDelta.GetAt(point);
  const double apart = Separation * own;
  if (m_Grid.HasPointWithin(point, apart))
  {
    return patch.radius < SmallestPatch * own ? OutcomeEnum::DONE : OutcomeEnum::NOTHING;
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

bool
DelaunayRefinementSurfaceSample::CoverByParts(const PatchType &              patch,
                                              bool                           isUniform,
                                              DelaunayRefinementPatchCover & cover,
                                              std::vector<PointType> &       points,
                                              const std::function<bool()> &  mayVisit)
{
  m_Nearby.clear();
  m_Grid.FindWithin(patch.center, m_LocalDelta.GetMaximum() + patch.radius, m_Nearby);
  m_Stack.assign(1, patch);
  while (!m_Stack.empty())
  {
    if (!mayVisit())
    {
      return false;
    }
    const PatchType part = m_Stack.back();
    m_Stack.pop_back();
    const double delta = this->GetLeastDelta(part, isUniform);
    const auto   covering = std::find_if(m_Nearby.begin(), m_Nearby.end(), [&](const PointType & vertex) {
      return DelaunayRefinementPatchCover::IsWithin(part, delta, vertex);
    });
    if (covering != m_Nearby.end())
    {
      // Likely to cover the next part, too.
      std::iter_swap(m_Nearby.begin(), covering);
      continue;
    }
    double squaredNearest = std::numeric_limits<double>::infinity();
    for (const PointType & vertex : m_Nearby)
    {
      squaredNearest = std::min(squaredNearest, Geometry::SquaredDistance(part.center, vertex));
    }
    // Points of a part whose center is well covered are likely to be too near.
    const double hopeful = delta - HopefulShare * part.radius;
    if (!(hopeful > 0.0 && squaredNearest <= hopeful * hopeful) || part.radius < SmallestPatch * delta)
    {
      const OutcomeEnum outcome = this->Sample(part, isUniform, cover, points);
      if (outcome == OutcomeEnum::INSERTED)
      {
        m_Nearby.push_back(points.back());
        if (DelaunayRefinementPatchCover::IsWithin(part, delta, points.back()))
        {
          continue;
        }
      }
      if (outcome == OutcomeEnum::DONE)
      {
        continue;
      }
    }
    m_Oracle.SplitSurfacePatch(part, m_Stack);
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
  std::size_t                 numberOfVisits = 0;
  const std::function<bool()> mayVisit = [&] { return ++numberOfVisits % VisitsBetweenQuestions != 0 || keepGoing(); };
  std::vector<DelaunayRefinementPatchCover::EntryType> entries;
  if (!this->CollectPatches(entries, mayVisit))
  {
    return false;
  }
  DelaunayRefinementPatchCover cover(std::move(entries));
  for (const PointType & vertex : m_Grid.GetPoints())
  {
    cover.CoverFrom(vertex);
  }
  for (const std::uint32_t i : MakeRandomOrder(cover.GetNumberOfPatches()))
  {
    if (!mayVisit())
    {
      return false;
    }
    if (!cover.IsCovered(i))
    {
      const auto & entry = cover.GetEntry(i);
      if (this->Sample(entry.patch, entry.isUniform, cover, points) == OutcomeEnum::DONE)
      {
        cover.SetCovered(i);
      }
    }
  }
  for (std::size_t i = 0; i < cover.GetNumberOfPatches(); ++i)
  {
    const auto & entry = cover.GetEntry(i);
    if (!cover.IsCovered(i) && !this->CoverByParts(entry.patch, entry.isUniform, cover, points, mayVisit))
    {
      return false;
    }
  }
  return true;
}
} // end namespace itk
