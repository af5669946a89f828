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
#include "itkDelaunayRefinementVoxelMask.h"

namespace itk
{
DelaunayRefinementVoxelMask::DelaunayRefinementVoxelMask(const SizeType & size)
  : m_Size(size)
  , m_WordsPerRow((static_cast<std::size_t>(size[0]) + 2) / 64 + 1)
  // One word more, as pairs may reach past the end of the last row.
  , m_Words(m_WordsPerRow * (size[1] + 2) * (size[2] + 2) + 1, 0)
  , m_MayHaveVoxels(static_cast<std::size_t>(size[1] + 2) * (size[2] + 2), 0)
{}

void
DelaunayRefinementVoxelMask::ClearRun(std::int32_t first, std::int32_t last, std::int32_t y, std::int32_t z)
{
  std::uint64_t * row = this->GetRow(y + 1, z + 1);
  for (std::int32_t bit = first + 1; bit <= last + 1; ++bit)
  {
    row[bit >> 6] &= ~(std::uint64_t{ 1 } << (bit & 63));
  }
}
} // end namespace itk
