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
using ComponentInfoType = DelaunayRefinementVoxelComponents::ComponentInfoType;
using Threads = DelaunayRefinementThreads;

/** Fewer rows are no work for a thread. */
constexpr std::size_t LeastRowsPerPiece = 512;

/** The lowest bit at or after \c from that is set in a word that \c wordAt gives. */
template <typename TWordAt>
std::int32_t
FindBit(const TWordAt & wordAt, std::int32_t from, std::int32_t end)
{
  while (from < end)
  {
    const std::uint64_t word = wordAt(from >> 6) >> (from & 63);
    if (word != 0)
    {
      return std::min(end, from + static_cast<std::int32_t>(FindDelaunayRefinementBit(word)));
    }
    from = (from | 63) + 1;
  }
  return end;
}

/** A run also ends where \c changes, if there are any, says so. */
ComponentType
CountRuns(const std::uint64_t * words, const std::uint64_t * changes, std::size_t numberOfWords)
{
  ComponentType count = 0;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < numberOfWords; ++i)
  {
    const std::uint64_t joined = (words[i] << 1 | carry) & (changes == nullptr ? ~std::uint64_t{ 0 } : ~changes[i]);
    const std::uint64_t starts = words[i] & ~joined;
    count += starts == 0 ? 0 : CountDelaunayRefinementBits(starts);
    carry = words[i] >> 63;
  }
  return count;
}

/** What two parts of the rows, one after the other, know of one component. */
void
AddInfo(ComponentInfoType & info, const ComponentInfoType & after)
{
  if (info.numberOfVoxels == 0)
  {
    info = after;
    return;
  }
  info.numberOfVoxels += after.numberOfVoxels;
  for (unsigned int i = 0; i < 3; ++i)
  {
    info.minimum[i] = std::min(info.minimum[i], after.minimum[i]);
    info.maximum[i] = std::max(info.maximum[i], after.maximum[i]);
  }
}
} // namespace

DelaunayRefinementVoxelComponents::DelaunayRefinementVoxelComponents(const DelaunayRefinementVoxelMask & mask,
                                                                     DelaunayRefinementThreads *         threads)
  : m_Size(mask.GetSize())
{
  this->FindRuns(mask, nullptr, threads);
  this->FindComponents(threads);
}

DelaunayRefinementVoxelComponents::DelaunayRefinementVoxelComponents(const DelaunayRefinementVoxelMask &     mask,
                                                                     const DelaunayRefinementRegionChanges & changes,
                                                                     const RegionOfVoxelType &               regionOf,
                                                                     DelaunayRefinementThreads *             threads)
  : m_Size(mask.GetSize())
{
  this->FindRuns(mask, &changes, threads);
  m_Regions.resize(m_Runs.size());
  const std::size_t rows = this->GetNumberOfRows();
  const std::size_t length = Threads::ChoosePieceLength(threads, rows, LeastRowsPerPiece);
  Threads::RunPieces(threads, rows, length, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const auto y = static_cast<std::int32_t>(row % m_Size[1]);
      const auto z = static_cast<std::int32_t>(row / m_Size[1]);
      for (std::size_t i = m_FirstRuns[row]; i < m_FirstRuns[row + 1]; ++i)
      {
        m_Regions[i] = regionOf(m_Runs[i].first, y, z);
      }
    }
  });
  this->FindComponents(threads);
}

void
DelaunayRefinementVoxelComponents::FindComponents(DelaunayRefinementThreads * threads)
{
  // Pieces first, each by itself, then their seams.
  const std::size_t slices = m_Size[2];
  const std::size_t slicesPerPiece = Threads::ChoosePieceLength(threads, slices, 1 + LeastRowsPerPiece / m_Size[1]);
  Threads::RunPieces(threads, slices, slicesPerPiece, [this](std::size_t, std::size_t begin, std::size_t end) {
    this->JoinSlices(static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end));
  });
  for (std::size_t z = slicesPerPiece; z < slices; z += slicesPerPiece)
  {
    this->JoinSliceToPrevious(static_cast<std::int32_t>(z));
  }
  this->NumberComponents();

  // Each piece has its own list of components, which is to be shorter than its list of runs.
  const std::size_t rows = this->GetNumberOfRows();
  const std::size_t rowsPerPiece = Threads::ChoosePieceLength(
    threads, rows, std::max(LeastRowsPerPiece, 4 * rows * m_Components.size() / (m_Runs.size() + 1)));
  std::vector<std::vector<ComponentInfoType>> parts(Threads::CountPieces(rows, rowsPerPiece), m_Components);
  Threads::RunPieces(threads, rows, rowsPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    this->Summarize(begin, end, parts[piece]);
  });
  for (const auto & part : parts)
  {
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      AddInfo(m_Components[i], part[i]);
    }
  }
}

