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
#include "itkDelaunayRefinementBlockQueue.h"

namespace itk
{
DelaunayRefinementBlockQueue::DelaunayRefinementBlockQueue()
  : m_Blocks(NumberOfBlocks)
  , m_IsChosen(NumberOfBlocks, false)
{}

const std::vector<std::uint32_t> &
DelaunayRefinementBlockQueue::ChooseBlocks(std::size_t most)
{
  std::size_t numberLeft = 0;
  for (const std::uint32_t block : m_Chosen)
  {
    m_IsChosen[block] = numberLeft < most && this->HasEntries(block);
    if (m_IsChosen[block])
    {
      m_Chosen[numberLeft++] = block;
    }
  }
  m_Chosen.resize(numberLeft);
  for (std::uint32_t i = 0; i < NumberOfBlocks && m_Chosen.size() < most; ++i)
  {
    if (!m_IsChosen[m_Next] && this->HasEntries(m_Next))
    {
      m_Chosen.push_back(m_Next);
      m_IsChosen[m_Next] = true;
    }
    m_Next = (m_Next + 1) % NumberOfBlocks;
  }
  return m_Chosen;
}

std::size_t
DelaunayRefinementBlockQueue::GetLength() const
{
  std::size_t length = 0;
  for (const DelaunayRefinementQueue & block : m_Blocks)
  {
    length += block.GetLength();
  }
  return length;
}
} // end namespace itk
