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

namespace itk
{
namespace
{
using PointType = DelaunayRefinementPoint;

/** Places where regions meet are found to this, in voxels. */
constexpr double SmallestCube = 1.0 / 64.0;

/** As many meet in a line. */
constexpr unsigned int LeastRegions = 3;

template <std::size_t VSize>
unsigned int
CountRegions(std::array<DelaunayRefinementRegion, VSize> regions)
{
  std::sort(regions.begin(), regions.end());
  return static_cast<unsigned int>(std::unique(regions.begin(), regions.end()) - regions.begin());
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
  std::array<DelaunayRefinementRegion, 27> regions;
  for (unsigned int i = 0; i < 27; ++i)
  {
    regions[i] = cell.Classify({ corner[0] + i % 3 * half, corner[1] + i / 3 % 3 * half, corner[2] + i / 9 * half });
  }
  for (unsigned int i = 0; i < 8; ++i)
  {
    const unsigned int                      first = (i & 1u) + 3 * (i >> 1 & 1u) + 9 * (i >> 2);
    std::array<DelaunayRefinementRegion, 8> corners;
    for (unsigned int j = 0; j < 8; ++j)
    {
      corners[j] = regions[first + (j & 1u) + 3 * (j >> 1 & 1u) + 9 * (j >> 2)];
    }
    const PointType at{ corner[0] + (i & 1u) * half, corner[1] + (i >> 1 & 1u) * half, corner[2] + (i >> 2) * half };
    if (CountRegions(corners) >= leastRegions && FindJunction(cell, at, half, leastRegions, found))
    {
      return true;
    }
  }
  // Where four meet, no smaller cube need have a corner in each: a point of a line that leads there.
  return leastRegions > LeastRegions && CountRegions(regions) >= leastRegions &&
         FindJunction(cell, corner, size, leastRegions - 1, found);
}
} // namespace

DelaunayRefinementOracle::SurfacePatches
DelaunayRefinementLatticeOracle::GetJunctionPatches(unsigned int leastRegions) const
{
  if (!m_HasRegions)
  {
    return SurfacePatches();
  }
  using Threads = DelaunayRefinementThreads;
  constexpr std::size_t               leastLength = 1024;
  const std::vector<IndexType> &      bricks = m_Bricks->GetActiveBricks();
  const std::size_t                   length = Threads::ChoosePieceLength(m_Threads, bricks.size(), leastLength);
  std::vector<std::vector<IndexType>> found(Threads::CountPieces(bricks.size(), length));
  Threads::RunPieces(m_Threads, bricks.size(), length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      for (std::uint64_t cells = m_Bricks->GetCells(bricks[i]); cells != 0; cells &= cells - 1)
      {
        const auto      bit = static_cast<std::int32_t>(FindDelaunayRefinementBit(cells));
        const IndexType cell{ 4 * bricks[i][0] + (bit & 3),
                              4 * bricks[i][1] + (bit >> 2 & 3),
                              4 * bricks[i][2] + (bit >> 4) };
        if (CountRegions(this->GetCellRegions(cell)) >= leastRegions)
        {
          found[piece].push_back(cell);
        }
      }
    }
  });
  SurfacePatches patches(this->GetSurfaceBounds().minimum);
  const auto     shape = this->MakeShapeOfCubes(~std::uint64_t{ 0 }, 0.25);
  for (const auto & cells : found)
  {
    for (const IndexType & cell : cells)
    {
      const PointType corner{ double(cell[0]), double(cell[1]), double(cell[2]) };
      patches.Add(shape, patches.MakeCorner(this->ToPhysical(corner)), { cell, CellLevel });
    }
  }
  return patches;
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