void
DelaunayRefinementVoxelComponents::FindRuns(const DelaunayRefinementVoxelMask &     mask,
                                            const DelaunayRefinementRegionChanges * changes,
                                            DelaunayRefinementThreads *             threads)
{
  const std::size_t rows = this->GetNumberOfRows();
  const std::size_t length = Threads::ChoosePieceLength(threads, rows, LeastRowsPerPiece);
  const auto        wordsOf = [&](std::size_t row) {
    return mask.GetRow(static_cast<std::int32_t>(row % m_Size[1]) + 1, static_cast<std::int32_t>(row / m_Size[1]) + 1);
  };
  const auto isEmpty = [&](std::size_t row) {
    return mask.IsRowEmpty(static_cast<std::int32_t>(row % m_Size[1]) + 1,
                           static_cast<std::int32_t>(row / m_Size[1]) + 1);
  };
  const auto changesOf = [&](std::size_t row) -> const std::uint64_t * {
    return changes == nullptr ? nullptr
                              : changes->GetRow(0,
                                                static_cast<std::int32_t>(row % m_Size[1]) + 1,
                                                static_cast<std::int32_t>(row / m_Size[1]) + 1);
  };
  // Each row's number of runs at first.
  m_FirstRuns.resize(rows + 1);
  std::vector<std::size_t> firstOfPieces(Threads::CountPieces(rows, length) + 1, 0);
  Threads::RunPieces(threads, rows, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      m_FirstRuns[row] = isEmpty(row) ? 0 : CountRuns(wordsOf(row), changesOf(row), mask.GetWordsPerRow());
      firstOfPieces[piece + 1] += m_FirstRuns[row];
    }
  });
  for (std::size_t i = 1; i < firstOfPieces.size(); ++i)
  {
    firstOfPieces[i] += firstOfPieces[i - 1];
  }
  m_FirstRuns[rows] = static_cast<ComponentType>(firstOfPieces.back());
  m_Runs.resize(firstOfPieces.back());
  Threads::RunPieces(threads, rows, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    std::size_t next = firstOfPieces[piece];
    for (std::size_t row = begin; row < end; ++row)
    {
      const std::size_t     endOfRow = next + m_FirstRuns[row];
      const std::uint64_t * words = wordsOf(row);
      const std::uint64_t * changesHere = changesOf(row);
      const auto            inside = [words](std::int32_t word) { return words[word]; };
      const auto            ends = [words, changesHere](std::int32_t word) {
        return changesHere == nullptr ? ~words[word] : ~words[word] | changesHere[word];
      };
      const std::int32_t endOfBits = m_Size[0] + 1;
      m_FirstRuns[row] = static_cast<ComponentType>(next);
      for (std::int32_t bit = 1; next < endOfRow; ++next)
      {
        const std::int32_t first = FindBit(inside, bit, endOfBits);
        bit = FindBit(ends, first + 1, endOfBits);
        m_Runs[next] = { first - 1, bit - 2, static_cast<ComponentType>(next) };
      }
    }
  });
}

ComponentType
DelaunayRefinementVoxelComponents::FindRoot(ComponentType run)
{
  while (m_Runs[run].component != run)
  {
    m_Runs[run].component = m_Runs[m_Runs[run].component].component;
    run = m_Runs[run].component;
  }
  return run;
}

void
DelaunayRefinementVoxelComponents::JoinRuns(std::size_t i, std::size_t j)
{
  const ComponentType rootA = this->FindRoot(static_cast<ComponentType>(i));
  const ComponentType rootB = this->FindRoot(static_cast<ComponentType>(j));
  const ComponentType root = std::min(rootA, rootB);
  m_Runs[std::max(rootA, rootB)].component = root;
  // A shorter way for the next rows.
  m_Runs[i].component = root;
  m_Runs[j].component = root;
}

void
DelaunayRefinementVoxelComponents::JoinRows(std::size_t row, std::size_t other, std::int32_t reach)
{
  std::size_t       i = m_FirstRuns[row];
  std::size_t       j = m_FirstRuns[other];
  const std::size_t endI = m_FirstRuns[row + 1];
  const std::size_t endJ = m_FirstRuns[other + 1];
  if (i == endI || j == endJ)
  {
    return;
  }
  // Most rows are of one component, and known to be.
  const auto isOfFirst = [first = m_Runs[i].component](const RunType & run) { return run.component == first; };
  const auto areOfFirst = [&](std::size_t begin, std::size_t end) {
    return std::all_of(m_Runs.data() + begin, m_Runs.data() + end, isOfFirst);
  };
  if (areOfFirst(j, endJ) && areOfFirst(i, endI))
  {
    return;
  }
  const auto joinIfNear = [this, reach](std::size_t one, std::size_t two) {
    const RunType & a = m_Runs[one];
    const RunType & b = m_Runs[two];
    if (a.component != b.component && a.first <= b.last + reach && b.first <= a.last + reach &&
        (m_Regions.empty() || m_Regions[one] == m_Regions[two]))
    {
      this->JoinRuns(one, two);
    }
  };
  while (i < endI && j < endJ)
  {
    joinIfNear(i, j);
    if (m_Runs[i].last < m_Runs[j].last)
    {
      ++i;
      continue;
    }
    // Runs of different regions follow each other without a gap: the next one may reach this one, too.
    if (m_Runs[i].last == m_Runs[j].last && i + 1 < endI)
    {
      joinIfNear(i + 1, j);
    }
    ++j;
  }
}

