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
#include "itkDelaunayRefinementManifoldRepair.h"

#include "itkDelaunayRefinementBoundaryVertices.h"
#include "itkDelaunayRefinementFlatTetrahedra.h"

#include <algorithm>
#include <deque>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** The cosine of an angle a hair above 30 degrees. */
constexpr double LargestCosine = 0.86602540378443865 * (1.0 - 1e-9);

template <typename TElement>
bool
Contains(const std::vector<TElement> & elements, const TElement & element)
{
  return std::find(elements.begin(), elements.end(), element) != elements.end();
}
} // namespace

DelaunayRefinementManifoldRepair::DelaunayRefinementManifoldRepair(const DelaunayRefinementOracle & oracle,
                                                                   const DelaunayRefinementRules &  rules,
                                                                   DelaunayRefinementComplex &      complex,
                                                                   DelaunayRefinementThreads &      threads,
                                                                   double                           smallestAngle)
  : m_Oracle(oracle)
  , m_Rules(rules)
  , m_Complex(complex)
  , m_Threads(threads)
  , m_Angles(smallestAngle)
{}

std::vector<DelaunayRefinementManifoldRepair::IndexType>
DelaunayRefinementManifoldRepair::Run()
{
  const std::vector<IndexType> found = FindNonManifoldDelaunayRefinementVertices(m_Complex, m_Threads);
  std::deque<IndexType>        vertices(found.begin(), found.end());
  std::vector<IndexType>       left;
  m_IsBad.assign(m_Complex.GetTriangulation().GetNumberOfVertexIndexes(), false);
  for (const IndexType vertex : found)
  {
    m_IsBad[vertex] = true;
  }
  while (!vertices.empty())
  {
    const IndexType vertex = vertices.front();
    vertices.pop_front();
    if (!m_IsBad[vertex])
    {
      continue;
    }
    if (!this->Mend(vertex))
    {
      left.push_back(vertex);
      continue;
    }
    for (std::size_t i = 0; i < m_Concerned.size(); ++i)
    {
      m_IsBad[m_Concerned[i]] = m_BadAfter[i] > 0;
      if (m_BadAfter[i] > 0)
      {
        // It may find help now.
        vertices.push_back(m_Concerned[i]);
      }
    }
  }
  std::sort(left.begin(), left.end());
  left.erase(std::unique(left.begin(), left.end()), left.end());
  left.erase(std::remove_if(left.begin(), left.end(), [this](IndexType vertex) { return !m_IsBad[vertex]; }),
             left.end());
  return left;
}

void
DelaunayRefinementManifoldRepair::Undo()
{
  for (const auto & [cell, region] : m_OwnRegions)
  {
    m_Complex.SetRegion(cell, region);
  }
  m_OwnRegions.clear();
}

bool
DelaunayRefinementManifoldRepair::Mend(IndexType vertex)
{
  m_Star.Find(m_Complex, vertex);
  const unsigned int numberBefore = m_Star.CountBadPlaces();
  m_Candidates.clear();
  m_CellsOfCandidates.clear();
  m_NextSets = SetsEnum::CELLS;
  const std::vector<RegionType> regions = m_Star.GetRegions();
  std::vector<IndexType>        cells;
  const unsigned int            numberOfTurns = m_Angles.IsBounded() ? 2 : 1;
  for (unsigned int turn = 0; turn < numberOfTurns; ++turn)
  {
    for (std::size_t i = 0; i < m_Candidates.size() || this->AddMoreCandidates(); ++i)
    {
      // The vertex itself is quickly asked.
      const CandidateType candidate = m_Candidates[i];
      cells.clear();
      for (std::size_t j = candidate.begin; j < candidate.end; ++j)
      {
        const std::uint32_t number = m_CellsOfCandidates[j];
        m_Star.GetRegions()[number] = candidate.region;
        cells.push_back(m_Star.GetCells()[number].index);
      }
      const bool isBetter = m_Star.CountBadPlaces() < numberBefore;
      m_Star.GetRegions() = regions;
      if (isBetter && this->MayChange(cells, candidate.region, turn > 0) &&
          this->LeavesFewerBad(cells, candidate.region))
      {
        this->Change(cells, candidate.region);
        return true;
      }
    }
  }
  return false;
}

