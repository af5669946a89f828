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

/** In place of the component of a row's runs if it has none, or they are of several. */
constexpr ComponentType NoComponent = std::numeric_limits<ComponentType>::max();
constexpr ComponentType SeveralComponents = NoComponent - 1;

/** \class RowWords
 * \brief Where the runs of a row begin and end: a run also ends where \c changes, if there are any, says so. */
class RowWords
{
public:
  RowWords(const std::uint64_t * words, const std::uint64_t * changes, std::size_t numberOfWords)
    : m_Words(words)
    , m_Changes(changes)
    , m_NumberOfWords(numberOfWords)
  {}

  ComponentType
  CountRuns() const
  {
    ComponentType count = 0;
    for (std::size_t i = 0; i < m_NumberOfWords; ++i)
    {
      const std::uint64_t firsts = m_Words[i] & ~this->FindFollowers(i);
      count += firsts == 0 ? 0 : CountDelaunayRefinementBits(firsts);
    }
    return count;
  }

  /** Fills in the first and last voxels of as many runs. */
  void
  ListRuns(DelaunayRefinementVoxelComponents::RunType * runs) const
  {
    auto *        nextFirst = runs;
    auto *        nextLast = runs;
    std::uint64_t followers = this->FindFollowers(0);
    for (std::size_t i = 0; i < m_NumberOfWords; ++i)
    {
      const std::uint64_t followersAfter = i + 1 < m_NumberOfWords ? this->FindFollowers(i + 1) : 0;
      // Bit x + 1 is voxel x.
      const std::int32_t voxel = static_cast<std::int32_t>(64 * i) - 1;
      for (std::uint64_t firsts = m_Words[i] & ~followers; firsts != 0; firsts &= firsts - 1)
      {
        (nextFirst++)->first = voxel + static_cast<std::int32_t>(FindDelaunayRefinementBit(firsts));
      }
      for (std::uint64_t lasts = m_Words[i] & ~(followers >> 1 | followersAfter << 63); lasts != 0; lasts &= lasts - 1)
      {
        (nextLast++)->last = voxel + static_cast<std::int32_t>(FindDelaunayRefinementBit(lasts));
      }
      followers = followersAfter;
    }
  }

private:
  /** The voxels of a word that belong to the same run as the one before them. */
  std::uint64_t
  FindFollowers(std::size_t i) const
  {
    const std::uint64_t carry = i == 0 ? 0 : m_Words[i - 1] >> 63;
    const std::uint64_t same = m_Changes == nullptr ? ~std::uint64_t{ 0 } : ~m_Changes[i];
    return m_Words[i] & (m_Words[i] << 1 | carry) & same;
  }

  const std::uint64_t * m_Words;
  const std::uint64_t * m_Changes;
  std::size_t           m_NumberOfWords;
};

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
    DelaunayRefinementVoxelMask::VisitRows(m_Size, begin, end, [&](std::size_t row, std::int32_t y, std::int32_t z) {
      for (std::size_t i = m_FirstRuns[row]; i < m_FirstRuns[row + 1]; ++i)
      {
        m_Regions[i] = regionOf(m_Runs[i].first, y, z);
      }
    });
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
  m_RowComponents = DelaunayRefinementArray<ComponentType>();
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
  const auto        wordsOf = [&](std::int32_t y, std::int32_t z) {
    return RowWords(mask.GetRow(y + 1, z + 1),
                    changes == nullptr ? nullptr : changes->GetRow(0, y + 1, z + 1),
                    mask.GetWordsPerRow());
  };
  // Each row's number of runs at first.
  m_FirstRuns.resize(rows + 1);
  std::vector<std::size_t> firstOfPieces(Threads::CountPieces(rows, length) + 1, 0);
  Threads::RunPieces(threads, rows, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    std::size_t number = 0;
    DelaunayRefinementVoxelMask::VisitRows(m_Size, begin, end, [&](std::size_t row, std::int32_t y, std::int32_t z) {
      m_FirstRuns[row] = mask.IsRowEmpty(y + 1, z + 1) ? 0 : wordsOf(y, z).CountRuns();
      number += m_FirstRuns[row];
    });
    firstOfPieces[piece + 1] = number;
  });
  for (std::size_t i = 1; i < firstOfPieces.size(); ++i)
  {
    firstOfPieces[i] += firstOfPieces[i - 1];
  }
  m_FirstRuns[rows] = static_cast<ComponentType>(firstOfPieces.back());
  m_Runs.resize(firstOfPieces.back());
  m_RowComponents.resize(rows);
  Threads::RunPieces(threads, rows, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    auto next = static_cast<ComponentType>(firstOfPieces[piece]);
    DelaunayRefinementVoxelMask::VisitRows(m_Size, begin, end, [&](std::size_t row, std::int32_t y, std::int32_t z) {
      const ComponentType number = m_FirstRuns[row];
      const ComponentType endOfRow = next + number;
      m_FirstRuns[row] = next;
      m_RowComponents[row] = number == 0 ? NoComponent : number == 1 ? next : SeveralComponents;
      if (number > 0)
      {
        wordsOf(y, z).ListRuns(m_Runs.data() + next);
      }
      for (; next < endOfRow; ++next)
      {
        m_Runs[next].component = next;
      }
    });
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
  const ComponentType here = m_RowComponents[row];
  const ComponentType there = m_RowComponents[other];
  if (here == NoComponent || there == NoComponent || (here == there && here != SeveralComponents))
  {
    // As most are.
    return;
  }
  std::size_t       i = m_FirstRuns[row];
  std::size_t       j = m_FirstRuns[other];
  const std::size_t endI = m_FirstRuns[row + 1];
  const std::size_t endJ = m_FirstRuns[other + 1];
  const auto        joinIfNear = [this, reach](std::size_t one, std::size_t two) {
    const RunType & a = m_Runs[one];
    const RunType & b = m_Runs[two];
    if (a.component != b.component && a.first <= b.last + reach && b.first <= a.last + reach &&
        (m_Regions.empty() || m_Regions[one] == m_Regions[two]))
    {
      this->JoinRuns(one, two);
    }
  };
  if (i + 1 == endI && j + 1 == endJ)
  {
    joinIfNear(i, j);
    m_RowComponents[row] = m_Runs[i].component;
    m_RowComponents[other] = m_Runs[j].component;
    return;
  }
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
  m_RowComponents[row] = this->FindComponentOfRow(row);
  m_RowComponents[other] = this->FindComponentOfRow(other);
}

ComponentType
DelaunayRefinementVoxelComponents::FindComponentOfRow(std::size_t row) const
{
  const std::size_t   begin = m_FirstRuns[row];
  const std::size_t   end = m_FirstRuns[row + 1];
  const ComponentType component = m_Runs[begin].component;
  for (std::size_t i = begin + 1; i < end; ++i)
  {
    if (m_Runs[i].component != component)
    {
      return SeveralComponents;
    }
  }
  return component;
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
    if (m_RowComponents[row] == NoComponent)
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
  DelaunayRefinementVoxelMask::VisitRows(
    m_Size, beginRow, endRow, [&](std::size_t row, std::int32_t y, std::int32_t z) {
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
    });
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
