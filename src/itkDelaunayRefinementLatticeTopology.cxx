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
#include "itkDelaunayRefinementBricks.h"
#include "itkDelaunayRefinementCells.h"
#include "itkDelaunayRefinementLatticeVisit.h"
#include "itkDelaunayRefinementRegionCells.h"
#include "itkDelaunayRefinementSmoothedRegions.h"

#include <numeric>

namespace itk
{
namespace
{
constexpr std::size_t BricksPerPiece = 256;

/** Points along an edge of a cell whose corners do not tell all. */
constexpr unsigned int PointsPerEdge = 9;

using GridType = std::array<bool, PointsPerEdge * PointsPerEdge * PointsPerEdge>;

/** The corners of a cube's edges and faces, as bits. */
constexpr unsigned int Edges[] = { 0x03, 0x0c, 0x30, 0xc0, 0x05, 0x0a, 0x50, 0xa0, 0x11, 0x22, 0x44, 0x88 };
constexpr unsigned int Faces[] = { 0x55, 0xaa, 0x33, 0xcc, 0x0f, 0xf0 };

/** Whether corners are inside that only a diagonal of the cube joins. */
constexpr bool
AreOpposite(unsigned int corners)
{
  return corners == 0x81 || corners == 0x42 || corners == 0x24 || corners == 0x18;
}

/** Eight times the Euler characteristic that a cube adds to that of a set of lattice points, of which it has some at
 * its corners: points that share a face are joined, of a cube with none in between nothing is. Each face of the cube
 * counts a half, each edge a quarter, each corner an eighth, with alternating signs, as others share them. */
int
CountEightfold(unsigned int corners)
{
  const auto hasSome = [corners](unsigned int of) { return (corners & of) != 0 ? 1 : 0; };
  int        sum = corners == 0 ? 0 : AreOpposite(corners) ? 16 : 8;
  for (const unsigned int face : Faces)
  {
    sum -= 4 * hasSome(face);
  }
  for (const unsigned int edge : Edges)
  {
    sum += 2 * hasSome(edge);
  }
  return sum - static_cast<int>(CountDelaunayRefinementBits(corners));
}

const std::array<int, 256> &
GetEightfoldCounts()
{
  static const std::array<int, 256> counts = [] {
    std::array<int, 256> all{};
    for (unsigned int corners = 0; corners < all.size(); ++corners)
    {
      all[corners] = CountEightfold(corners);
    }
    return all;
  }();
  return counts;
}

/** Whether of the corners of a face two are inside that no edge joins. */
bool
IsDiagonal(unsigned int corners, unsigned int face)
{
  const unsigned int inside = corners & face;
  return CountDelaunayRefinementBits(inside) == 2 &&
         std::find(std::begin(Edges), std::end(Edges), inside) == std::end(Edges);
}

/** Whether the corners leave open what is joined to what within a cell. */
bool
IsAmbiguous(unsigned int corners)
{
  return AreOpposite(corners) || AreOpposite(~corners & 0xffu) ||
         std::any_of(
           std::begin(Faces), std::end(Faces), [corners](unsigned int face) { return IsDiagonal(corners, face); });
}

/** The first of some cells of a brick. */
std::array<std::int32_t, 3>
GetCellOfBrick(const std::array<std::int32_t, 3> & brick, std::uint64_t cells)
{
  const auto bit = static_cast<std::int32_t>(FindDelaunayRefinementBit(cells));
  return { 4 * brick[0] + (bit & 3), 4 * brick[1] + (bit >> 2 & 3), 4 * brick[2] + (bit >> 4) };
}

using RangeType = std::array<std::array<unsigned int, 2>, 3>;

/** The Euler characteristic of the points of a grid within some ranges, the last ones included. */
std::int64_t
CountEuler(const GridType & grid, const RangeType & ranges)
{
  const auto isInside = [&](unsigned int x, unsigned int y, unsigned int z) {
    const auto isWithin = [&](unsigned int place, unsigned int axis) {
      return ranges[axis][0] <= place && place <= ranges[axis][1];
    };
    return isWithin(x, 0) && isWithin(y, 1) && isWithin(z, 2) && grid[x + PointsPerEdge * (y + PointsPerEdge * z)];
  };
  const auto & counts = GetEightfoldCounts();
  std::int64_t sum = 0;
  // Cubes begin one point before the first; unsigned numbers below 0 are in no range.
  for (unsigned int z = ranges[2][0]; z <= ranges[2][1] + 1; ++z)
  {
    for (unsigned int y = ranges[1][0]; y <= ranges[1][1] + 1; ++y)
    {
      for (unsigned int x = ranges[0][0]; x <= ranges[0][1] + 1; ++x)
      {
        unsigned int corners = 0;
        for (unsigned int i = 0; i < 8; ++i)
        {
          corners |= isInside(x - 1 + (i & 1u), y - 1 + (i >> 1 & 1u), z - 1 + (i >> 2)) ? 1u << i : 0;
        }
        sum += counts[corners];
      }
    }
  }
  return sum / 8;
}

/** What a cell adds, by points between its corners. */
std::int64_t
CountEightfoldOnGrid(const GridType & grid)
{
  constexpr unsigned int last = PointsPerEdge - 1;
  // Along each axis all of the cell, its lower end, or its upper end.
  constexpr std::array<unsigned int, 2> parts[] = { { 0, last }, { 0, 0 }, { last, last } };
  std::int64_t                          sum = 0;
  for (unsigned int i = 0; i < 27; ++i)
  {
    const std::array<unsigned int, 3> which{ i % 3, i / 3 % 3, i / 9 };
    const auto                        ends =
      static_cast<unsigned int>(std::count_if(which.begin(), which.end(), [](unsigned int part) { return part != 0; }));
    const std::int64_t weight = (ends % 2 == 0 ? 8 : -8) / (1 << ends);
    sum += weight * CountEuler(grid, { parts[which[0]], parts[which[1]], parts[which[2]] });
  }
  return sum;
}
} // namespace

std::int64_t
DelaunayRefinementLatticeOracle::CountEightfoldEuler(const IndexType & cell) const
{
  const unsigned int corners = m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
  if (m_Model == ModelEnum::NEAREST || !IsAmbiguous(corners))
  {
    return GetEightfoldCounts()[corners];
  }
  return this->VisitCell(cell, [](const auto & content) {
    GridType         grid;
    constexpr double step = 1.0 / (PointsPerEdge - 1);
    for (unsigned int i = 0; i < grid.size(); ++i)
    {
      grid[i] = content.Classify({ step * (i % PointsPerEdge),
                                   step * (i / PointsPerEdge % PointsPerEdge),
                                   step * (i / (PointsPerEdge * PointsPerEdge)) }) != 0;
    }
    return CountEightfoldOnGrid(grid);
  });
}

void
DelaunayRefinementLatticeOracle::JoinDiagonalVoxels()
{
  if (m_Model != ModelEnum::INDICATOR || this->HasRegions())
  {
    return;
  }
  m_Raised = std::make_unique<DelaunayRefinementVoxelMask>(m_Mask->GetSize());
  for (const IndexType & brick : m_Bricks->GetActiveBricks())
  {
    for (std::uint64_t cells = m_Bricks->GetCells(brick); cells != 0; cells &= cells - 1)
    {
      const IndexType    cell = GetCellOfBrick(brick, cells);
      const unsigned int corners = m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
      for (const unsigned int face : Faces)
      {
        const unsigned int between = IsDiagonal(corners, face) ? ~corners & face : 0;
        for (std::int32_t i = 0; i < 8; ++i)
        {
          if (between >> i & 1u)
          {
            m_Raised->Set(cell[0] - 1 + (i & 1), cell[1] - 1 + (i >> 1 & 1), cell[2] - 1 + (i >> 2), true);
          }
        }
      }
    }
  }
}

DelaunayRefinementTopology
DelaunayRefinementLatticeOracle::CountTopology() const
{
  const auto &              bricks = m_Bricks->GetActiveBricks();
  std::vector<std::int64_t> sums(DelaunayRefinementThreads::CountPieces(bricks.size(), BricksPerPiece), 0);
  DelaunayRefinementThreads::RunPieces(
    m_Threads, bricks.size(), BricksPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        for (std::uint64_t cells = m_Bricks->GetCells(bricks[i]); cells != 0; cells &= cells - 1)
        {
          sums[piece] += this->CountEightfoldEuler(GetCellOfBrick(bricks[i], cells));
        }
      }
    });
  DelaunayRefinementTopology topology;
  topology.isKnown = true;
  topology.components = this->GetNumberOfComponents();
  topology.cavities = this->GetNumberOfCavities();
  // The surface has twice the Euler characteristic of what it bounds.
  topology.eulerCharacteristic = std::accumulate(sums.begin(), sums.end(), std::int64_t{ 0 }) / 4;
  return topology;
}
} // end namespace itk
