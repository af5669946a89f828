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
   * that of the first one if there are several, after the other items. Not to be called from an item. */
  void
  Run(std::size_t numberOfItems, const TaskType & task);

private:
  class Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // end namespace itk

#endif
