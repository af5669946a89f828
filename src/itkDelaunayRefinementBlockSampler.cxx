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

#include "itkDelaunayRefinementBits.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using CellsType = DelaunayRefinementSurfaceCells;

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

/** It takes less time to look at all of so many vertices than to find those nearby in a grid. */
constexpr std::size_t FewVertices = 1024;

/** The radius of a word's cells over delta, at most. */
constexpr double SampledCell = 0.75;

/** A part of a cell is sampled if its center is no further than this share of its radius inside the covered part of
 * space. */
constexpr double HopefulShare = 0.35;

/** Two vertices seldom cover a cell together whose radius is a larger share of delta. */
constexpr double LargestForTwo = 0.4;

/** What rounding to single precision may add to this share of delta's distances is no matter between vertices. */
constexpr double NegligibleShare = 1e-3;

bool
MayBeSplit(const DelaunayRefinementSurfacePatches::IdentifierType & patch)
{
  return patch.level < DeepestLevel &&
         std::all_of(
           patch.index.begin(), patch.index.end(), [](std::int32_t index) { return std::abs(index) < GreatestIndex; });
}

/** One of a word's bits, each as likely as the others. */
unsigned int
ChooseBit(std::uint64_t word, std::uint64_t random)
{
  for (std::uint64_t skipped = random % CountDelaunayRefinementBits(word); skipped > 0; --skipped)
  {
    word &= word - 1;
  }
  return FindDelaunayRefinementBit(word);
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
DelaunayRefinementBlockSampler::MakeRandomOrder(std::size_t length, std::mt19937_64 & random)
{
  m_Order.resize(length);
  std::iota(m_Order.begin(), m_Order.end(), 0u);
  // Written out, as the standard leaves the outcome of std::shuffle open.
  for (std::size_t i = length; i > 1; --i)
  {
    std::swap(m_Order[i - 1], m_Order[random() % i]);
  }
}

double
DelaunayRefinementBlockSampler::GetLeastDelta(const WordType & word, std::uint64_t cells)
{
  double least = word.delta;
  if (!word.isUniform)
  {
    PointType center;
    PointType halfExtents;
    m_Words->GetBox(word, cells, center, halfExtents);
    m_Wholes.Clear(center);
    m_Oracle.AppendCells(m_Words->GetCells(word, cells), m_Wholes);
    for (std::size_t i = 0; i < m_Wholes.GetSize(); ++i)
    {
      least = std::min(least, this->GetLeastDelta(word, m_Wholes, i));
    }
  }
  return least;
}

void
DelaunayRefinementBlockSampler::Collect(const PatchesType & roots, std::size_t number)
{
  auto & block = m_Cover.GetBlock(number);
  if (block.begin == block.end)
  {
    return;
  }
  block.words.Start(roots.GetOrigin(), m_Oracle.GetCellAxes(), block.end - block.begin);
  for (std::uint32_t i = block.begin; i < block.end; ++i)
  {
    auto &              group = m_Cover.GetGroup(i);
    const std::uint32_t root = m_Cover.GetRoot(i);
    const auto          rootDelta = m_LocalDelta.GetRange(roots.Get(root));
    const bool          isUniform = rootDelta.least == rootDelta.greatest;
    group.begin = static_cast<std::uint32_t>(block.words.GetSize());
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
        const auto delta = isUniform ? rootDelta : m_LocalDelta.GetRange(m_Wholes.Get(j));
        const auto cells = m_Oracle.GetCellsOfPatch(m_Wholes.Get(j));
        if (DelaunayRefinementSurfaceWords::GetCellRadius(cells) > SampledCell * delta.least && MayBeSplit(cells.first))
        {
          m_Oracle.SplitSurfacePatch(m_Wholes.GetIdentifier(j), m_Parts);
        }
        else if (cells.bits != 0)
        {
          block.words.Add(cells, delta);
          block.greatestDelta = std::max(block.greatestDelta, delta.greatest);
          block.sumOfDeltas += delta.greatest;
        }
      }
      std::swap(m_Wholes, m_Parts);
    }
    group.end = static_cast<std::uint32_t>(block.words.GetSize());
  }
}

void
DelaunayRefinementBlockSampler::Enter(std::size_t number)
{
  auto & block = m_Cover.GetBlock(number);
  m_Block = number;
  m_Words = &block.words;
  const double reach = block.greatestDelta;
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
  m_Vertices.Start(minimum, maximum, CubeSize * block.sumOfDeltas / static_cast<double>(m_Words->GetSize()));
  m_FewVertices.Start(center, std::sqrt(Geometry::Dot(halfExtents, halfExtents)) + reach);
  std::for_each(m_Found.begin(), m_Found.end(), [this](const PointType & vertex) { this->AddVertex(vertex); });
  m_NumberOfOldVertices = m_Found.size();
}

