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
#ifndef itkDelaunayRefinementThreads_h
#define itkDelaunayRefinementThreads_h

#include "DelaunayRefinementExport.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace itk
{
/** \class DelaunayRefinementThreads
 * \brief Some threads that share the items of one task after the other.
 *
 * Between tasks that follow each other closely they stay awake, so that tasks may be as short as some ten microseconds.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementThreads
{
public:
  /** Is given the number of an item, and that of the thread it runs on, less than GetNumberOfThreads(). */
  using TaskType = std::function<void(std::size_t item, unsigned int thread)>;

  /** The calling thread counts as one. Fewer if the system has no more to give. */
  explicit DelaunayRefinementThreads(unsigned int numberOfThreads);

  DelaunayRefinementThreads(const DelaunayRefinementThreads &) = delete;
  DelaunayRefinementThreads &
  operator=(const DelaunayRefinementThreads &) = delete;

  /** No task is running. */
  ~DelaunayRefinementThreads();

  /** At least 1. */
  unsigned int
  GetNumberOfThreads() const;

  /** Does all items, in order on one thread, in any order on more. An exception that an item throws is thrown here,
   * that of the first one if there are several; other items may be left undone then. Not to be called from an item. */
  void
  Run(std::size_t numberOfItems, const TaskType & task);

  /** Is given the number of a piece, the first index in it, and the one after its last. */
  using PieceTaskType = std::function<void(std::size_t piece, std::size_t begin, std::size_t end)>;

  /** Splits the indexes 0 to \c size - 1 into pieces of \c length, the last of which may be shorter, and runs the task
   * on each. All on the calling thread if \c threads is null. */
  static void
  RunPieces(DelaunayRefinementThreads * threads, std::size_t size, std::size_t length, const PieceTaskType & task);

  /** A length of pieces that shares the work fairly, at least \c least: all in one piece for one thread or null. Only
   * for work whose result does not depend on the pieces. */
  static std::size_t
  ChoosePieceLength(const DelaunayRefinementThreads * threads, std::size_t size, std::size_t least);

  /** How many pieces of a length there are. */
  static std::size_t
  CountPieces(std::size_t size, std::size_t length)
  {
    return (size + length - 1) / length;
  }

private:
  class Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // end namespace itk

#endif
