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
#ifndef itkDelaunayRefinementMemory_h
#define itkDelaunayRefinementMemory_h

#include "DelaunayRefinementExport.h"

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementMemory
 * \brief Memory for arrays that may be large: those are put into huge pages where the system has them.
 *
 * A first touch of a page takes as long as thousands of instructions.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementMemory
{
public:
  /** At least as many bytes, on a cache line's boundary. Throws std::bad_alloc if there are none. */
  static void *
  Allocate(std::size_t numberOfBytes);

  /** Gives back what Allocate() gave for the same number. */
  static void
  Release(void * memory, std::size_t numberOfBytes);

  /** Has memory that will be read soon fetched into the caches, where compilers know how. */
  static void
  Fetch(const void * address)
  {
#ifdef __GNUC__
    __builtin_prefetch(address);
#else
    (void)address;
#endif
  }
};

/** \class DelaunayRefinementAllocator
 * \brief For containers of the standard library. Elements that no value is given for are left as they are.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TElement>
class DelaunayRefinementAllocator
{
public:
  /** The standard's name. */
  using value_type = TElement;

  /** Without state. */
  DelaunayRefinementAllocator() = default;

  /** The same for other elements. */
  template <typename TOther>
  DelaunayRefinementAllocator(const DelaunayRefinementAllocator<TOther> &)
  {}

  /** Room for some elements; throws std::bad_alloc if there is none. */
  TElement *
  allocate(std::size_t length)
  {
    if (length > static_cast<std::size_t>(-1) / 2 / sizeof(TElement))
    {
      throw std::bad_alloc();
    }
    return static_cast<TElement *>(DelaunayRefinementMemory::Allocate(length * sizeof(TElement)));
  }

  /** Gives room back. */
  void
  deallocate(TElement * elements, std::size_t length)
  {
    DelaunayRefinementMemory::Release(elements, length * sizeof(TElement));
  }

  /** Default initialization, which writes nothing to numbers. */
  template <typename TOther>
  void
  construct(TOther * place)
  {
    ::new (static_cast<void *>(place)) TOther;
  }

  /** Any other initialization. */
  template <typename TOther, typename... TArguments>
  void
  construct(TOther * place, TArguments &&... arguments)
  {
    ::new (static_cast<void *>(place)) TOther(std::forward<TArguments>(arguments)...);
  }

  /** All are equal. */
  template <typename TOther>
  bool
  operator==(const DelaunayRefinementAllocator<TOther> &) const
  {
    return true;
  }

  /** None differ. */
  template <typename TOther>
  bool
  operator!=(const DelaunayRefinementAllocator<TOther> &) const
  {
    return false;
  }
};

/** A vector that may be large; resize() leaves new numbers as they are. */
template <typename TElement>
using DelaunayRefinementArray = std::vector<TElement, DelaunayRefinementAllocator<TElement>>;

/** Lengthens an array by zeros, never shortens it. If it has to move, room for as much again is set aside, which takes
 * no time before it is used. */
template <typename TElement>
void
LengthenDelaunayRefinementArray(DelaunayRefinementArray<TElement> & array, std::size_t length)
{
  if (length > array.capacity())
  {
    array.reserve(2 * length);
  }
  if (length > array.size())
  {
    array.resize(length, TElement{});
  }
}
} // end namespace itk

#endif