void
DelaunayRefinementManifoldRepair::Change(const std::vector<IndexType> & cells, RegionType region)
{
  for (const IndexType cell : cells)
  {
    this->Give(cell, region);
  }
}

void
DelaunayRefinementManifoldRepair::Give(IndexType cell, RegionType region)
{
  const RegionType own = m_OwnRegions.emplace(cell, m_Complex.GetRegion(cell)).first->second;
  m_Complex.SetRegion(cell, region);
  if (own == region)
  {
    m_OwnRegions.erase(cell);
  }
}

bool
DelaunayRefinementManifoldRepair::AddMoreCandidates()
{
  const std::size_t numberBefore = m_Candidates.size();
  const auto &      cells = m_Star.GetCells();
  while (m_Candidates.size() == numberBefore && m_NextSets != SetsEnum::NONE)
  {
    switch (m_NextSets)
    {
      case SetsEnum::CELLS:
        for (std::uint32_t number = 0; number < cells.size(); ++number)
        {
          this->AddCandidates(&number, 1);
        }
        m_NextSets = SetsEnum::PAIRS;
        break;
      case SetsEnum::PAIRS:
        for (std::uint32_t number = 0; number < cells.size(); ++number)
        {
          for (const std::uint32_t neighbor : cells[number].neighbors)
          {
            if (number < neighbor && m_Star.GetRegions()[neighbor] == m_Star.GetRegions()[number])
            {
              const std::array<std::uint32_t, 2> pair{ number, neighbor };
              this->AddCandidates(pair.data(), pair.size());
            }
          }
        }
        m_NextSets = SetsEnum::PARTS;
        break;
      case SetsEnum::PARTS:
        m_Star.FindParts(m_Parts);
        for (const auto & part : m_Parts)
        {
          this->AddCandidates(part.data(), part.size());
        }
        m_NextSets = SetsEnum::NONE;
        break;
      case SetsEnum::NONE:
        break;
    }
  }
  return m_Candidates.size() > numberBefore;
}

void
DelaunayRefinementManifoldRepair::AddCandidates(const std::uint32_t * cells, std::size_t numberOfCells)
{
  const auto &      regions = m_Star.GetRegions();
  const std::size_t begin = m_CellsOfCandidates.size();
  m_RegionsBeside.clear();
  for (std::size_t i = 0; i < numberOfCells; ++i)
  {
    for (const std::uint32_t neighbor : m_Star.GetCells()[cells[i]].neighbors)
    {
      if (regions[neighbor] != regions[cells[i]] && !Contains(m_RegionsBeside, regions[neighbor]))
      {
        m_RegionsBeside.push_back(regions[neighbor]);
      }
    }
  }
  if (!m_RegionsBeside.empty())
  {
    m_CellsOfCandidates.insert(m_CellsOfCandidates.end(), cells, cells + numberOfCells);
  }
  for (const RegionType region : m_RegionsBeside)
  {
    m_Candidates.push_back({ begin, begin + numberOfCells, region });
  }
}

bool
DelaunayRefinementManifoldRepair::LeavesFewerBad(const std::vector<IndexType> & cells, RegionType region)
{
  m_Concerned.clear();
  for (const IndexType cell : cells)
  {
    for (const IndexType vertex : m_Complex.GetTriangulation().GetCell(cell).vertices)
    {
      if (!Contains(m_Concerned, vertex))
      {
        m_Concerned.push_back(vertex);
      }
    }
  }
  int gain = 0;
  m_BadAfter.assign(m_Concerned.size(), 0);
  // Good vertices can only become worse: they are asked as long as there is something to lose.
  for (const bool isBad : { true, false })
  {
    for (std::size_t i = 0; i < m_Concerned.size() && (isBad || gain > 0); ++i)
    {
      if (m_IsBad[m_Concerned[i]] != isBad)
      {
        continue;
      }
      m_OtherStar.Find(m_Complex, m_Concerned[i]);
      gain += isBad ? static_cast<int>(m_OtherStar.CountBadPlaces()) : 0;
      for (std::size_t j = 0; j < m_OtherStar.GetCells().size(); ++j)
      {
        if (Contains(cells, m_OtherStar.GetCells()[j].index))
        {
          m_OtherStar.GetRegions()[j] = region;
        }
      }
      m_BadAfter[i] = m_OtherStar.CountBadPlaces();
      gain -= static_cast<int>(m_BadAfter[i]);
    }
  }
  return gain > 0;
}

