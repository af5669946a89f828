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
#include "itkDelaunayRefinementPointGrid.h"

#include <algorithm>

namespace itk
{
namespace
{
constexpr std::int32_t Empty = -1;
} // namespace

DelaunayRefinementPointGrid::DelaunayRefinementPointGrid(double cubeSize)
  : m_InverseSize(1.0 / cubeSize)
  , m_Slots(1024, EntryType{ 0, Empty })
{}

std::uint64_t
DelaunayRefinementPointGrid::ToIndex(double coordinate) const
{
  // Far cubes fold onto the first and the last one: slower there, never wrong.
  constexpr double middle = 1 << 20;
  return static_cast<std::uint64_t>(std::clamp(coordinate * m_InverseSize + middle, 0.0, 2.0 * middle - 1.0));
}

std::size_t
DelaunayRefinementPointGrid::FindSlot(CubeType cube) const
{
  const std::size_t mask = m_Slots.size() - 1;
  std::size_t       slot = ((cube * 0x9E3779B97F4A7C15ull) >> 32) & mask;
  while (m_Slots[slot].last != Empty && m_Slots[slot].cube != cube)
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void
DelaunayRefinementPointGrid::Grow()
{
  std::vector<EntryType> old(m_Slots.size() * 2, EntryType{ 0, Empty });
  old.swap(m_Slots);
  for (const EntryType & entry : old)
  {
    if (entry.last != Empty)
    {
      m_Slots[FindSlot(entry.cube)] = entry;
    }
  }
}

void
DelaunayRefinementPointGrid::Add(const PointType & point)
{
  if (2 * m_Used >= m_Slots.size())
  {
    Grow();
  }
  const CubeType cube = ToCube(ToIndex(point[0]), ToIndex(point[1]), ToIndex(point[2]));
  EntryType &    entry = m_Slots[FindSlot(cube)];
  m_Used += entry.last == Empty;
  m_Nodes.push_back({ point, entry.last });
  entry = { cube, static_cast<std::int32_t>(m_Nodes.size() - 1) };
}

double
DelaunayRefinementPointGrid::FindSquaredDistance(const PointType & point, double radius, double enough) const
{
  std::array<std::uint64_t, 3> first;
  std::array<std::uint64_t, 3> last;
  for (int i = 0; i < 3; ++i)
  {
    first[i] = ToIndex(point[i] - radius);
    last[i] = ToIndex(point[i] + radius);
  }
  const double squaredEnough = enough * enough;
  double       best = radius * radius;
  bool         found = false;
  for (std::uint64_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::uint64_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::uint64_t x = first[0]; x <= last[0]; ++x)
      {
        for (std::int32_t node = m_Slots[FindSlot(ToCube(x, y, z))].last; node != Empty; node = m_Nodes[node].previous)
        {
          const double squared = DelaunayRefinementGeometry::SquaredDistance(point, m_Nodes[node].point);
          if (squared <= best)
          {
            best = squared;
            found = true;
            if (best <= squaredEnough)
            {
              return best;
            }
          }
        }
      }
    }
  }
  return found ? best : std::numeric_limits<double>::infinity();
}
} // end namespace itk
