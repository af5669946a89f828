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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <map>
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
  /** Rows of \c rowLength pixels, one after another. */
  DelaunayRefinementImageCensus(const TPixel * buffer, std::size_t numberOfPixels, std::size_t rowLength)
    : m_Buffer(buffer)
    , m_NumberOfPixels(numberOfPixels)
    , m_RowLength(rowLength)
  {}

  /** Whether a pixel is not a number. */
  bool
  HasNaN() const
  {
    if constexpr (std::is_floating_point_v<TPixel>)
    {
      return std::any_of(m_Buffer, m_Buffer + m_NumberOfPixels, [](TPixel value) { return std::isnan(value); });
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
    std::vector<TPixel> labels;
    if constexpr (std::is_integral_v<TPixel> && sizeof(TPixel) <= 2)
    {
      constexpr int     offset = std::numeric_limits<TPixel>::min();
      std::vector<char> isThere(std::numeric_limits<TPixel>::max() - offset + 1, 0);
      for (std::size_t i = 0; i < m_NumberOfPixels; i = this->FindChange(i))
      {
        isThere[m_Buffer[i] - offset] = 1;
      }
      for (std::size_t i = 0; i < isThere.size(); ++i)
      {
        const auto value = static_cast<TPixel>(static_cast<int>(i) + offset);
        if (isThere[i] && value != 0)
        {
          labels.push_back(value);
        }
      }
    }
    else
    {
      std::map<TPixel, bool> isThere;
      for (std::size_t i = 0; i < m_NumberOfPixels && isThere.size() <= MostLabels; i = this->FindChange(i))
      {
        isThere[m_Buffer[i]] = true;
      }
      for (const auto & entry : isThere)
      {
        if (entry.first != 0)
        {
          labels.push_back(entry.first);
        }
      }
    }
    return labels;
  }

  /** Among neighbors in a row that are both not 0, the share of those that differ: small for tissues, large for grey
   * values. */
  double
  ComputeSpeckle() const
  {
    std::size_t pairs = 0;
    std::size_t differences = 0;
    for (std::size_t row = 0; row < m_NumberOfPixels; row += m_RowLength)
    {
      for (std::size_t i = row + 1; i < row + m_RowLength; ++i)
      {
        const bool isPair = m_Buffer[i] != 0 && m_Buffer[i - 1] != 0;
        pairs += isPair ? 1 : 0;
        differences += isPair && m_Buffer[i] != m_Buffer[i - 1] ? 1 : 0;
      }
    }
    return pairs == 0 ? 0.0 : static_cast<double>(differences) / static_cast<double>(pairs);
  }

private:
  /** The first pixel after \c i with another value, or the end. */
  std::size_t
  FindChange(std::size_t i) const
  {
    constexpr std::size_t      length = 64 / sizeof(TPixel);
    std::array<TPixel, length> same;
    same.fill(m_Buffer[i]);
    ++i;
    while (i + length <= m_NumberOfPixels && std::memcmp(m_Buffer + i, same.data(), sizeof(same)) == 0)
    {
      i += length;
    }
    while (i < m_NumberOfPixels && m_Buffer[i] == same[0])
    {
      ++i;
    }
    return i;
  }

  static constexpr std::size_t MostLabels = 100000;

  const TPixel * m_Buffer;
  std::size_t    m_NumberOfPixels;
  std::size_t    m_RowLength;
};
} // end namespace itk

#endif
