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
#ifndef itkDelaunayRefinementBlocks_h
#define itkDelaunayRefinementBlocks_h

#include "itkDelaunayRefinementOracle.h"

#include <algorithm>

namespace itk
{
/** \class DelaunayRefinementBlocks
 * \brief The parts of a box, numbered so that those next to each other are far from each other.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementBlocks
{
public:
  using BoundsType = DelaunayRefinementOracle::BoundsType;
  using PointType = DelaunayRefinementPoint;

  static constexpr std::uint32_t BlocksPerAxis = 8;
  static constexpr std::uint32_t NumberOfBlocks = BlocksPerAxis * BlocksPerAxis * BlocksPerAxis;

  /** Blocks at the border hold all that is beyond. */
  explicit DelaunayRefinementBlocks(const BoundsType & bounds)
    : m_Minimum(bounds.minimum)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_BlocksPerLength[i] = BlocksPerAxis / (bounds.maximum[i] - bounds.minimum[i]);
    }
  }

  std::uint32_t
  Find(const PointType & point) const
  {
    std::uint32_t block = 0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double place = (point[i] - m_Minimum[i]) * m_BlocksPerLength[i];
      block = block * BlocksPerAxis + static_cast<std::uint32_t>(std::clamp(place, 0.0, BlocksPerAxis - 1.0));
    }
    constexpr std::uint32_t oddFactor = 203;
    return block * oddFactor % NumberOfBlocks;
  }

private:
  PointType m_Minimum;
  PointType m_BlocksPerLength;
};
} // end namespace itk

#endif
