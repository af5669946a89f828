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
#include "itkDelaunayRefinementBlockSampler.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

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

/** So are those of this level, and those whose parts' indexes would overflow. */
constexpr unsigned int DeepestLevel = 22;
constexpr std::int32_t GreatestIndex = 1 << 30;

/** More vertices around a group make it worth looking for those around each patch. */
constexpr std::size_t MostNearbyPoints = 64;

/** Patches no larger than this share of delta are sampled in a random order, which keeps the sample sparse. */
constexpr double SampledPatch = 0.75;

/** So many patches that follow each other, and lie close together, are shuffled: they fit into a cache. */
constexpr std::size_t ShuffledPatches = 4096;

/** A part is sampled if its center is no further than this share of its radius inside the covered part of space. */
constexpr double HopefulShare = 0.35;

/** What rounding to single precision may add to this share of delta's distances is no matter between vertices. */
constexpr double NegligibleShare = 1e-3;

/** Patches smaller than this share of delta are held to belong to one component. */
constexpr double SmallPatch = 0.3;

bool
MayBeSplit(const DelaunayRefinementSurfacePatches::IdentifierType & patch)
{
  return patch.level < DeepestLevel &&
         std::all_of(
           patch.index.begin(), patch.index.end(), [](std::int32_t index) { return std::abs(index) < GreatestIndex; });
}
} // namespace

DelaunayRefinementBlockSampler::DelaunayRefinementBlockSampler(const DelaunayRefinementOracle &     oracle,
                                                               const DelaunayRefinementLocalDelta & localDelta,
                                                               bool                                 roundToFloat,
                                                               const DelaunayRefinementPointGrid &  vertices,
                                                               DelaunayRefinementPatchCover &       cover,
                                                               const MayVisitType &                 mayVisit)
  : m_Oracle(oracle)
  , m_LocalDelta(localDelta)
  , m_RoundToFloat(roundToFloat)
  , m_AllVertices(vertices)
  , m_Cover(cover)
  , m_MayVisit(mayVisit)
{}

void
DelaunayRefinementBlockSampler::MakeRandomOrder(std::size_t begin, std::size_t length, std::mt19937_64 & random)
{
  m_Order.resize(length);
  std::iota(m_Order.begin(), m_Order.end(), static_cast<std::uint32_t>(begin));
  // Written out, as the standard leaves the outcome of std::shuffle open.
  for (std::size_t i = length; i > 1; --i)
  {
    std::swap(m_Order[i - 1], m_Order[random() % i]);
  }
}

bool
DelaunayRefinementBlockSampler::IsUniform(const PatchType & patch) const
{
  return m_LocalDelta.IsUniform() ||
         m_LocalDelta.GetMinimumWithin(patch.center, patch.radius) == m_LocalDelta.GetMaximum();
}

double
DelaunayRefinementBlockSampler::GetLeastDelta(const PatchesType & patches, std::size_t number, bool isUniform) const
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

void
DelaunayRefinementBlockSampler::Collect(const PatchesType & roots, std::size_t number)
{
  auto & block = m_Cover.GetBlock(number);
  if (block.begin == block.end)
  {
    return;
  }
  PatchesType &                  patches = block.marks.GetPatches();
  DelaunayRefinementArray<float> deltas;
  patches.Clear(roots.GetOrigin());
  patches.Reserve(8 * (block.end - block.begin));
  for (std::uint32_t i = block.begin; i < block.end; ++i)
  {
    GroupType &         group = m_Cover.GetGroup(i);
    const std::uint32_t root = m_Cover.GetRoot(i);
    group.begin = static_cast<std::uint32_t>(patches.GetSize());
    group.isUniform = this->IsUniform(roots.Get(root));
    m_Wholes.Clear(roots.GetOrigin());
    m_Wholes.Add(roots, root);
    while (m_Wholes.GetSize() > 0)
    {
      if (!m_MayVisit(m_Wholes.GetSize()))
      {
        return;
      }
      m_Parts.Clear(roots.GetOrigin());
      for (std::size_t j = 0; j < m_Wholes.GetSize(); ++j)
      {
        const double delta = this->GetLeastDelta(m_Wholes, j, group.isUniform);
        if (m_Wholes.GetRadii()[j] > SampledPatch * delta && MayBeSplit(m_Wholes.GetIdentifier(j)))
        {
          m_Oracle.SplitSurfacePatch(m_Wholes.GetIdentifier(j), m_Parts);
        }
        else
        {
          patches.Add(m_Wholes, j);
          deltas.push_back(static_cast<float>(delta));
        }
      }
      std::swap(m_Wholes, m_Parts);
    }
    group.end = static_cast<std::uint32_t>(patches.GetSize());
  }
  block.marks.Start(m_Cover.GetExtent(), HopefulShare, std::move(deltas));
}

