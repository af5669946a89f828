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
#ifndef itkDelaunayRefinementLabelTable_h
#define itkDelaunayRefinementLabelTable_h

#include "itkDelaunayRefinementTypes.h"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementLabelTable
 * \brief Finds the place of a pixel value in a list of labels, fast.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TPixel>
class DelaunayRefinementLabelTable
{
public:
  /** No value has a place. */
  DelaunayRefinementLabelTable() = default;

  /** The labels ascend and are positive. */
  explicit DelaunayRefinementLabelTable(const std::vector<TPixel> & labels)
    : m_Labels(labels)
  {
    constexpr double largestTable = 65536.0;
    if (std::is_integral_v<TPixel> && !labels.empty() && static_cast<double>(labels.back()) < largestTable)
    {
      m_Places.resize(static_cast<std::size_t>(labels.back()) + 1, 0);
      for (std::size_t i = 0; i < labels.size(); ++i)
      {
        m_Places[static_cast<std::size_t>(labels[i])] = static_cast<DelaunayRefinementRegion>(i + 1);
      }
    }
  }

  /** Counted from 1; 0 for any other value. */
  DelaunayRefinementRegion
  Find(TPixel value) const
  {
    if (!m_Places.empty())
    {
      return value > TPixel{ 0 } && value <= m_Labels.back() ? m_Places[static_cast<std::size_t>(value)] : 0;
    }
    const auto place = std::lower_bound(m_Labels.begin(), m_Labels.end(), value);
    return place == m_Labels.end() || *place != value
             ? 0
             : static_cast<DelaunayRefinementRegion>(place - m_Labels.begin() + 1);
  }

private:
  std::vector<TPixel>                   m_Labels{};
  std::vector<DelaunayRefinementRegion> m_Places{};
};
} // end namespace itk

#endif
