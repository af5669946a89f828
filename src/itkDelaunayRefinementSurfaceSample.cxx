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

#include "itkDelaunayRefinementBlockSampler.h"

#include <algorithm>
#include <atomic>

namespace itk
{
namespace
{
/** Edge of the cubes in which vertices are looked up, over delta. */
constexpr double CubeSize = 2.0;

constexpr std::size_t VisitsBetweenQuestions = 16384;

/** Fewer blocks are not worth waking threads for. */
constexpr std::size_t LeastBlocksForThreads = 16;

/** Surface points are within this share of delta of a vertex, those included that were replaced by one nearby. */
constexpr double CoverageShare = 1.01;
} // namespace

DelaunayRefinementSurfaceSample::DelaunayRefinementSurfaceSample(const DelaunayRefinementOracle &     oracle,
                                                                 const DelaunayRefinementLocalDelta & localDelta,
                                                                 bool                                 roundToFloat)
  : m_Oracle(oracle)
  , m_LocalDelta(localDelta)
  , m_RoundToFloat(roundToFloat)
  , m_Grid(this->MakeGrid())
{}

DelaunayRefinementPointGrid
DelaunayRefinementSurfaceSample::MakeGrid() const
{
  const auto bounds = m_Oracle.GetSurfaceBounds();
  return { bounds.minimum, bounds.maximum, CubeSize * m_LocalDelta.GetMaximum() };
}

bool
DelaunayRefinementSurfaceSample::HasChanged(const DelaunayRefinementSurfacePatches::PatchType & patch,
                                            const DelaunayRefinementPointGrid &                 forgotten) const
{
  return m_LocalDelta.HasChanged(patch) ||
         (!forgotten.GetPoints().empty() &&
          forgotten.HasPointWithin(patch.center, patch.radius + CoverageShare * m_LocalDelta.GetMaximum()));
}

DelaunayRefinementPointGrid
DelaunayRefinementSurfaceSample::TakeOutForgotten()
{
  if (m_Forgotten.empty())
  {
    return {};
  }
  const std::vector<PointType> all = m_Grid.GetPoints();
  DelaunayRefinementPointGrid  forgotten = this->MakeGrid();
  m_Grid = this->MakeGrid();
  for (const PointType & point : all)
  {
    // A vertex may have come back to where it was: each that is gone is one less.
    const auto found = m_Forgotten.find(point);
    (found != m_Forgotten.end() ? forgotten : m_Grid).Add(point);
    if (found != m_Forgotten.end())
    {
      m_Forgotten.erase(found);
    }
  }
  m_Forgotten.clear();
  return forgotten;
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
DelaunayRefinementSurfaceSample::Certify(std::vector<PointType> &      points,
                                         DelaunayRefinementThreads &   threads,
                                         const std::function<bool()> & keepGoing)
{
  using PatchesType = DelaunayRefinementSurfacePatches;
  using SamplerType = DelaunayRefinementBlockSampler;

  PatchesType                       roots = m_Oracle.GetSurfacePatches();
  const DelaunayRefinementPointGrid forgotten = this->TakeOutForgotten();
  if (m_LocalDelta.IsSettled())
  {
    PatchesType changed(roots.GetOrigin());
    for (std::size_t i = 0; i < roots.GetSize(); ++i)
    {
      if (this->HasChanged(roots.Get(i), forgotten))
      {
        changed.Add(roots, i);
      }
    }
    std::swap(roots, changed);
  }
  DelaunayRefinementPatchCover cover(roots, m_LocalDelta.GetMaximum());
  std::atomic<bool>            isStopped{ false };
  std::size_t                  numberOfVisits = 0;
  std::vector<SamplerType>     samplers;
  samplers.reserve(threads.GetNumberOfThreads());
  for (unsigned int thread = 0; thread < threads.GetNumberOfThreads(); ++thread)
  {
    const auto mayVisit = [&, isCaller = thread == 0](std::size_t numberOfPatches) {
      if (isCaller && !isStopped.load(std::memory_order_relaxed))
      {
        const std::size_t before = numberOfVisits / VisitsBetweenQuestions;
        numberOfVisits += numberOfPatches;
        if (numberOfVisits / VisitsBetweenQuestions != before && !keepGoing())
        {
          isStopped.store(true, std::memory_order_relaxed);
        }
      }
      return !isStopped.load(std::memory_order_relaxed);
    };
    samplers.emplace_back(m_Oracle, m_LocalDelta, m_RoundToFloat, m_Grid, cover, mayVisit);
  }
  const bool isShared = cover.GetNumberOfBlocks() >= LeastBlocksForThreads;
  const auto run = [&](std::size_t numberOfBlocks, const auto & task) {
    if (isShared)
    {
      threads.Run(numberOfBlocks, [&](std::size_t item, unsigned int thread) { task(item, samplers[thread]); });
      return;
    }
    for (std::size_t item = 0; item < numberOfBlocks; ++item)
    {
      task(item, samplers.front());
    }
  };

  run(cover.GetNumberOfBlocks(), [&](std::size_t block, SamplerType & sampler) { sampler.Collect(roots, block); });
  if (isStopped)
  {
    return false;
  }
  DelaunayRefinementPatchCover::NumbersType scratch;
  for (const PointType & vertex : m_Grid.GetPoints())
  {
    cover.CoverFrom(vertex, scratch);
  }
  const auto                          colors = cover.GetColors();
  std::vector<std::vector<PointType>> found;
  for (const auto work : { &SamplerType::Sample, &SamplerType::Cover })
  {
    for (const auto & blocks : colors)
    {
      found.resize(blocks.size());
      run(blocks.size(), [&](std::size_t item, SamplerType & sampler) { found[item] = (sampler.*work)(blocks[item]); });
      if (isStopped)
      {
        return false;
      }
      for (const auto & pointsOfBlock : found)
      {
        std::for_each(
          pointsOfBlock.begin(), pointsOfBlock.end(), [this](const PointType & point) { m_Grid.Add(point); });
        points.insert(points.end(), pointsOfBlock.begin(), pointsOfBlock.end());
      }
    }
  }
  return true;
}
} // end namespace itk