void
DelaunayRefinementBlockSampler::Enter(std::size_t number)
{
  auto & block = m_Cover.GetBlock(number);
  m_Block = number;
  m_Marks = &block.marks;
  const double reach = m_LocalDelta.GetMaximum();
  PointType    center;
  PointType    halfExtents;
  PointType    minimum;
  PointType    maximum;
  for (unsigned int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (block.minimum[i] + block.maximum[i]);
    halfExtents[i] = 0.5 * (block.maximum[i] - block.minimum[i]);
    minimum[i] = block.minimum[i] - reach;
    maximum[i] = block.maximum[i] + reach;
  }
  m_Found.clear();
  m_AllVertices.FindWithinOfBox(center, halfExtents, reach, m_Found);
  // A copy, which fits a cache: m_AllVertices stays as it is until all threads are done with the color.
  m_Vertices.Start(minimum, maximum, CubeSize * m_LocalDelta.GetMaximum());
  std::for_each(m_Found.begin(), m_Found.end(), [this](const PointType & vertex) { m_Vertices.Add(vertex); });
  m_NumberOfOldVertices = m_Found.size();
}

bool
DelaunayRefinementBlockSampler::IsInBlock(const PointType & point) const
{
  const auto & block = m_Cover.GetBlock(m_Block);
  bool         isInside = true;
  for (unsigned int i = 0; i < 3; ++i)
  {
    isInside = isInside && block.minimum[i] <= point[i] && point[i] <= block.maximum[i];
  }
  return isInside;
}

std::vector<DelaunayRefinementBlockSampler::PointType>
DelaunayRefinementBlockSampler::Leave() const
{
  const auto & vertices = m_Vertices.GetPoints();
  return { vertices.begin() + static_cast<std::ptrdiff_t>(m_NumberOfOldVertices), vertices.end() };
}

std::vector<DelaunayRefinementBlockSampler::PointType>
DelaunayRefinementBlockSampler::Sample(std::size_t number)
{
  this->Enter(number);
  const PatchesType & patches = m_Marks->GetPatches();
  std::mt19937_64     random(patches.GetSize());
  for (std::size_t begin = 0; begin < patches.GetSize(); begin += ShuffledPatches)
  {
    this->MakeRandomOrder(begin, std::min(ShuffledPatches, patches.GetSize() - begin), random);
    if (!m_MayVisit(m_Order.size()))
    {
      break;
    }
    for (const std::uint32_t i : m_Order)
    {
      if (!m_Marks->IsCoveredOrNear(i) &&
          this->SamplePatch(patches.GetIdentifier(i), m_LocalDelta.IsUniform(), m_Vertices) == OutcomeEnum::EMPTY)
      {
        m_Marks->SetCovered(i);
      }
    }
  }
  return this->Leave();
}

std::vector<DelaunayRefinementBlockSampler::PointType>
DelaunayRefinementBlockSampler::Cover(std::size_t number)
{
  this->Enter(number);
  const auto & block = m_Cover.GetBlock(number);
  bool         mayGoOn = true;
  for (std::uint32_t i = block.begin; i < block.end && mayGoOn; ++i)
  {
    mayGoOn = this->CoverGroup(m_Cover.GetGroup(i));
  }
  return this->Leave();
}

template <typename TVertices>
DelaunayRefinementBlockSampler::OutcomeEnum
DelaunayRefinementBlockSampler::SamplePatch(const PatchesType::IdentifierType & patch,
                                            bool                                isUniform,
                                            const TVertices &                   vertices)
{
  PointType point;
  if (!m_Oracle.FindPointOfPatch(patch, point))
  {
    return OutcomeEnum::EMPTY;
  }
  const double own = isUniform ? m_LocalDelta.GetMaximum() : m_LocalDelta.GetAt(point);
  if (vertices.HasPointWithin(point, Separation * own) ||
      (!this->IsInBlock(point) && m_AllVertices.HasPointWithin(point, Separation * own)))
  {
    return OutcomeEnum::TOO_NEAR;
  }
  if (m_RoundToFloat)
  {
    std::transform(point.begin(), point.end(), point.begin(), Geometry::RoundToFloat);
  }
  m_Vertices.Add(point);
  m_Cover.CoverFrom(point, m_Block);
  return OutcomeEnum::INSERTED;
}

