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
/** R1 inserts points at this share of delta from others, so that what is left over is certainly within delta. */
constexpr double Separation = 0.999;

/** Edge of the cubes in which vertices are looked up, over delta. */
constexpr double CubeSize = 2.0;

/** Patches smaller than this share of delta are judged by their point alone. */
constexpr double SmallestPatch = 1e-5;

constexpr std::size_t VisitsBetweenQuestions = 16384;

/** Patches larger than this share of delta are visited in a random order. */
constexpr double LargePatch = 0.4;

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
  , m_Open(oracle.GetSurfacePatches())
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

double
DelaunayRefinementSurfaceSample::GetLeastDelta(const PatchType & patch) const
{
  if (m_LocalDelta.IsUniform())
  {
    return m_LocalDelta.GetMaximum();
  }
  return patch.radius < SmallPatch * m_LocalDelta.GetMinimum()
           ? m_LocalDelta.GetAt(patch.center)
           : m_LocalDelta.GetMinimumWithin(patch.center, patch.radius);
}

DelaunayRefinementSurfaceSample::PatchState
DelaunayRefinementSurfaceSample::Visit(const PatchType & patch, std::vector<PointType> & points)
{
  const double reach = this->GetLeastDelta(patch) - patch.radius;
  if (reach > 0.0 && m_Grid.FindSquaredDistance(patch.center, reach, reach) <= reach * reach)
  {
    return PatchState::COVERED;
  }
  PointType point;
  if (!m_Oracle.FindPointOfPatch(patch, point))
  {
    return PatchState::COVERED;
  }
  const double own = m_LocalDelta.IsUniform() ? m_LocalDelta.GetMaximum() : m_LocalDelta.GetAt(point);
  const double apart = Separation * own;
  if (m_Grid.FindSquaredDistance(point, apart, apart) >= apart * apart)
  {
    if (m_RoundToFloat)
    {
      std::transform(
        point.begin(), point.end(), point.begin(), [](double x) { return static_cast<double>(static_cast<float>(x)); });
    }
    m_Grid.Add(point);
    points.push_back(point);
    return DelaunayRefinementGeometry::Distance(point, patch.center) <= reach ? PatchState::COVERED : PatchState::OPEN;
  }
  return patch.radius < SmallestPatch * own ? PatchState::COVERED : PatchState::OPEN;
}

void
DelaunayRefinementSurfaceSample::Add(const PointType & point)
{
  m_Grid.Add(point);
}

bool
DelaunayRefinementSurfaceSample::Certify(std::vector<PointType> & points, const std::function<bool()> & keepGoing)
{
  std::size_t numberOfVisits = 0;
  const auto  mayVisit = [&] { return ++numberOfVisits % VisitsBetweenQuestions != 0 || keepGoing(); };

  // Large patches in a random order, which keeps the sample sparse.
  while (!m_Open.empty() && m_Open.front().radius > LargePatch * m_LocalDelta.GetMaximum())
  {
    std::vector<char> isOpen(m_Open.size());
    for (const std::uint32_t i : MakeRandomOrder(m_Open.size()))
    {
      if (!mayVisit())
      {
        return false;
      }
      isOpen[i] = this->Visit(m_Open[i], points) == PatchState::OPEN ? 1 : 0;
    }
    std::vector<PatchType> parts;
    for (std::size_t i = 0; i < m_Open.size(); ++i)
    {
      if (isOpen[i])
      {
        m_Oracle.SplitSurfacePatch(m_Open[i], parts);
      }
    }
    m_Open.swap(parts);
  }
  // What they left open in the oracle's order, which keeps neighbors together.
  std::vector<PatchType> stack;
  for (const PatchType & patch : m_Open)
  {
    stack.assign(1, patch);
    while (!stack.empty())
    {
      if (!mayVisit())
      {
        return false;
      }
      const PatchType top = stack.back();
      stack.pop_back();
      if (this->Visit(top, points) == PatchState::OPEN)
      {
        m_Oracle.SplitSurfacePatch(top, stack);
      }
    }
  }
  m_Open.clear();
  return true;
}

void
DelaunayRefinementSurfaceSample::Reopen()
{
  m_Open = m_Oracle.GetSurfacePatches();
}
} // end namespace itk