bool
DelaunayRefinementManifoldRepair::MayChange(const std::vector<IndexType> & cells, RegionType region, bool maySlivers)
{
  const auto & triangulation = m_Complex.GetTriangulation();
  for (const IndexType cell : cells)
  {
    for (unsigned int i = 0; i < 4; ++i)
    {
      const IndexType neighbor = triangulation.GetCell(cell).neighbors[i];
      // Facets that part regions already may go on to do so.
      if (!Contains(cells, neighbor) && m_Complex.GetRegion(neighbor) == m_Complex.GetRegion(cell) &&
          !this->MayPartRegions(cell, i))
      {
        return false;
      }
    }
  }
  if (region == 0)
  {
    return !this->WouldLoseComponent(cells);
  }
  return std::all_of(cells.begin(), cells.end(), [&](IndexType cell) {
    if (triangulation.IsInfinite(cell) || IsFlatDelaunayRefinementTetrahedron(m_Complex, cell))
    {
      return false;
    }
    const auto &     vertices = triangulation.GetCell(cell).vertices;
    const bool       isAwayFromBox = std::all_of(vertices.begin(), vertices.end(), [this](IndexType vertex) {
      return m_Complex.IsFeature(vertex) || m_Complex.GetKind(vertex) == DelaunayRefinementEnums::VertexKind::FREE;
    });
    const RegionType own = m_Complex.GetRegion(cell);
    m_Complex.SetRegion(cell, region);
    const bool fires = m_Rules.FiresR4(cell) || m_Rules.FiresCellSize(cell) || m_Rules.FiresR4Prime(cell);
    m_Complex.SetRegion(cell, own);
    const auto p = m_Complex.GetPoints(cell);
    return isAwayFromBox && !fires && (maySlivers || !(m_Angles.ComputeBadness(p[0], p[1], p[2], p[3]) > 0.0));
  });
}

bool
DelaunayRefinementManifoldRepair::MayPartRegions(IndexType cell, unsigned int facet) const
{
  std::array<DelaunayRefinementPoint, 3> p;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const IndexType vertex = m_Complex.GetTriangulation().GetCell(cell).vertices[(facet + 1 + i) & 3];
    if (!m_Complex.IsFeature(vertex))
    {
      return false;
    }
    p[i] = m_Complex.GetPoint(vertex);
  }
  return Geometry::ComputeLargestCosine(p[0], p[1], p[2]) < LargestCosine;
}

bool
DelaunayRefinementManifoldRepair::WouldLoseComponent(const std::vector<IndexType> & cells) const
{
  const auto &     triangulation = m_Complex.GetTriangulation();
  const RegionType region = m_Complex.GetRegion(cells.front());
  for (const IndexType cell : cells)
  {
    for (const IndexType neighbor : triangulation.GetCell(cell).neighbors)
    {
      if (m_Complex.GetRegion(neighbor) == region && !Contains(cells, neighbor))
      {
        return false;
      }
    }
  }
  // They touch others in edges or vertices alone: all there is of a component, unless the others around are of it, too.
  const auto   component = m_Oracle.FindComponent(m_Complex.GetCircumcenter(cells.front()));
  const auto & around = m_Star.GetCells();
  return std::none_of(around.begin(), around.end(), [&](const auto & other) {
    return m_Complex.GetRegion(other.index) == region && !Contains(cells, other.index) &&
           m_Oracle.FindComponent(m_Complex.GetCircumcenter(other.index)) == component;
  });
}
} // end namespace itk