void
DelaunayRefinementBlockSampler::FindNearby(const PointType & center, const PointType & halfExtents)
{
  m_Found.clear();
  m_Vertices.FindWithinOfBox(center, halfExtents, m_LocalDelta.GetMaximum(), m_Found);
}

bool
DelaunayRefinementBlockSampler::CoverGroup(const GroupType & group)
{
  std::uint32_t begin = group.begin;
  while (begin < group.end && m_Marks->IsCovered(begin))
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
    return this->CoverPatches(group);
  }
  // Delta is small against the group: one patch at a time has fewer around it.
  for (std::uint32_t i = begin; i < group.end; ++i)
  {
    if (!m_Marks->IsCovered(i))
    {
      const PatchType patch = m_Marks->GetPatches().Get(i);
      this->FindNearby(patch.center, patch.halfExtents);
      if (!this->CoverPatches({ patch.center, patch.halfExtents, i, i + 1, group.isUniform }))
      {
        return false;
      }
    }
  }
  return true;
}

bool
DelaunayRefinementBlockSampler::CoverPatches(const GroupType & group)
{
  const double extent = std::sqrt(Geometry::Dot(group.halfExtents, group.halfExtents));
  const bool   isPrecise =
    PatchesType::GetRounding(extent + m_LocalDelta.GetMaximum()) < NegligibleShare * m_LocalDelta.GetMinimum();
  m_Nearby.Start(group.center, extent);
  std::for_each(m_Found.begin(), m_Found.end(), [this](const PointType & vertex) { m_Nearby.Add(vertex); });
  m_Parts.Clear(group.center);
  const PatchesType & patches = m_Marks->GetPatches();
  for (std::size_t i = group.begin; i < group.end; ++i)
  {
    if (!m_Marks->IsCovered(i) &&
        !m_Nearby.DoTwoCover(patches.Get(i), this->GetLeastDelta(patches, i, group.isUniform)))
    {
      m_Oracle.SplitSurfacePatch(patches.GetIdentifier(i), m_Parts);
    }
  }
  while (m_Parts.GetSize() > 0)
  {
    std::swap(m_Wholes, m_Parts);
    m_Parts.Clear(group.center);
    if (!m_MayVisit(m_Wholes.GetSize()))
    {
      return false;
    }
    for (std::size_t i = 0; i < m_Wholes.GetSize(); ++i)
    {
      const double delta = this->GetLeastDelta(m_Wholes, i, group.isUniform);
      const auto   answer = m_Nearby.Ask(m_Wholes, i, delta, HopefulShare);
      if (answer == AnswerEnum::COVERED || (answer == AnswerEnum::NEAR && m_Nearby.DoTwoCover(m_Wholes.Get(i), delta)))
      {
        continue;
      }
      // Points of a patch whose center is well covered are likely to be too near.
      const bool isSmallest = m_Wholes.GetRadii()[i] < SmallestPatch * delta || !MayBeSplit(m_Wholes.GetIdentifier(i));
      if (answer == AnswerEnum::FAR || isSmallest)
      {
        const auto &      patch = m_Wholes.GetIdentifier(i);
        const OutcomeEnum outcome = isPrecise ? this->SamplePatch(patch, group.isUniform, m_Nearby)
                                              : this->SamplePatch(patch, group.isUniform, m_Vertices);
        if (outcome == OutcomeEnum::INSERTED)
        {
          m_Nearby.Add(m_Vertices.GetPoints().back());
        }
        if (isSmallest || outcome == OutcomeEnum::EMPTY ||
            (outcome == OutcomeEnum::INSERTED && m_Nearby.Ask(m_Wholes, i, delta, HopefulShare) == AnswerEnum::COVERED))
        {
          continue;
        }
      }
      m_Oracle.SplitSurfacePatch(m_Wholes.GetIdentifier(i), m_Parts);
    }
  }
  return true;
}

} // end namespace itk
