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
#include "itkDelaunayRefinementVoxelCavities.h"

#include <algorithm>

namespace itk
{
DelaunayRefinementVoxelCavities::DelaunayRefinementVoxelCavities(const DelaunayRefinementVoxelComponents & components,
                                                                 const DelaunayRefinementVoxelMask::SizeType & size)
  : m_Size(size)
{
  this->FindGaps(components);
  const auto rowsPerSlice = static_cast<std::size_t>(m_Size[1]);
  DelaunayRefinementVoxelMask::VisitRows(
    m_Size, 0, m_FirstGaps.size() - 1, [&](std::size_t row, std::int32_t y, std::int32_t z) {
      if (m_FirstGaps[row] == m_FirstGaps[row + 1])
      {
        return;
      }
      if (!this->IsAtBorder(y, z))
      {
        for (const std::size_t other : { row - 1, row + 1, row - rowsPerSlice, row + rowsPerSlice })
        {
          this->JoinToOutside(components, row, other);
        }
      }
      if (y > 0)
      {
        this->JoinRows(row, row - 1);
      }
      if (z > 0)
      {
        this->JoinRows(row, row - rowsPerSlice);
      }
    });
  this->NumberCavities();
}

void
DelaunayRefinementVoxelCavities::FindGaps(const DelaunayRefinementVoxelComponents & components)
{
  const auto &      runs = components.GetRuns();
  const std::size_t rows = static_cast<std::size_t>(m_Size[1]) * m_Size[2];
  m_Gaps.push_back({ 0, -1, 0 });
  m_FirstGaps.resize(rows + 1);
  DelaunayRefinementVoxelMask::VisitRows(m_Size, 0, rows, [&](std::size_t row, std::int32_t y, std::int32_t z) {
    m_FirstGaps[row] = static_cast<std::uint32_t>(m_Gaps.size());
    const std::size_t end = components.GetFirstRun(row + 1);
    for (std::size_t i = components.GetFirstRun(row); i + 1 < end; ++i)
    {
      if (runs[i].last + 1 < runs[i + 1].first)
      {
        const auto number = static_cast<std::uint32_t>(m_Gaps.size());
        m_Gaps.push_back({ runs[i].last + 1, runs[i + 1].first - 1, this->IsAtBorder(y, z) ? 0 : number });
      }
    }
  });
  m_FirstGaps[rows] = static_cast<std::uint32_t>(m_Gaps.size());
}

bool
DelaunayRefinementVoxelCavities::IsAtBorder(std::int32_t y, std::int32_t z) const
{
  return y == 0 || z == 0 || y == m_Size[1] - 1 || z == m_Size[2] - 1;
}

void
DelaunayRefinementVoxelCavities::JoinRows(std::size_t row, std::size_t other)
{
  std::uint32_t       i = m_FirstGaps[row];
  std::uint32_t       j = m_FirstGaps[other];
  const std::uint32_t endI = m_FirstGaps[row + 1];
  const std::uint32_t endJ = m_FirstGaps[other + 1];
  while (i < endI && j < endJ)
  {
    if (m_Gaps[i].root != m_Gaps[j].root && m_Gaps[i].first <= m_Gaps[j].last && m_Gaps[j].first <= m_Gaps[i].last)
    {
      this->Join(i, j);
    }
    ++(m_Gaps[i].last < m_Gaps[j].last ? i : j);
  }
}

void
DelaunayRefinementVoxelCavities::JoinToOutside(const DelaunayRefinementVoxelComponents & components,
                                               std::size_t                               row,
                                               std::size_t                               other)
{
  const auto *      runs = components.GetRuns().data();
  const std::size_t firstRun = components.GetFirstRun(other);
  const std::size_t endOfRuns = components.GetFirstRun(other + 1);
  for (std::uint32_t i = m_FirstGaps[row]; i < m_FirstGaps[row + 1]; ++i)
  {
    if (m_Gaps[i].root != 0 &&
        (firstRun == endOfRuns || m_Gaps[i].first < runs[firstRun].first || m_Gaps[i].last > runs[endOfRuns - 1].last))
    {
      this->Join(i, 0);
    }
  }
}

void
DelaunayRefinementVoxelCavities::NumberCavities()
{
  // The first gap of a cavity is its root.
  for (std::uint32_t i = 1; i < m_Gaps.size(); ++i)
  {
    m_Gaps[i].root = this->FindRoot(i);
  }
  std::vector<std::uint32_t> numbers(m_Gaps.size(), None);
  std::uint32_t              kept = 0;
  std::uint32_t              next = 1;
  const std::size_t          rows = m_FirstGaps.size() - 1;
  DelaunayRefinementVoxelMask::VisitRows(m_Size, 0, rows, [&](std::size_t row, std::int32_t y, std::int32_t z) {
    m_FirstGaps[row] = kept;
    for (const std::uint32_t end = m_FirstGaps[row + 1]; next < end; ++next)
    {
      const GapType gap = m_Gaps[next];
      if (gap.root == 0)
      {
        continue;
      }
      const IndexType first{ gap.first, y, z };
      if (gap.root == next)
      {
        numbers[next] = static_cast<std::uint32_t>(m_Cavities.size());
        m_Cavities.push_back({ 0, first, first, first });
      }
      m_Gaps[kept] = { gap.first, gap.last, numbers[gap.root] };
      CavityType & cavity = m_Cavities[m_Gaps[kept].root];
      cavity.numberOfVoxels += static_cast<std::size_t>(gap.last - gap.first + 1);
      const IndexType last{ gap.last, first[1], first[2] };
      for (unsigned int i = 0; i < 3; ++i)
      {
        cavity.least[i] = std::min(cavity.least[i], first[i]);
        cavity.greatest[i] = std::max(cavity.greatest[i], last[i]);
      }
      ++kept;
    }
  });
  m_FirstGaps.back() = kept;
  m_Gaps.resize(kept);
  m_Gaps.shrink_to_fit();
}

std::uint32_t
DelaunayRefinementVoxelCavities::FindRoot(std::uint32_t gap)
{
  while (m_Gaps[gap].root != gap)
  {
    m_Gaps[gap].root = m_Gaps[m_Gaps[gap].root].root;
    gap = m_Gaps[gap].root;
  }
  return gap;
}

void
DelaunayRefinementVoxelCavities::Join(std::uint32_t a, std::uint32_t b)
{
  const std::uint32_t rootA = this->FindRoot(a);
  const std::uint32_t rootB = this->FindRoot(b);
  const std::uint32_t root = std::min(rootA, rootB);
  m_Gaps[std::max(rootA, rootB)].root = root;
  // A shorter way for the next rows.
  m_Gaps[a].root = root;
  m_Gaps[b].root = root;
}

std::uint32_t
DelaunayRefinementVoxelCavities::Find(const IndexType & voxel) const
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (voxel[i] < 0 || voxel[i] >= m_Size[i])
    {
      return None;
    }
  }
  const std::size_t row = static_cast<std::size_t>(voxel[2]) * m_Size[1] + voxel[1];
  const auto        begin = m_Gaps.begin() + m_FirstGaps[row];
  const auto        end = m_Gaps.begin() + m_FirstGaps[row + 1];
  const auto        gap = std::partition_point(begin, end, [&voxel](const GapType & g) { return g.last < voxel[0]; });
  return gap != end && gap->first <= voxel[0] ? gap->root : None;
}
} // end namespace itk
