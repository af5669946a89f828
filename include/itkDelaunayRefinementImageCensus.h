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
#ifndef itkDelaunayRefinementImageCensus_h
#define itkDelaunayRefinementImageCensus_h

#include "itkDelaunayRefinementThreads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <limits>
#include <set>
#include <type_traits>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementImageCensus
 * \brief What values a buffer of pixels holds: labels, NaN, range; one pass each.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TPixel>
class DelaunayRefinementImageCensus
{
public:
  /** Rows of \c rowLength pixels, one after another, looked at on several threads if there are any. */
  DelaunayRefinementImageCensus(const TPixel *              buffer,
                                std::size_t                 numberOfPixels,
                                std::size_t                 rowLength,
                                DelaunayRefinementThreads * threads = nullptr)
    : m_Buffer(buffer)
    , m_NumberOfPixels(numberOfPixels)
    , m_RowLength(rowLength)
    , m_Threads(threads)
  {}

  /** Whether a pixel is not a number. */
  bool
  HasNaN() const
  {
    if constexpr (std::is_floating_point_v<TPixel>)
    {
      std::atomic<bool> isThere{ false };
      this->ForPieces(m_NumberOfPixels, PixelsPerPiece, [&](std::size_t, std::size_t begin, std::size_t end) {
        // All of some at once, which compilers make fast: only NaN differs from itself.
        constexpr std::size_t some = 4096;
        for (std::size_t i = begin; i < end && !isThere.load(std::memory_order_relaxed); i += some)
        {
          unsigned int different = 0;
          for (std::size_t j = i; j < std::min(i + some, end); ++j)
          {
            different |= m_Buffer[j] != m_Buffer[j] ? 1u : 0u;
          }
          if (different != 0)
          {
            isThere.store(true, std::memory_order_relaxed);
          }
        }
      });
      return isThere.load(std::memory_order_relaxed);
    }
    else
    {
      return false;
    }
  }

  /** The least and the greatest value. */
  std::pair<TPixel, TPixel>
  FindRange() const
  {
    const auto range = std::minmax_element(m_Buffer, m_Buffer + m_NumberOfPixels);
    return { *range.first, *range.second };
  }

  /** The values other than 0, ascending; some of them if there are far more than labels ever are. */
  std::vector<TPixel>
  FindLabels() const
  {
    if constexpr (std::is_integral_v<TPixel> && sizeof(TPixel) <= 2)
    {
      return this->FindFewLabels();
    }
    else
    {
      return this->FindManyLabels();
    }
  }

  /** Among neighbors in a row that are both not 0, the share of those that differ: small for tissues, large for grey
   * values. */
  double
  ComputeSpeckle() const
  {
    struct CountType
    {
      std::size_t pairs{ 0 };
      std::size_t differences{ 0 };
    };
    const std::size_t      rows = m_NumberOfPixels / m_RowLength;
    const std::size_t      length = 1 + PixelsPerPiece / m_RowLength;
    std::vector<CountType> counts(DelaunayRefinementThreads::CountPieces(rows, length));
    this->ForPieces(rows, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      CountType count;
      for (std::size_t row = begin; row < end; ++row)
      {
        for (std::size_t i = row * m_RowLength + 1; i < (row + 1) * m_RowLength; ++i)
        {
          const bool isPair = m_Buffer[i] != 0 && m_Buffer[i - 1] != 0;
          count.pairs += isPair ? 1 : 0;
          count.differences += isPair && m_Buffer[i] != m_Buffer[i - 1] ? 1 : 0;
        }
      }
      counts[piece] = count;
    });
    CountType all;
    for (const CountType & count : counts)
    {
      all.pairs += count.pairs;
      all.differences += count.differences;
    }
    return all.pairs == 0 ? 0.0 : static_cast<double>(all.differences) / static_cast<double>(all.pairs);
  }

