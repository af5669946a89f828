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
#include "itkDelaunayRefinementNearbyPoints.h"

#include "itkDelaunayRefinementWideLoops.h"

#include <cmath>

namespace itk
{
ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
DelaunayRefinementNearbyPoints::AnswerEnum
DelaunayRefinementNearbyPoints::Ask(const PatchesType & patches,
                                    std::size_t         number,
                                    double              delta,
                                    double              nearShare) const
{
  const float x = patches.GetCenters(0)[number];
  const float y = patches.GetCenters(1)[number];
  const float z = patches.GetCenters(2)[number];
  const float halfX = patches.GetHalfExtents(0)[number];
  const float halfY = patches.GetHalfExtents(1)[number];
  const float halfZ = patches.GetHalfExtents(2)[number];
  const float radius = patches.GetRadii()[number];
  // Points that cover are within delta of the patch; what rounding does to others is little against their distance.
  const auto  less = static_cast<float>((1.0 - Roundings) * delta - PatchesType::GetRounding(m_Extent + delta));
  const float squaredDelta = Square(less);
  const float squaredReach = Square(less - radius);
  const float squaredNear = Square(less - static_cast<float>(nearShare) * radius);
  bool        isNear = false;
  for (const BlockType & block : m_Blocks)
  {
    std::int32_t covers = 0;
    std::int32_t nears = 0;
    // Compilers do several of a block at once; GCC 12 unless it writes out the loop before.
#ifdef __GNUC__
#  pragma GCC unroll 1
#endif
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      const float dx = std::abs(block[0][i] - x);
      const float dy = std::abs(block[1][i] - y);
      const float dz = std::abs(block[2][i] - z);
      const float furthestX = dx + halfX;
      const float furthestY = dy + halfY;
      const float furthestZ = dz + halfZ;
      const float squared = dx * dx + dy * dy + dz * dz;
      const float squaredFurthest = furthestX * furthestX + furthestY * furthestY + furthestZ * furthestZ;
      covers |= (squaredFurthest <= squaredDelta ? 1 : 0) | (squared <= squaredReach ? 1 : 0);
      nears |= squared <= squaredNear ? 1 : 0;
    }
    if (covers != 0)
    {
      return AnswerEnum::COVERED;
    }
    isNear = isNear || nears != 0;
  }
  return isNear ? AnswerEnum::NEAR : AnswerEnum::FAR;
}

ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
bool
DelaunayRefinementNearbyPoints::HasPointWithin(const PointType & point, double radius) const
{
  const auto  x = static_cast<float>(point[0] - m_Origin[0]);
  const auto  y = static_cast<float>(point[1] - m_Origin[1]);
  const auto  z = static_cast<float>(point[2] - m_Origin[2]);
  const float squaredRadius = Square(static_cast<float>(radius));
  for (const BlockType & block : m_Blocks)
  {
    std::int32_t isWithin = 0;
#ifdef __GNUC__
#  pragma GCC unroll 1
#endif
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      const float dx = block[0][i] - x;
      const float dy = block[1][i] - y;
      const float dz = block[2][i] - z;
      isWithin |= dx * dx + dy * dy + dz * dz <= squaredRadius ? 1 : 0;
    }
    if (isWithin != 0)
    {
      return true;
    }
  }
  return false;
}
} // end namespace itk
