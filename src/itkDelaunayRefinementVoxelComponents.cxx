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
#include "itkDelaunayRefinementVoxelComponents.h"

#include "itkDelaunayRefinementBits.h"

#include <algorithm>
#include <limits>

namespace itk
{
namespace
{
using ComponentType = DelaunayRefinementVoxelComponents::ComponentType;

ComponentType
FindRoot(std::vector<ComponentType> & parents, ComponentType node)
{
  while (parents[node] != node)
  {
    parents[node] = parents[parents[node]];
    node = parents[node];
  }
  return node;
}

/** The lowest bit at or after \c from for which the words are \c value. */
std::int32_t
FindBit(const std::uint64_t * words, std::int32_t from, std::int32_t end, bool value)
{
  while (from < end)
  {
    const std::uint64_t word = (value ? words[from >> 6] : ~words[from >> 6]) >> (from & 63);
    if (word != 0)
    {
      return std::min(end, from + static_cast<std::int32_t>(FindDelaunayRefinementBit(word)));
    }
    from = (from | 63) + 1;
  }
  return end;
}
} // namespace

DelaunayRefinementVoxelComponents::DelaunayRefinementVoxelComponents(const DelaunayRefinementVoxelMask & mask)
  : m_Size(mask.GetSize())
{
  this->FindRuns(mask);
  std::vector<ComponentType> parents(m_Runs.size());
  for (std::size_t i = 0; i < parents.size(); ++i)
  {
    parents[i] = static_cast<ComponentType>(i);
  }
  const std::size_t rowsPerSlice = m_Size[1];
  for (std::int32_t z = 0; z < m_Size[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Size[1]; ++y)
    {
      const std::size_t row = static_cast<std::size_t>(z) * rowsPerSlice + y;
      // Two voxels are joined if at most two of their indexes differ, by one.
      if (y > 0)
      {
        this->JoinRows(row, row - 1, 1, parents);
      }
      if (z > 0)
      {
        this->JoinRows(row, row - rowsPerSlice, 1, parents);
        if (y > 0)
        {
          this->JoinRows(row, row - rowsPerSlice - 1, 0, parents);
        }
        if (y + 1 < m_Size[1])
        {
          this->JoinRows(row, row - rowsPerSlice + 1, 0, parents);
        }
      }
    }
  }
  std::vector<ComponentType> numbers(m_Runs.size(), std::numeric_limits<ComponentType>::max());
  ComponentType              next = 0;
  for (std::size_t i = 0; i < m_Runs.size(); ++i)
  {
    ComponentType & number = numbers[FindRoot(parents, static_cast<ComponentType>(i))];
    if (number == std::numeric_limits<ComponentType>::max())
    {
      number = next++;
    }
    m_Runs[i].component = number;
  }
  m_Components.resize(next);
  this->Summarize();
}

void
DelaunayRefinementVoxelComponents::FindRuns(const DelaunayRefinementVoxelMask & mask)
{
  m_FirstRuns.reserve(static_cast<std::size_t>(m_Size[1]) * m_Size[2] + 1);
  const std::int32_t end = m_Size[0] + 1;
  for (std::int32_t z = 0; z < m_Size[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Size[1]; ++y)
    {
      m_FirstRuns.push_back(m_Runs.size());
      const std::uint64_t * words = mask.GetRow(y + 1, z + 1);
      std::int32_t          bit = FindBit(words, 1, end, true);
      while (bit < end)
      {
        const std::int32_t after = FindBit(words, bit, end, false);
        m_Runs.push_back({ bit - 1, after - 2, 0 });
        bit = FindBit(words, after, end, true);
      }
    }
  }
  m_FirstRuns.push_back(m_Runs.size());
}

void
DelaunayRefinementVoxelComponents::JoinRows(std::size_t                  row,
                                            std::size_t                  other,
                                            std::int32_t                 reach,
                                            std::vector<ComponentType> & parents) const
{
  std::size_t       i = m_FirstRuns[row];
  std::size_t       j = m_FirstRuns[other];
  const std::size_t endI = m_FirstRuns[row + 1];
  const std::size_t endJ = m_FirstRuns[other + 1];
  while (i < endI && j < endJ)
  {
    if (m_Runs[i].first <= m_Runs[j].last + reach && m_Runs[j].first <= m_Runs[i].last + reach)
    {
      const ComponentType a = FindRoot(parents, static_cast<ComponentType>(i));
      const ComponentType b = FindRoot(parents, static_cast<ComponentType>(j));
      parents[std::max(a, b)] = std::min(a, b);
    }
    if (m_Runs[i].last < m_Runs[j].last)
    {
      ++i;
    }
    else
    {
      ++j;
    }
  }
}

void
DelaunayRefinementVoxelComponents::Summarize()
{
  constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();
  for (ComponentInfoType & info : m_Components)
  {
    info = { 0, {}, { largest, largest, largest }, { -1, -1, -1 } };
  }
  for (std::int32_t z = 0; z < m_Size[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Size[1]; ++y)
    {
      const std::size_t row = static_cast<std::size_t>(z) * m_Size[1] + y;
      for (std::size_t i = m_FirstRuns[row]; i < m_FirstRuns[row + 1]; ++i)
      {
        const RunType &     run = m_Runs[i];
        ComponentInfoType & info = m_Components[run.component];
        if (info.numberOfVoxels == 0)
        {
          info.firstVoxel = { run.first, y, z };
        }
        info.numberOfVoxels += static_cast<std::size_t>(run.last - run.first + 1);
        info.minimum = { std::min(info.minimum[0], run.first),
                         std::min(info.minimum[1], y),
                         std::min(info.minimum[2], z) };
        info.maximum = { std::max(info.maximum[0], run.last),
                         std::max(info.maximum[1], y),
                         std::max(info.maximum[2], z) };
      }
    }
  }
}

void
DelaunayRefinementVoxelComponents::Remove(const std::vector<bool> & isRemoved, DelaunayRefinementVoxelMask & mask)
{
  std::vector<ComponentType> numbers(m_Components.size());
  ComponentType              next = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = next;
    next += isRemoved[i] ? 0 : 1;
  }
  std::vector<RunType> kept;
  std::size_t          row = 0;
  for (std::int32_t z = 0; z < m_Size[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Size[1]; ++y, ++row)
    {
      const std::size_t begin = m_FirstRuns[row];
      m_FirstRuns[row] = kept.size();
      for (std::size_t i = begin; i < m_FirstRuns[row + 1]; ++i)
      {
        const RunType & run = m_Runs[i];
        if (isRemoved[run.component])
        {
          mask.ClearRun(run.first, run.last, y, z);
        }
        else
        {
          kept.push_back({ run.first, run.last, numbers[run.component] });
        }
      }
    }
  }
  m_FirstRuns[row] = kept.size();
  m_Runs.swap(kept);
  m_Components.resize(next);
  this->Summarize();
}

DelaunayRefinementVoxelComponents::ComponentType
DelaunayRefinementVoxelComponents::Find(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  const std::size_t row = static_cast<std::size_t>(z) * m_Size[1] + y;
  const auto        begin = m_Runs.begin() + static_cast<std::ptrdiff_t>(m_FirstRuns[row]);
  const auto        end = m_Runs.begin() + static_cast<std::ptrdiff_t>(m_FirstRuns[row + 1]);
  const auto after = std::upper_bound(begin, end, x, [](std::int32_t a, const RunType & run) { return a < run.first; });
  return after == begin ? 0 : (after - 1)->component;
}
} // end namespace itk