private:
  static constexpr std::size_t PixelsPerPiece = 262144;
  static constexpr std::size_t MostLabels = 100000;

  void
  ForPieces(std::size_t size, std::size_t length, const DelaunayRefinementThreads::PieceTaskType & task) const
  {
    DelaunayRefinementThreads::RunPieces(m_Threads, size, length, task);
  }

  using TableType = std::vector<char>;

  /** A place for each value of a small type. */
  static std::size_t
  GetPlace(TPixel value)
  {
    return static_cast<std::size_t>(static_cast<int>(value) - std::numeric_limits<TPixel>::min());
  }

  /** Notes the values of some pixels. */
  void
  NoteValues(std::size_t begin, std::size_t end, TableType & table) const
  {
    // Most pieces hold the last two values alone: compilers compare all of a piece at once.
    constexpr std::size_t length = 64 / sizeof(TPixel);
    TPixel                one = m_Buffer[begin];
    TPixel                other = one;
    table[GetPlace(one)] = 1;
    const auto noteEach = [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i)
      {
        table[GetPlace(m_Buffer[i])] = 1;
        if (m_Buffer[i] != one)
        {
          other = one;
          one = m_Buffer[i];
        }
      }
    };
    std::size_t i = begin;
    for (; i + length <= end; i += length)
    {
      const TPixel * const pixels = m_Buffer + i;
      unsigned char        hasMore = 0;
      for (std::size_t j = 0; j < length; ++j)
      {
        hasMore |= static_cast<unsigned char>(pixels[j] != one) & static_cast<unsigned char>(pixels[j] != other);
      }
      if (hasMore != 0)
      {
        noteEach(i, i + length);
      }
    }
    noteEach(i, end);
  }

  /** By a table of all values. */
  std::vector<TPixel>
  FindFewLabels() const
  {
    const TableType   none(GetPlace(std::numeric_limits<TPixel>::max()) + 1, 0);
    const std::size_t length =
      DelaunayRefinementThreads::ChoosePieceLength(m_Threads, m_NumberOfPixels, PixelsPerPiece);
    std::vector<TableType> tables(DelaunayRefinementThreads::CountPieces(m_NumberOfPixels, length), none);
    this->ForPieces(m_NumberOfPixels, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      this->NoteValues(begin, end, tables[piece]);
    });
    std::vector<TPixel> labels;
    for (std::size_t i = 0; i < none.size(); ++i)
    {
      const auto value = static_cast<TPixel>(static_cast<int>(i) + std::numeric_limits<TPixel>::min());
      if (value != 0 && std::any_of(tables.begin(), tables.end(), [i](const TableType & table) { return table[i]; }))
      {
        labels.push_back(value);
      }
    }
    return labels;
  }

  /** By sets of values, of some pieces at a time until there are too many: the same ones for any number of threads. */
  std::vector<TPixel>
  FindManyLabels() const
  {
    constexpr std::size_t                       piecesAtATime = 16;
    std::set<TPixel>                            all;
    std::array<std::set<TPixel>, piecesAtATime> some;
    for (std::size_t first = 0; first < m_NumberOfPixels && all.size() <= MostLabels;
         first += piecesAtATime * PixelsPerPiece)
    {
      const std::size_t number = std::min(m_NumberOfPixels - first, piecesAtATime * PixelsPerPiece);
      this->ForPieces(number, PixelsPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
        for (std::size_t i = first + begin; i < first + end; i = this->FindChange(i, first + end))
        {
          some[piece].insert(m_Buffer[i]);
        }
      });
      for (auto & set : some)
      {
        all.merge(set);
        set.clear();
      }
    }
    all.erase(0);
    return { all.begin(), all.end() };
  }

  /** The first pixel after \c i with another value, or the end. */
  std::size_t
  FindChange(std::size_t i, std::size_t end) const
  {
    constexpr std::size_t      length = 64 / sizeof(TPixel);
    std::array<TPixel, length> same;
    same.fill(m_Buffer[i]);
    ++i;
    while (i + length <= end && std::memcmp(m_Buffer + i, same.data(), sizeof(same)) == 0)
    {
      i += length;
    }
    while (i < end && m_Buffer[i] == same[0])
    {
      ++i;
    }
    return i;
  }

  const TPixel *              m_Buffer;
  std::size_t                 m_NumberOfPixels;
  std::size_t                 m_RowLength;
  DelaunayRefinementThreads * m_Threads;
};
} // end namespace itk

#endif