void
DelaunayRefinementVoxelComponents::JoinSlices(std::int32_t begin, std::int32_t end)
{
  for (std::int32_t z = begin; z < end; ++z)
  {
    // First, as most of its rows are known to be of one component.
    if (z > begin)
    {
      this->JoinSliceToPrevious(z);
    }
    const std::size_t first = static_cast<std::size_t>(z) * m_Size[1];
    for (std::size_t row = first + 1; row < first + m_Size[1]; ++row)
    {
      this->JoinRows(row, row - 1, 1);
    }
  }
}

void
DelaunayRefinementVoxelComponents::JoinSliceToPrevious(std::int32_t z)
{
  // Two voxels are joined if at most two of their indexes differ, by one.
  const std::size_t rowsPerSlice = m_Size[1];
  for (std::size_t y = 0; y < rowsPerSlice; ++y)
  {
    const std::size_t row = static_cast<std::size_t>(z) * rowsPerSlice + y;
    if (m_FirstRuns[row] == m_FirstRuns[row + 1])
    {
      continue;
    }
    this->JoinRows(row, row - rowsPerSlice, 1);
    if (y > 0)
    {
      this->JoinRows(row, row - rowsPerSlice - 1, 0);
    }
    if (y + 1 < rowsPerSlice)
    {
      this->JoinRows(row, row - rowsPerSlice + 1, 0);
    }
  }
}

void
DelaunayRefinementVoxelComponents::NumberComponents()
{
  // The first run of a component is its root; the others are joined to one that has its number already.
  ComponentType next = 0;
  for (std::size_t i = 0; i < m_Runs.size(); ++i)
  {
    const ComponentType before = m_Runs[i].component;
    m_Runs[i].component = before == i ? next++ : m_Runs[before].component;
  }
  constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();
  m_Components.assign(next, { 0, {}, { largest, largest, largest }, { -1, -1, -1 }, 1 });
}

void
DelaunayRefinementVoxelComponents::Summarize(std::size_t                      beginRow,
                                             std::size_t                      endRow,
                                             std::vector<ComponentInfoType> & infos) const
{
  for (std::size_t row = beginRow; row < endRow; ++row)
  {
    const auto y = static_cast<std::int32_t>(row % m_Size[1]);
    const auto z = static_cast<std::int32_t>(row / m_Size[1]);
    for (std::size_t i = m_FirstRuns[row]; i < m_FirstRuns[row + 1]; ++i)
    {
      const RunType &     run = m_Runs[i];
      ComponentInfoType & info = infos[run.component];
      if (info.numberOfVoxels == 0)
      {
        info.firstVoxel = { run.first, y, z };
        info.region = m_Regions.empty() ? 1 : m_Regions[i];
        info.minimum[2] = z;
      }
      info.numberOfVoxels += static_cast<std::size_t>(run.last - run.first + 1);
      info.minimum[0] = std::min(info.minimum[0], run.first);
      info.minimum[1] = std::min(info.minimum[1], y);
      info.maximum = { std::max(info.maximum[0], run.last), std::max(info.maximum[1], y), z };
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
    if (!isRemoved[i])
    {
      m_Components[next++] = m_Components[i];
    }
  }
  m_Components.resize(next);
  std::size_t row = 0;
  std::size_t kept = 0;
  for (std::int32_t z = 0; z < m_Size[2]; ++z)
  {
    for (std::int32_t y = 0; y < m_Size[1]; ++y, ++row)
    {
      const std::size_t begin = m_FirstRuns[row];
      m_FirstRuns[row] = static_cast<ComponentType>(kept);
      for (std::size_t i = begin; i < m_FirstRuns[row + 1]; ++i)
      {
        const RunType run = m_Runs[i];
        if (isRemoved[run.component])
        {
          mask.ClearRun(run.first, run.last, y, z);
        }
        else
        {
          if (!m_Regions.empty())
          {
            m_Regions[kept] = m_Regions[i];
          }
          m_Runs[kept++] = { run.first, run.last, numbers[run.component] };
        }
      }
    }
  }
  m_FirstRuns[row] = static_cast<ComponentType>(kept);
  m_Runs.resize(kept);
  m_Regions.resize(m_Regions.empty() ? 0 : kept);
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
