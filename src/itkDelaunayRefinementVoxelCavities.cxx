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
  for (std::int32_t z = 0; z < m_Size[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Size[1]; ++y)
    {
      if (y > 0)
      {
        this->JoinRows(components, { 0, y, z }, { 0, y - 1, z });
      }
      if (z > 0)
      {
        this->JoinRows(components, { 0, y, z }, { 0, y, z - 1 });
      }
    }
  }
  // The first gap of a cavity is its root; those of the outside go.
  for (std::uint32_t i = 1; i < m_Gaps.size(); ++i)
  {
    m_Gaps[i].cavity = this->FindRoot(i);
  }
  std::size_t                kept = 0;
  std::vector<std::uint32_t> numbers(m_Gaps.size(), None);
  for (std::size_t i = 1; i < m_Gaps.size(); ++i)
  {
    const GapType gap = m_Gaps[i];
    if (gap.cavity == 0)
    {
      continue;
    }
    if (gap.cavity == i)
    {
      numbers[i] = static_cast<std::uint32_t>(m_Cavities.size());
      const auto y = static_cast<std::int32_t>(gap.row % m_Size[1]);
      const auto z = static_cast<std::int32_t>(gap.row / m_Size[1]);
      m_Cavities.push_back({ 0, { gap.first, y, z } });
    }
    m_Gaps[kept] = { gap.row, gap.first, gap.last, numbers[gap.cavity] };
    m_Cavities[m_Gaps[kept].cavity].numberOfVoxels += static_cast<std::size_t>(gap.last - gap.first + 1);
    ++kept;
  }
  m_Gaps.resize(kept);
  m_FirstGaps.clear();
}

void
DelaunayRefinementVoxelCavities::FindGaps(const DelaunayRefinementVoxelComponents & components)
{
  const auto & runs = components.GetRuns();
  m_Gaps.push_back({ 0, 0, -1, 0 });
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
          m_Gaps.push_back({ this->ToRow(y, z), runs[i].last + 1, runs[i + 1].first - 1, isBorder ? 0 : number });
        }
      }
    }
  }
  m_FirstGaps.push_back(static_cast<std::uint32_t>(m_Gaps.size()));
}

void
DelaunayRefinementVoxelCavities::JoinRows(const DelaunayRefinementVoxelComponents & components,
                                          const IndexType &                         row,
                                          const IndexType &                         other)
{
  // The first and the last voxel of a row that the object has.
  const auto findEnds = [&](const IndexType & place) -> std::pair<std::int32_t, std::int32_t> {
    const std::size_t begin = components.GetFirstRun(place[1], place[2]);
    const std::size_t end = components.GetFirstRun(place[1] + 1, place[2]);
    return begin == end ? std::make_pair(m_Size[0], -1)
                        : std::make_pair(components.GetRuns()[begin].first, components.GetRuns()[end - 1].last);
  };
  const auto joinToOutside = [&](std::uint32_t begin, std::uint32_t end, const IndexType & place) {
    if (begin < end)
    {
      const auto ends = findEnds(place);
      for (std::uint32_t i = begin; i < end; ++i)
      {
        if (m_Gaps[i].first < ends.first || m_Gaps[i].last > ends.second)
        {
          this->Join(i, 0);
        }
      }
    }
  };
  std::uint32_t       i = m_FirstGaps[this->ToRow(row[1], row[2])];
  std::uint32_t       j = m_FirstGaps[this->ToRow(other[1], other[2])];
  const std::uint32_t endI = m_FirstGaps[this->ToRow(row[1], row[2]) + 1];
  const std::uint32_t endJ = m_FirstGaps[this->ToRow(other[1], other[2]) + 1];
  joinToOutside(i, endI, other);
  joinToOutside(j, endJ, row);
  while (i < endI && j < endJ)
  {
    if (m_Gaps[i].first <= m_Gaps[j].last && m_Gaps[j].first <= m_Gaps[i].last)
    {
      this->Join(i, j);
    }
    ++(m_Gaps[i].last < m_Gaps[j].last ? i : j);
  }
}

std::uint32_t
DelaunayRefinementVoxelCavities::FindRoot(std::uint32_t gap)
{
  while (m_Gaps[gap].cavity != gap)
  {
    m_Gaps[gap].cavity = m_Gaps[m_Gaps[gap].cavity].cavity;
    gap = m_Gaps[gap].cavity;
  }
  return gap;
}

void
DelaunayRefinementVoxelCavities::Join(std::uint32_t a, std::uint32_t b)
{
  const std::uint32_t rootA = this->FindRoot(a);
  const std::uint32_t rootB = this->FindRoot(b);
  m_Gaps[std::max(rootA, rootB)].cavity = std::min(rootA, rootB);
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
  const std::size_t row = this->ToRow(voxel[1], voxel[2]);
  const auto        gap = std::partition_point(m_Gaps.begin(), m_Gaps.end(), [&](const GapType & g) {
    return g.row < row || (g.row == row && g.last < voxel[0]);
  });
  return gap != m_Gaps.end() && gap->row == row && gap->first <= voxel[0] ? gap->cavity : None;
}
} // end namespace itk
