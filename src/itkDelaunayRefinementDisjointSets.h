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
#ifndef itkDelaunayRefinementDisjointSets_h
#define itkDelaunayRefinementDisjointSets_h

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementDisjointSets
 * \brief Numbers from 0, each at first in a set of its own, in sets that can be joined.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementDisjointSets
{
public:
  explicit DelaunayRefinementDisjointSets(std::size_t size = 0) { this->Start(size); }

  /** Forgets all sets; there are as many numbers now. */
  void
  Start(std::size_t size)
  {
    m_NumberOfSets = size;
    m_Parents.resize(size);
    std::iota(m_Parents.begin(), m_Parents.end(), 0u);
  }

  /** The least number of the set. */
  std::uint32_t
  Find(std::uint32_t number)
  {
    while (m_Parents[number] != number)
    {
      m_Parents[number] = m_Parents[m_Parents[number]];
      number = m_Parents[number];
    }
    return number;
  }

  void
  Join(std::uint32_t a, std::uint32_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    m_Parents[std::max(a, b)] = std::min(a, b);
    m_NumberOfSets -= a != b ? 1 : 0;
  }

  std::size_t
  GetNumberOfSets() const
  {
    return m_NumberOfSets;
  }

private:
  std::vector<std::uint32_t> m_Parents{};
  std::size_t                m_NumberOfSets{ 0 };
};
} // end namespace itk

#endif
