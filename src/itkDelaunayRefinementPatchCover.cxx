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
#include "itkDelaunayRefinementPatchCover.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** Cubes per group; more would take longer to set up than they save. */
constexpr double MostCubesPerGroup = 4.0;

/** Edge of the cubes over the greatest reach. */
constexpr double CubeSize = 0.7;

/** Least edge of a block over the greatest delta and over the largest patch's half extent: smaller blocks would have
 * more around them that they share with others. */
constexpr double DeltasPerBlock = 4.0;
constexpr double ExtentsPerBlock = 6.0;
} // namespace

DelaunayRefinementPatchCover::DelaunayRefinementPatchCover(const PatchesType & roots, double greatestDelta)
  : m_Minimum(roots.GetOrigin())
{
  if (roots.GetSize() == 0)
  {
    return;
  }
  PointType maximum = m_Minimum;
  double    largest = 0.0;
  for (std::size_t i = 0; i < roots.GetSize(); ++i)
  {
    const auto root = roots.Get(i);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_Minimum[axis] = i == 0 ? root.center[axis] : std::min(m_Minimum[axis], root.center[axis]);
      maximum[axis] = i == 0 ? root.center[axis] : std::max(maximum[axis], root.center[axis]);
      largest = std::max(largest, root.halfExtents[axis]);
    }
  }
  m_GreatestReach = greatestDelta + largest;
  const PointType extent = Geometry::Subtract(maximum, m_Minimum);
  double          size = CubeSize * m_GreatestReach;
  const auto count = [&] { return (1.0 + extent[0] / size) * (1.0 + extent[1] / size) * (1.0 + extent[2] / size); };
  while (!(count() < 64.0 + MostCubesPerGroup * static_cast<double>(roots.GetSize())))
  {
    size = 1.25 * size + std::numeric_limits<double>::min();
  }
  m_CubesPerLength = 1.0 / size;
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_Size[i] = 1 + static_cast<std::int32_t>(extent[i] * m_CubesPerLength);
  }
  // Between two blocks of a color there is room for the reach of both; their vertices lie within patches, so no further
  // than about a half extent out of the block.
  const double reach = std::ceil((m_GreatestReach + largest) * m_CubesPerLength);
  const double edge = DeltasPerBlock * greatestDelta + ExtentsPerBlock * largest;
  this->MakeBlocks(std::max(2.0 * reach, std::ceil(edge * m_CubesPerLength)));
  this->SortGroups(roots);
}

void
DelaunayRefinementPatchCover::MakeBlocks(double leastSize)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto most = static_cast<std::int32_t>(std::max(1.0, m_Size[i] / leastSize));
    m_BlockSize[i] = (m_Size[i] + most - 1) / most;
    m_BlocksPerAxis[i] = (m_Size[i] + m_BlockSize[i] - 1) / m_BlockSize[i];
  }
  m_CubesPerBlock = static_cast<std::size_t>(m_BlockSize[0]) * m_BlockSize[1] * m_BlockSize[2];
  m_Blocks.resize(static_cast<std::size_t>(m_BlocksPerAxis[0]) * m_BlocksPerAxis[1] * m_BlocksPerAxis[2]);
  for (std::size_t number = 0; number < m_Blocks.size(); ++number)
  {
    const CubeType place = this->GetPlace(number);
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Blocks[number].first[i] = place[i] * m_BlockSize[i];
      m_Blocks[number].last[i] = m_Blocks[number].first[i] + m_BlockSize[i] - 1;
    }
  }
}

void
DelaunayRefinementPatchCover::SortGroups(const PatchesType & roots)
{
  // Sorting by counting keeps the order within cubes.
  std::vector<std::uint32_t> cubes(roots.GetSize());
  m_Starts.assign(m_Blocks.size() * m_CubesPerBlock + 1, 0);
  for (std::size_t i = 0; i < cubes.size(); ++i)
  {
    const CubeType    cube = this->FindCube(roots.Get(i).center, 0.0);
    const std::size_t block =
      this->ToBlock({ cube[0] / m_BlockSize[0], cube[1] / m_BlockSize[1], cube[2] / m_BlockSize[2] });
    cubes[i] = static_cast<std::uint32_t>(this->ToOffset(block, cube));
    ++m_Starts[cubes[i] + 1];
  }
  for (std::size_t cube = 1; cube < m_Starts.size(); ++cube)
  {
    m_Starts[cube] += m_Starts[cube - 1];
  }
  std::vector<std::uint32_t> next(m_Starts.begin(), m_Starts.end() - 1);
  m_Roots.resize(cubes.size());
  m_Groups.resize(cubes.size());
  for (std::uint32_t i = 0; i < cubes.size(); ++i)
  {
    m_Roots[next[cubes[i]]++] = i;
  }
  for (std::size_t number = 0; number < m_Blocks.size(); ++number)
  {
    BlockType & block = m_Blocks[number];
    block.begin = m_Starts[number * m_CubesPerBlock];
    block.end = m_Starts[(number + 1) * m_CubesPerBlock];
    block.minimum.fill(std::numeric_limits<double>::infinity());
    block.maximum.fill(-std::numeric_limits<double>::infinity());
    for (std::uint32_t i = block.begin; i < block.end; ++i)
    {
      const auto root = roots.Get(m_Roots[i]);
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        block.minimum[axis] = std::min(block.minimum[axis], root.center[axis] - root.halfExtents[axis]);
        block.maximum[axis] = std::max(block.maximum[axis], root.center[axis] + root.halfExtents[axis]);
      }
    }
  }
}

