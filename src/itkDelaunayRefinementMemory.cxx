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
#include "itkDelaunayRefinementMemory.h"

// Memory checkers don't see the ends of arrays in pages of their own.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#  include <sys/mman.h>
#  define ITK_DELAUNAY_REFINEMENT_HAS_HUGE_PAGES
#endif

#include <cstdint>

namespace itk
{
namespace
{
constexpr std::size_t CacheLine = 64;

#ifdef ITK_DELAUNAY_REFINEMENT_HAS_HUGE_PAGES
constexpr std::size_t HugePage = std::size_t{ 1 } << 21;

/** Shorter arrays would leave much of a huge page empty, and caches of addresses hold most of theirs anyway. */
constexpr std::size_t LeastForHugePages = 2 * HugePage;

std::size_t
RoundToHugePages(std::size_t numberOfBytes)
{
  return (numberOfBytes + HugePage - 1) / HugePage * HugePage;
}
#endif
} // namespace

void *
DelaunayRefinementMemory::Allocate(std::size_t numberOfBytes)
{
#ifdef ITK_DELAUNAY_REFINEMENT_HAS_HUGE_PAGES
  if (numberOfBytes >= LeastForHugePages)
  {
    // One more than needed, of which what is not aligned goes back.
    const std::size_t size = RoundToHugePages(numberOfBytes);
    void * const mapped = mmap(nullptr, size + HugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
    char * const      begin = static_cast<char *>(mapped);
    const std::size_t before = (HugePage - reinterpret_cast<std::uintptr_t>(begin) % HugePage) % HugePage;
    if (before > 0)
    {
      munmap(begin, before);
    }
    munmap(begin + before + size, HugePage - before);
    // Advice: a system without huge pages goes on with small ones.
    madvise(begin + before, size, MADV_HUGEPAGE);
    return begin + before;
  }
#endif
  return ::operator new(numberOfBytes, std::align_val_t{ CacheLine });
}

void
DelaunayRefinementMemory::Release(void * memory, std::size_t numberOfBytes)
{
#ifdef ITK_DELAUNAY_REFINEMENT_HAS_HUGE_PAGES
  if (numberOfBytes >= LeastForHugePages)
  {
    munmap(memory, RoundToHugePages(numberOfBytes));
    return;
  }
#endif
  ::operator delete(memory, std::align_val_t{ CacheLine });
}
} // end namespace itk