void
DelaunayRefinementBlockSampler::AddVertex(const PointType & vertex)
{
  m_Vertices.Add(vertex);
  if (m_FewVertices.GetSize() <= FewVertices)
  {
    m_FewVertices.Add(vertex);
  }
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
  if (m_Cover.GetBlock(number).words.GetSize() == 0)
  {
    return {};
  }
  this->Enter(number);
  std::mt19937_64 random(m_Words->GetSize());
  this->MakeRandomOrder(m_Words->GetSize(), random);
  // A cell of each word in turn, until none is left.
  while (!m_Order.empty() && m_MayVisit(m_Order.size()))
  {
    std::size_t length = 0;
    for (const std::uint32_t i : m_Order)
    {
      WordType & word = m_Words->GetWord(i);
      word.hopeful &= word.uncovered;
      if (word.hopeful == 0)
      {
        continue;
      }
      const unsigned int  bit = ChooseBit(word.hopeful, random());
      const std::uint64_t cell = std::uint64_t{ 1 } << bit;
      word.hopeful &= ~cell;
      const auto patch = CellsType::GetPatch(word.first, bit);
      if (this->SamplePatch(patch, this->GetLeastDelta(word, cell), m_Vertices) == OutcomeEnum::EMPTY)
      {
        word.uncovered &= ~cell;
      }
      m_Order[length] = i;
      length += word.hopeful != 0 ? 1 : 0;
    }
    m_Order.resize(length);
  }
  return this->Leave();
}

std::vector<DelaunayRefinementBlockSampler::PointType>
DelaunayRefinementBlockSampler::Cover(std::size_t number)
{
  if (m_Cover.GetBlock(number).words.GetSize() == 0)
  {
    return {};
  }
  this->Enter(number);
  bool mayGoOn = true;
  for (std::size_t i = 0; i < m_Words->GetSize() && mayGoOn; ++i)
  {
    mayGoOn = this->CoverWord(m_Words->GetWord(i));
  }
  return this->Leave();
}

template <typename TVertices>
DelaunayRefinementBlockSampler::OutcomeEnum
DelaunayRefinementBlockSampler::SamplePatch(const PatchesType::IdentifierType & patch,
                                            double                              delta,
                                            const TVertices &                   vertices)
{
  PointType point;
  if (!m_Oracle.FindPointOfPatch(patch, point))
  {
    return OutcomeEnum::EMPTY;
  }
  if (vertices.HasPointWithin(point, Separation * delta) ||
      (!this->IsInBlock(point) && m_AllVertices.HasPointWithin(point, Separation * delta)))
  {
    return OutcomeEnum::TOO_NEAR;
  }
  if (m_RoundToFloat)
  {
    point = Geometry::RoundPointToFloat(point);
  }
  this->AddVertex(point);
  m_Cover.CoverFrom(point, m_Block, m_Reached);
  return OutcomeEnum::INSERTED;
}

void
DelaunayRefinementBlockSampler::FindNearby(const WordType & word, std::uint64_t cells)
{
  m_Words->GetBox(word, cells, m_Center, m_HalfExtents);
  m_Found.clear();
  if (m_FewVertices.GetSize() > FewVertices)
  {
    m_Vertices.FindWithinOfBox(m_Center, m_HalfExtents, word.delta, m_Found);
    return;
  }
  m_FoundFew.clear();
  m_FewVertices.FindWithinOfBox(m_Center, m_HalfExtents, word.delta, m_FoundFew);
  for (const std::uint32_t number : m_FoundFew)
  {
    m_Found.push_back(m_Vertices.GetPoints()[number]);
  }
}

bool
DelaunayRefinementBlockSampler::CoverWord(const WordType & word)
{
  if (word.uncovered == 0)
  {
    return true;
  }
  this->FindNearby(word, word.uncovered);
  if (m_Found.size() <= MostNearbyPoints)
  {
    return this->CoverCells(word, word.uncovered);
  }
  // Delta is small against the word: one cell at a time has fewer around it.
  bool mayGoOn = true;
  for (std::uint64_t cells = word.uncovered; cells != 0 && mayGoOn; cells &= (cells - 1) & word.uncovered)
  {
    const std::uint64_t cell = cells & ~(cells - 1);
    this->FindNearby(word, cell);
    mayGoOn = this->CoverCells(word, cell);
  }
  return mayGoOn;
}

bool
DelaunayRefinementBlockSampler::CoverCells(const WordType & word, std::uint64_t cells)
{
  const double extent = std::sqrt(Geometry::Dot(m_HalfExtents, m_HalfExtents));
  const double least = word.isUniform ? word.delta : m_LocalDelta.GetMinimum();
  const bool   isPrecise = PatchesType::GetRounding(extent + word.delta) < NegligibleShare * least;
  m_Nearby.Start(m_Center, extent);
  std::for_each(m_Found.begin(), m_Found.end(), [this](const PointType & vertex) { m_Nearby.Add(vertex); });
  m_Wholes.Clear(m_Center);
  m_Parts.Clear(m_Center);
  m_Oracle.AppendCells(m_Words->GetCells(word, cells), m_Wholes);
  for (std::size_t i = 0; i < m_Wholes.GetSize(); ++i)
  {
    const double delta = this->GetLeastDelta(word, m_Wholes, i);
    if (m_Wholes.GetRadii()[i] > LargestForTwo * delta || !m_Nearby.DoTwoCover(m_Wholes.Get(i), delta))
    {
      m_Oracle.SplitSurfacePatch(m_Wholes.GetIdentifier(i), m_Parts);
    }
  }
  while (m_Parts.GetSize() > 0)
  {
    std::swap(m_Wholes, m_Parts);
    m_Parts.Clear(m_Center);
    if (!m_MayVisit(m_Wholes.GetSize()))
    {
      return false;
    }
    for (std::size_t i = 0; i < m_Wholes.GetSize(); ++i)
    {
      const double delta = this->GetLeastDelta(word, m_Wholes, i);
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
        const OutcomeEnum outcome =
          isPrecise ? this->SamplePatch(patch, delta, m_Nearby) : this->SamplePatch(patch, delta, m_Vertices);
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
