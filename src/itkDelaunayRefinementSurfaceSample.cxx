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
{
  this->Reopen();
}

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

bool
DelaunayRefinementSurfaceSample::Cover(OpenPatchType & open, bool isUniform, std::vector<PointType> & points)
{
  const PatchType & patch = open.patch;
  const double      reach = (isUniform ? m_LocalDelta.GetMaximum() : this->GetLeastDelta(patch)) - patch.radius;
  if (reach > 0.0)
  {
    const auto covers = [&](std::int32_t vertex) {
      return vertex != DelaunayRefinementPointGrid::None &&
             Geometry::SquaredDistance(patch.center, m_Grid.GetPoint(vertex)) <= reach * reach;
    };
    if (covers(open.vertex))
    {
      return true;
    }
    const std::int32_t nearest = m_Grid.FindNearest(patch.center, reach, reach);
    if (nearest != DelaunayRefinementPointGrid::None)
    {
      return true;
    }
  }
  PointType point;
  if (!m_Oracle.FindPointOfPatch(patch, point))
  {
    return true;
  }
  const double own = isUniform ? m_LocalDelta.GetMaximum() : m_LocalDelta.GetAt(point);
  const double apart = Separation * own;
  open.vertex = m_Grid.FindNearest(point, apart, 0.5 * apart);
  if (open.vertex == DelaunayRefinementPointGrid::None)
  {
    if (m_RoundToFloat)
    {
      std::transform(point.begin(), point.end(), point.begin(), Geometry::RoundToFloat);
    }
    open.vertex = m_Grid.Add(point);
    points.push_back(point);
    return Geometry::Distance(point, patch.center) <= reach;
  }
  return patch.radius < SmallestPatch * own;
}

void
DelaunayRefinementSurfaceSample::Split(const OpenPatchType & open, std::vector<OpenPatchType> & parts)
{
  m_Parts.clear();
  m_Oracle.SplitSurfacePatch(open.patch, m_Parts);
  for (const PatchType & part : m_Parts)
  {
    parts.push_back({ part, open.vertex });
  }
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
  const double largest = LargePatch * m_LocalDelta.GetMaximum();
  while (!m_Open.empty() && m_Open.front().patch.radius > largest)
  {
    std::vector<char> isCovered(m_Open.size());
    for (const std::uint32_t i : MakeRandomOrder(m_Open.size()))
    {
      if (!mayVisit())
      {
        return false;
      }
      isCovered[i] = this->Cover(m_Open[i], m_LocalDelta.IsUniform(), points) ? 1 : 0;
    }
    std::vector<OpenPatchType> parts;
    for (std::size_t i = 0; i < m_Open.size(); ++i)
    {
      if (!isCovered[i])
      {
        this->Split(m_Open[i], parts);
      }
    }
    m_Open.swap(parts);
  }
  // What they left open in the oracle's order, which keeps neighbors together.
  std::vector<OpenPatchType> stack;
  for (const OpenPatchType & open : m_Open)
  {
    const bool isUniform =
      m_LocalDelta.GetMinimumWithin(open.patch.center, open.patch.radius) == m_LocalDelta.GetMaximum();
    stack.assign(1, open);
    while (!stack.empty())
    {
      if (!mayVisit())
      {
        return false;
      }
      OpenPatchType top = stack.back();
      stack.pop_back();
      if (!this->Cover(top, isUniform, points))
      {
        this->Split(top, stack);
      }
    }
  }
  m_Open.clear();
  return true;
}

void
DelaunayRefinementSurfaceSample::Reopen()
{
  m_Open.clear();
  for (const PatchType & patch : m_Oracle.GetSurfacePatches())
  {
    m_Open.push_back({ patch, DelaunayRefinementPointGrid::None });
  }
}
} // end namespace itk
