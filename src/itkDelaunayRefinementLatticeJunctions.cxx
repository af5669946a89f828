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
#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementLatticeVisit.h"

#include <algorithm>
#include <type_traits>

namespace itk
{
namespace
{
using PointType = DelaunayRefinementPoint;

/** Places where regions meet are found to this, in voxels. */
constexpr double SmallestCube = 1.0 / 64.0;

/** As many meet in a line. */
constexpr unsigned int LeastRegions = 3;

/** Cells of masks, and those that two regions share. */
constexpr unsigned int MostRegionsOfOthers = 2;

/** More are not asked for. */
constexpr unsigned int MostRegions = 4;

/** Whether there are at least as many regions among some. */
template <std::size_t VSize>
bool
HaveRegions(const std::array<DelaunayRefinementRegion, VSize> & regions, unsigned int least)
{
  std::array<DelaunayRefinementRegion, MostRegions> different;
  unsigned int                                      number = 0;
  for (const DelaunayRefinementRegion region : regions)
  {
    bool isNew = true;
    for (unsigned int i = 0; i < number; ++i)
    {
      isNew = isNew && different[i] != region;
    }
    if (isNew)
    {
      different[number++] = region;
      if (number == least)
      {
        return true;
      }
    }
  }
  return false;
}

/** For each octant of a cube no less than the number of regions that have points there, outside counted. */
template <typename TCell>
std::array<unsigned int, 8>
CountRegionsOfOctants(const TCell & cell, const PointType & corner, double size)
{
  if constexpr (std::is_same_v<TCell, DelaunayRefinementRegionsCell>)
  {
    return cell.CountRegions(corner, size);
  }
  std::array<unsigned int, 8> numbers;
  numbers.fill(MostRegionsOfOthers);
  if constexpr (std::is_same_v<TCell, DelaunayRefinementNearestCell>)
  {
    // Between the corners' own eighths there is nothing else.
    const DelaunayRefinementOctantCorners corners = FindOctantCorners(cell, corner, size);
    for (unsigned int i = 0; i < 8; ++i)
    {
      numbers[i] = 1;
      while (numbers[i] < MostRegions && HaveRegions(corners.Get(i), numbers[i] + 1))
      {
        ++numbers[i];
      }
    }
  }
  return numbers;
}

/** The corner of an octant. */
PointType
GetOctant(const PointType & corner, double half, unsigned int octant)
{
  return { corner[0] + (octant & 1u) * half, corner[1] + (octant >> 1 & 1u) * half, corner[2] + (octant >> 2) * half };
}

/** A point of the surface in the first small cube of a cube that has corners in enough regions. */
template <typename TCell>
bool
FindJunction(const TCell & cell, const PointType & corner, double size, unsigned int leastRegions, PointType & found)
{
  const double half = 0.5 * size;
  if (size <= SmallestCube)
  {
    return FindSurfacePointInCube(cell, corner, size, { corner[0] + half, corner[1] + half, corner[2] + half }, found);
  }
  const DelaunayRefinementOctantCorners corners = FindOctantCorners(cell, corner, size);
  if (!HaveRegions(corners.Get(), leastRegions))
  {
    return false;
  }
  for (unsigned int i = 0; i < 8; ++i)
  {
    if (HaveRegions(corners.Get(i), leastRegions) &&
        FindJunction(cell, GetOctant(corner, half, i), half, leastRegions, found))
    {
      return true;
    }
  }
  // Where four meet, no smaller cube need have a corner in each: a point of a line that leads there.
  return leastRegions > LeastRegions && FindJunction(cell, corner, size, leastRegions - 1, found);
}
} // namespace

DelaunayRefinementOracle::JunctionPatchesType
DelaunayRefinementLatticeOracle::GetJunctionPatches() const
{
  if (!this->HasRegions())
  {
    return {};
  }
  using Threads = DelaunayRefinementThreads;
  constexpr std::size_t               leastLength = 1024;
  const std::vector<IndexType> &      bricks = m_Bricks->GetActiveBricks();
  const std::size_t                   length = Threads::ChoosePieceLength(m_Threads, bricks.size(), leastLength);
  std::vector<std::vector<IndexType>> found(Threads::CountPieces(bricks.size(), length));
  Threads::RunPieces(m_Threads, bricks.size(), length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const IndexType first{ 4 * bricks[i][0], 4 * bricks[i][1], 4 * bricks[i][2] };
      if (m_Smoothed == nullptr && !this->MayHaveJunctions({ first[0] - 1, first[1] - 1, first[2] - 1 }))
      {
        continue;
      }
      for (std::uint64_t cells = m_Bricks->GetCells(bricks[i]); cells != 0; cells &= cells - 1)
      {
        const IndexType cell = DelaunayRefinementBricks::GetCell(bricks[i], FindDelaunayRefinementBit(cells));
        if (HaveRegions(this->GetCellRegions(cell), LeastRegions))
        {
          found[piece].push_back(cell);
        }
      }
    }
  });
  const PointType     origin = this->GetSurfaceBounds().minimum;
  JunctionPatchesType patches{ SurfacePatches(origin), SurfacePatches(origin) };
  const auto          shape = this->MakeShapeOfCubes(~std::uint64_t{ 0 }, 0.25);
  for (const auto & cells : found)
  {
    for (const IndexType & cell : cells)
    {
      const auto corner =
        patches.lines.MakeCorner(this->ToPhysical(PointType{ double(cell[0]), double(cell[1]), double(cell[2]) }));
      patches.lines.Add(shape, corner, { cell, CellLevel });
      if (HaveRegions(this->GetCellRegions(cell), LeastRegions + 1))
      {
        patches.ends.Add(shape, corner, { cell, CellLevel });
      }
    }
  }
  return patches;
}

void
DelaunayRefinementLatticeOracle::SplitJunctionPatch(const SurfacePatchIdentifier & patch,
                                                    unsigned int                   leastRegions,
                                                    SurfacePatches &               parts) const
{
  const DelaunayRefinementPlace place = FindDelaunayRefinementPlace(patch);
  const double                  half = 0.5 * place.size;
  const auto shape = this->MakeShape({ 0.5 * half, 0.5 * half, 0.5 * half }, { 0.5 * half, 0.5 * half, 0.5 * half });
  this->VisitCell(place.cell, [&](const auto & content) {
    const auto numbers = CountRegionsOfOctants(content, place.corner, place.size);
    for (std::int32_t i = 0; i < 8; ++i)
    {
      if (numbers[i] >= leastRegions)
      {
        const PointType corner = GetOctant(place.corner, half, i);
        const PointType lattice{ place.cell[0] + corner[0], place.cell[1] + corner[1], place.cell[2] + corner[2] };
        parts.Add(shape, parts.MakeCorner(this->ToPhysical(lattice)), GetDelaunayRefinementChild(patch, i));
      }
    }
  });
}

bool
DelaunayRefinementLatticeOracle::FindJunctionInPatch(const SurfacePatchIdentifier & patch,
                                                     unsigned int                   leastRegions,
                                                     PointType &                    point) const
{
  const DelaunayRefinementPlace place = FindDelaunayRefinementPlace(patch);
  PointType                     found;
  if (!this->VisitCell(place.cell, [&](const auto & content) {
        return FindJunction(content, place.corner, place.size, leastRegions, found);
      }))
  {
    return false;
  }
  point = this->ToPhysical(PointType{ place.cell[0] + found[0], place.cell[1] + found[1], place.cell[2] + found[2] });
  return true;
}
} // end namespace itk
