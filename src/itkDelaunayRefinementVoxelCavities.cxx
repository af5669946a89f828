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
  for (std::size_t row = 1; row < m_FirstGaps.size() - 1; ++row)
  {
    if (row % m_Size[1] != 0)
    {
      this->JoinRows(components, row, row - 1);
    }
    if (row >= static_cast<std::size_t>(m_Size[1]))
    {
      this->JoinRows(components, row, row - m_Size[1]);
    }
  }
  this->NumberCavities();
}

void
DelaunayRefinementVoxelCavities::FindGaps(const DelaunayRefinementVoxelComponents & components)
{
  const auto & runs = components.GetRuns();
  m_Gaps.push_back({ 0, -1, 0 });
  m_FirstGaps.reserve(static_cast<std::size_t>(m_Size[1]) * m_Size[2] + 1);
  for (std::int32_t z = 0; z < m_Size[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Size[1]; ++y)
    {
      m_FirstGaps.push_back(static_cast<std::uint32_t>(m_Gaps.size()));
      // Nothing surrounds the rows at the border.
      const bool        isBorder = y == 0 || z == 0 || y == m_Size[1] - 1 || z == m_Size[2] - 1;
      const std::size_t end = components.GetFirstRun(y + 1, z);
      for (std::size_t i = components.GetFirstRun(y, z); i + 1 < end; ++i)
      {
        if (runs[i].last + 1 < runs[i + 1].first)
        {
          const auto number = static_cast<std::uint32_t>(m_Gaps.size());
          m_Gaps.push_back({ runs[i].last + 1, runs[i + 1].first - 1, isBorder ? 0 : number });
        }
      }
    }
  }
  m_FirstGaps.push_back(static_cast<std::uint32_t>(m_Gaps.size()));
}

void
DelaunayRefinementVoxelCavities::JoinRows(const DelaunayRefinementVoxelComponents & components,
                                          std::size_t                               row,
                                          std::size_t                               other)
{
  std::uint32_t       i = m_FirstGaps[row];
  std::uint32_t       j = m_FirstGaps[other];
  const std::uint32_t endI = m_FirstGaps[row + 1];
  const std::uint32_t endJ = m_FirstGaps[other + 1];
  const auto          isOutside = [](const GapType & gap) { return gap.root == 0; };
  if (std::all_of(m_Gaps.begin() + i, m_Gaps.begin() + endI, isOutside) &&
      std::all_of(m_Gaps.begin() + j, m_Gaps.begin() + endJ, isOutside))
  {
    return;
  }
  this->JoinToOutside(components, i, endI, other);
  this->JoinToOutside(components, j, endJ, row);
  while (i < endI && j < endJ)
  {
    if (m_Gaps[i].first <= m_Gaps[j].last && m_Gaps[j].first <= m_Gaps[i].last)
    {
      this->Join(i, j);
    }
    ++(m_Gaps[i].last < m_Gaps[j].last ? i : j);
  }
}

void
DelaunayRefinementVoxelCavities::JoinToOutside(const DelaunayRefinementVoxelComponents & components,
                                               std::uint32_t                             begin,
                                               std::uint32_t                             end,
                                               std::size_t                               row)
{
  if (begin == end)
  {
    return;
  }
  const auto *      runs = components.GetRuns().data();
  const auto        y = static_cast<std::int32_t>(row % m_Size[1]);
  const auto        z = static_cast<std::int32_t>(row / m_Size[1]);
  const std::size_t firstRun = components.GetFirstRun(y, z);
  const std::size_t endOfRuns = components.GetFirstRun(y + 1, z);
  for (std::uint32_t i = begin; i < end; ++i)
  {
    if (firstRun == endOfRuns || m_Gaps[i].first < runs[firstRun].first || m_Gaps[i].last > runs[endOfRuns - 1].last)
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
  for (std::size_t row = 0; row + 1 < m_FirstGaps.size(); ++row)
  {
    m_FirstGaps[row] = kept;
    for (const std::uint32_t end = m_FirstGaps[row + 1]; next < end; ++next)
    {
      const GapType gap = m_Gaps[next];
      if (gap.root == 0)
      {
        continue;
      }
      const IndexType first{ gap.first,
                             static_cast<std::int32_t>(row % m_Size[1]),
                             static_cast<std::int32_t>(row / m_Size[1]) };
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
  }
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
  m_Gaps[std::max(rootA, rootB)].root = std::min(rootA, rootB);
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
