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
#include "itkDelaunayRefinementFirstUses.h"

#include <atomic>

namespace itk
{
DelaunayRefinementFirstUses::DelaunayRefinementFirstUses(const std::uint32_t *       indexes,
                                                         std::size_t                 length,
                                                         std::size_t                 numberOfIndexes,
                                                         DelaunayRefinementThreads * threads)
  : m_Numbers(numberOfIndexes, None)
{
  constexpr std::size_t leastLength = 16384;
  const std::size_t     lengthOfPieces = DelaunayRefinementThreads::ChoosePieceLength(threads, length, leastLength);
  if (lengthOfPieces < length)
  {
    this->NumberInPieces(indexes, length, lengthOfPieces, threads);
    return;
  }
  for (std::size_t i = 0; i < length; ++i)
  {
    if (m_Numbers[indexes[i]] == None)
    {
      m_Numbers[indexes[i]] = m_NumberOfUsed++;
    }
  }
}

void
DelaunayRefinementFirstUses::NumberInPieces(const std::uint32_t *       indexes,
                                            std::size_t                 length,
                                            std::size_t                 lengthOfPieces,
                                            DelaunayRefinementThreads * threads)
{
  // Where each index comes first.
  std::vector<std::atomic<std::size_t>> firsts(m_Numbers.size());
  for (auto & first : firsts)
  {
    first.store(length, std::memory_order_relaxed);
  }
  DelaunayRefinementThreads::RunPieces(
    threads, length, lengthOfPieces, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        std::atomic<std::size_t> & first = firsts[indexes[i]];
        std::size_t                known = first.load(std::memory_order_relaxed);
        while (i < known && !first.compare_exchange_weak(known, i, std::memory_order_relaxed))
        {
        }
      }
    });

  std::vector<std::uint32_t> next(DelaunayRefinementThreads::CountPieces(length, lengthOfPieces) + 1, 0);
  DelaunayRefinementThreads::RunPieces(
    threads, length, lengthOfPieces, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      std::uint32_t count = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        count += firsts[indexes[i]].load(std::memory_order_relaxed) == i ? 1 : 0;
      }
      next[piece + 1] = count;
    });
  for (std::size_t i = 1; i < next.size(); ++i)
  {
    next[i] += next[i - 1];
  }
  m_NumberOfUsed = next.back();
  DelaunayRefinementThreads::RunPieces(
    threads, length, lengthOfPieces, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      std::uint32_t number = next[piece];
      for (std::size_t i = begin; i < end; ++i)
      {
        if (firsts[indexes[i]].load(std::memory_order_relaxed) == i)
        {
          m_Numbers[indexes[i]] = number++;
        }
      }
    });
}
} // end namespace itk