std::array<std::vector<std::uint32_t>, DelaunayRefinementPatchCover::NumberOfColors>
DelaunayRefinementPatchCover::GetColors() const
{
  std::array<std::vector<std::uint32_t>, NumberOfColors> colors;
  for (std::uint32_t number = 0; number < m_Blocks.size(); ++number)
  {
    if (m_Blocks[number].begin < m_Blocks[number].end)
    {
      const CubeType place = this->GetPlace(number);
      colors[(place[0] & 1) | (place[1] & 1) << 1 | (place[2] & 1) << 2].push_back(number);
    }
  }
  const auto getSize = [this](std::uint32_t number) { return m_Blocks[number].words.GetSize(); };
  for (auto & blocks : colors)
  {
    std::stable_sort(blocks.begin(), blocks.end(), [&](std::uint32_t left, std::uint32_t right) {
      return getSize(left) > getSize(right);
    });
  }
  return colors;
}

DelaunayRefinementPatchCover::CubeType
DelaunayRefinementPatchCover::FindCube(const PointType & point, double offset) const
{
  CubeType cube;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double index = (point[i] + offset - m_Minimum[i]) * m_CubesPerLength;
    cube[i] = static_cast<std::int32_t>(std::clamp(index, 0.0, m_Size[i] - 1.0));
  }
  return cube;
}

void
DelaunayRefinementPatchCover::CoverFrom(const PointType & vertex, NumbersType & scratch)
{
  if (m_Blocks.empty())
  {
    return;
  }
  const RangeType cubes = this->FindReach(vertex);
  for (std::int32_t z = cubes.first[2] / m_BlockSize[2]; z <= cubes.last[2] / m_BlockSize[2]; ++z)
  {
    for (std::int32_t y = cubes.first[1] / m_BlockSize[1]; y <= cubes.last[1] / m_BlockSize[1]; ++y)
    {
      for (std::int32_t x = cubes.first[0] / m_BlockSize[0]; x <= cubes.last[0] / m_BlockSize[0]; ++x)
      {
        const std::size_t number = this->ToBlock({ x, y, z });
        this->Cover(m_Blocks[number].words.FindPlace(vertex), cubes, number, scratch);
      }
    }
  }
}

void
DelaunayRefinementPatchCover::CoverFrom(const PointType & vertex, std::size_t block, NumbersType & scratch)
{
  RangeType        cubes = this->FindReach(vertex);
  const auto       place = m_Blocks[block].words.FindPlace(vertex);
  const CubeType & first = m_Blocks[block].first;
  const CubeType & last = m_Blocks[block].last;
  CubeType         before;
  CubeType         after;
  for (unsigned int i = 0; i < 3; ++i)
  {
    // No further than half way to the next block of the color, wherever the vertex is.
    cubes.first[i] = std::max(cubes.first[i], first[i] - m_BlockSize[i] / 2);
    cubes.last[i] = std::min(cubes.last[i], last[i] + m_BlockSize[i] / 2);
    before[i] = cubes.first[i] < first[i] ? -1 : 0;
    after[i] = cubes.last[i] > last[i] ? 1 : 0;
  }
  for (std::int32_t z = before[2]; z <= after[2]; ++z)
  {
    for (std::int32_t y = before[1]; y <= after[1]; ++y)
    {
      for (std::int32_t x = before[0]; x <= after[0]; ++x)
      {
        const std::ptrdiff_t offset =
          (static_cast<std::ptrdiff_t>(z) * m_BlocksPerAxis[1] + y) * m_BlocksPerAxis[0] + x;
        this->Cover(place, cubes, block + offset, scratch);
      }
    }
  }
}

void
DelaunayRefinementPatchCover::Cover(const DelaunayRefinementSurfaceWords::PlaceType & vertex,
                                    const RangeType &                                 cubes,
                                    std::size_t                                       number,
                                    NumbersType &                                     scratch)
{
  BlockType & block = m_Blocks[number];
  CubeType    first;
  CubeType    last;
  for (unsigned int i = 0; i < 3; ++i)
  {
    first[i] = std::max(cubes.first[i] - block.first[i], 0);
    last[i] = std::min(cubes.last[i] - block.first[i], m_BlockSize[i] - 1);
    if (first[i] > last[i])
    {
      return;
    }
  }
  scratch.clear();
  const std::uint32_t * const starts = m_Starts.data() + number * m_CubesPerBlock;
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    const std::uint32_t * row = starts + (static_cast<std::size_t>(z) * m_BlockSize[1] + first[1]) * m_BlockSize[0];
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      // The groups of a row of cubes follow each other, and so do their words.
      const std::uint32_t begin = row[first[0]];
      const std::uint32_t end = row[last[0] + 1];
      if (begin < end)
      {
        block.words.FindWithinReach(vertex, m_Groups[begin].begin, m_Groups[end - 1].end, scratch);
      }
      row += m_BlockSize[0];
    }
  }
  block.words.CoverFrom(vertex, scratch);
}
} // end namespace itk
