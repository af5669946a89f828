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
#include "itkDelaunayRefinementVertexStar.h"

#include <algorithm>

namespace itk
{
void
DelaunayRefinementVertexStar::NumberingType::Grow()
{
  m_Table.assign(2 * m_Table.size(), None);
  for (std::uint32_t number = 0; number < m_Indexes.size(); ++number)
  {
    std::uint32_t place = this->GetPlace(m_Indexes[number]);
    while (m_Table[place] != None)
    {
      place = (place + 1) & (m_Table.size() - 1);
    }
    m_Table[place] = number;
  }
}

void
DelaunayRefinementVertexStar::Find(const DelaunayRefinementComplex & complex, IndexType vertex)
{
  const auto & triangulation = complex.GetTriangulation();
  m_Cells.clear();
  m_Regions.clear();
  m_Corners.Clear();
  m_CellNumbers.Clear();
  m_CellNumbers.Find(triangulation.GetCellOfVertex(vertex));
  for (std::uint32_t number = 0; number < m_CellNumbers.GetIndexes().size(); ++number)
  {
    const IndexType index = m_CellNumbers.GetIndexes()[number];
    const auto &    cell = triangulation.GetCell(index);
    CellType        own{ index, {}, {} };
    unsigned int    next = 0;
    for (unsigned int i = 0; i < 4; ++i)
    {
      if (cell.vertices[i] != vertex)
      {
        own.corners[next] = m_Corners.Find(cell.vertices[i]);
        own.neighbors[next] = m_CellNumbers.Find(cell.neighbors[i]);
        ++next;
      }
    }
    m_Cells.push_back(own);
    m_Regions.push_back(complex.GetRegion(index));
  }
}

unsigned int
DelaunayRefinementVertexStar::CountBadPlaces()
{
  m_Different.clear();
  for (const RegionType region : m_Regions)
  {
    if (region != 0 && std::find(m_Different.begin(), m_Different.end(), region) == m_Different.end())
    {
      m_Different.push_back(region);
    }
  }
  unsigned int number = 0;
  for (const RegionType region : m_Different)
  {
    number += this->CountBadPlacesOf(region);
  }
  return number;
}

unsigned int
DelaunayRefinementVertexStar::CountBadPlacesOf(RegionType region)
{
  const std::size_t numberOfCorners = m_Corners.GetIndexes().size();
  m_Degrees.assign(numberOfCorners, 0);
  m_Fans.Start(numberOfCorners);
  for (std::uint32_t number = 0; number < m_Cells.size(); ++number)
  {
    const CellType & cell = m_Cells[number];
    for (unsigned int i = 0; i < 3 && m_Regions[number] == region; ++i)
    {
      if (m_Regions[cell.neighbors[i]] != region)
      {
        const std::uint32_t a = cell.corners[(i + 1) % 3];
        const std::uint32_t b = cell.corners[(i + 2) % 3];
        ++m_Degrees[a];
        ++m_Degrees[b];
        m_Fans.Join(a, b);
      }
    }
  }
  unsigned int atEdges = 0;
  unsigned int fans = 0;
  for (std::uint32_t i = 0; i < numberOfCorners; ++i)
  {
    atEdges += m_Degrees[i] > 2 ? m_Degrees[i] / 2 - 1 : 0;
    fans += m_Degrees[i] > 0 && m_Fans.Find(i) == i ? 1 : 0;
  }
  return atEdges + (fans > 1 ? fans - 1 : 0);
}

template <typename TIsAmong>
void
DelaunayRefinementVertexStar::AppendParts(const TIsAmong & isAmong, std::vector<std::vector<std::uint32_t>> & parts)
{
  m_IsVisited.assign(m_Cells.size(), 0);
  for (std::uint32_t start = 0; start < m_Cells.size(); ++start)
  {
    if (m_IsVisited[start] || !isAmong(start))
    {
      continue;
    }
    std::vector<std::uint32_t> part{ start };
    m_IsVisited[start] = 1;
    for (std::size_t next = 0; next < part.size(); ++next)
    {
      for (const std::uint32_t neighbor : m_Cells[part[next]].neighbors)
      {
        if (!m_IsVisited[neighbor] && isAmong(neighbor) && m_Regions[neighbor] == m_Regions[start])
        {
          m_IsVisited[neighbor] = 1;
          part.push_back(neighbor);
        }
      }
    }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
}

void
DelaunayRefinementVertexStar::FindParts(std::vector<std::vector<std::uint32_t>> & parts)
{
  parts.clear();
  this->AppendParts([](std::uint32_t) { return true; }, parts);
  for (std::uint32_t corner = 0; corner < m_Corners.GetIndexes().size(); ++corner)
  {
    const auto isAround = [&](std::uint32_t number) {
      const auto & corners = m_Cells[number].corners;
      return corners[0] == corner || corners[1] == corner || corners[2] == corner;
    };
    unsigned int changes = 0;
    for (std::uint32_t number = 0; number < m_Cells.size(); ++number)
    {
      for (unsigned int i = 0; i < 3 && isAround(number); ++i)
      {
        changes += m_Cells[number].corners[i] != corner && m_Regions[number] != m_Regions[m_Cells[number].neighbors[i]];
      }
    }
    // Each was counted from both sides.
    if (changes > 4)
    {
      this->AppendParts(isAround, parts);
    }
  }
}
} // end namespace itk
