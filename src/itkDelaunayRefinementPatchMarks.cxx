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
#include "itkDelaunayRefinementPatchMarks.h"

#include "itkDelaunayRefinementWideLoops.h"

#include <cmath>

namespace itk
{
ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
void
DelaunayRefinementPatchMarks::CoverFrom(const PointType & vertex, std::size_t begin, std::size_t end, bool isExact)
{
  const PointType &    origin = m_Patches.GetOrigin();
  const auto           x = static_cast<float>(vertex[0] - origin[0]);
  const auto           y = static_cast<float>(vertex[1] - origin[1]);
  const auto           z = static_cast<float>(vertex[2] - origin[2]);
  const float * const  centerX = m_Patches.GetCenters(0) + begin;
  const float * const  centerY = m_Patches.GetCenters(1) + begin;
  const float * const  centerZ = m_Patches.GetCenters(2) + begin;
  const float * const  halfX = m_Patches.GetHalfExtents(0) + begin;
  const float * const  halfY = m_Patches.GetHalfExtents(1) + begin;
  const float * const  halfZ = m_Patches.GetHalfExtents(2) + begin;
  const float * const  radii = m_Patches.GetRadii() + begin;
  const float * const  deltas = m_Deltas.data() + begin;
  std::int32_t * const marks = m_Marks.data() + begin;
  const float          nearShare = m_NearShare;
  // Negative lengths have negative squares, within which nothing is.
  const auto square = [](float length) { return length * std::abs(length); };
  const auto getMarks = [=](std::int32_t i) {
    const float dx = std::abs(x - centerX[i]);
    const float dy = std::abs(y - centerY[i]);
    const float dz = std::abs(z - centerZ[i]);
    const float furthestX = dx + halfX[i];
    const float furthestY = dy + halfY[i];
    const float furthestZ = dz + halfZ[i];
    const float squared = dx * dx + dy * dy + dz * dz;
    const float squaredFurthest = furthestX * furthestX + furthestY * furthestY + furthestZ * furthestZ;
    const bool  isCovered = (squaredFurthest <= square(deltas[i])) | (squared <= square(deltas[i] - radii[i]));
    const bool  isNear = squared <= square(deltas[i] - nearShare * radii[i]);
    return (isCovered ? Covered : 0) | (isNear ? Near : 0);
  };
  // Whole blocks: compilers do several of these at once.
  constexpr auto blockSize = static_cast<std::int32_t>(BlockSize);
  const auto     length = static_cast<std::int32_t>(end - begin);
  const auto     whole = (isExact ? length : length + blockSize - 1) / blockSize * blockSize;
  for (std::int32_t i = 0; i < whole; ++i)
  {
    marks[i] |= getMarks(i);
  }
  if (whole < length)
  {
    std::array<std::int32_t, BlockSize> last;
    for (std::int32_t i = 0; i < blockSize; ++i)
    {
      last[i] = getMarks(whole + i);
    }
    for (std::int32_t i = whole; i < length; ++i)
    {
      marks[i] |= last[i - whole];
    }
  }
}
} // end namespace itk
