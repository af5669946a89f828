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
#include "itkDelaunayRefinementDisjointSets.h"
#include "itkDelaunayRefinementLatticeVisit.h"
#include "itkDelaunayRefinementRegionCells.h"
#include "itkDelaunayRefinementSmoothedRegions.h"
#include "itkDelaunayRefinementVoxelCavities.h"

#include <numeric>
#include <set>

namespace itk
{
namespace
{
constexpr std::size_t BricksPerPiece = 256;

/** Cells whose corners do not tell all are halved so often at most. */
constexpr unsigned int DeepestPart = 10;

/** Points along their edges that tell what is joined within. */
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

/** Calls \c action with the cells of a brick that hold surface, and which of their corners are inside. */
template <typename TAction>
void
ForEachCell(const DelaunayRefinementBricks &            bricks,
            const DelaunayRefinementVoxelMask &         mask,
            const DelaunayRefinementBricks::IndexType & brick,
            const TAction &                             action)
{
  for (std::uint64_t cells = bricks.GetCells(brick); cells != 0; cells &= cells - 1)
  {
    const auto cell = DelaunayRefinementBricks::GetCell(brick, FindDelaunayRefinementBit(cells));
    action(cell, mask.GetConfiguration(cell[0], cell[1], cell[2]));
  }
}

/** The points of a grid that are joined: inside along edges and diagonals of faces, outside along edges alone, as
 * CountEightfold() counts. */
DelaunayRefinementDisjointSets
JoinPoints(const GridType & grid)
{
  constexpr std::int32_t         length = PointsPerEdge;
  DelaunayRefinementDisjointSets points(grid.size());
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(grid.size()); ++i)
  {
    const std::int32_t place[] = { i % length, i / length % length, i / (length * length) };
    // Half of the neighbors: the other half has them as theirs.
    for (std::int32_t step = 14; step < 27; ++step)
    {
      const std::int32_t moves[] = { step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1 };
      const std::int32_t away = std::abs(moves[0]) + std::abs(moves[1]) + std::abs(moves[2]);
      bool               isThere = away <= (grid[i] ? 2 : 1);
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        isThere = isThere && place[axis] + moves[axis] >= 0 && place[axis] + moves[axis] < length;
      }
      const std::int32_t other = i + moves[0] + length * (moves[1] + length * moves[2]);
      if (isThere && grid[i] == grid[other])
      {
        points.Join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(other));
      }
    }
  }
  return points;
}

/** Which corners of a cube, or of a part of its boundary, are inside: those that do not differ along some axes. */
template <typename TContent>
unsigned int
ClassifyCorners(const TContent & content, const DelaunayRefinementPoint & corner, const DelaunayRefinementPoint & size)
{
  unsigned int corners = 0;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const DelaunayRefinementPoint at{ corner[0] + (i & 1u) * size[0],
                                      corner[1] + (i >> 1 & 1u) * size[1],
                                      corner[2] + (i >> 2) * size[2] };
    corners |= content.Classify(at) != 0 ? 1u << i : 0;
  }
  return corners;
}

/** The Euler characteristic of what a box in a cell has inside. It is flat along axes along which its size is 0, and
 * halved along the others as long as its corners leave something open: the halves' sum, less what they share, and so
 * on. */
template <typename TContent>
int
CountEuler(const TContent &                content,
           const DelaunayRefinementPoint & corner,
           const DelaunayRefinementPoint & size,
           unsigned int                    depth)
{
  const unsigned int corners = ClassifyCorners(content, corner, size);
  if (depth == 0 || !IsAmbiguous(corners))
  {
    return corners == 0 ? 0 : AreOpposite(corners) ? 2 : 1;
  }
  int sum = 0;
  for (unsigned int i = 0; i < 27; ++i)
  {
    // Along each axis the lower half, the upper half, or the middle between them.
    const unsigned int      which[] = { i % 3, i / 3 % 3, i / 9 };
    DelaunayRefinementPoint at = corner;
    DelaunayRefinementPoint part{};
    int                     sign = 1;
    bool                    isThere = true;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      isThere = isThere && (size[axis] != 0.0 || which[axis] == 0);
      at[axis] += which[axis] == 0 ? 0.0 : 0.5 * size[axis];
      part[axis] = which[axis] == 2 ? 0.0 : 0.5 * size[axis];
      sign = which[axis] == 2 ? -sign : sign;
    }
    sum += isThere ? sign * CountEuler(content, at, part, depth - 1) : 0;
  }
  return sum;
}

/** What a cell adds, its boundary's parts counted as in CountEightfold(). */
template <typename TContent>
int
CountEightfoldWithin(const TContent & content)
{
  int sum = 0;
  for (unsigned int i = 0; i < 27; ++i)
  {
    // Along each axis all of the cell, its lower end, or its upper end.
    const unsigned int      which[] = { i % 3, i / 3 % 3, i / 9 };
    DelaunayRefinementPoint corner{};
    DelaunayRefinementPoint size{};
    int                     weight = 8;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = which[axis] == 2 ? 1.0 : 0.0;
      size[axis] = which[axis] == 0 ? 1.0 : 0.0;
      weight /= which[axis] == 0 ? 1 : -2;
    }
    sum += weight * CountEuler(content, corner, size, DeepestPart);
  }
  return sum;
}

template <typename TContent>
GridType
MakeGrid(const TContent & content)
{
  GridType         grid;
  constexpr double step = 1.0 / (PointsPerEdge - 1);
  for (unsigned int i = 0; i < grid.size(); ++i)
  {
    grid[i] = content.Classify({ step * (i % PointsPerEdge),
                                 step * (i / PointsPerEdge % PointsPerEdge),
                                 step * (i / (PointsPerEdge * PointsPerEdge)) }) != 0;
  }
  return grid;
}

/** The corners of a cell that are joined, inside or outside. */
template <typename TContent>
DelaunayRefinementDisjointSets
JoinCornersWithin(const TContent & content, unsigned int corners)
{
  DelaunayRefinementDisjointSets sets(8);
  const auto                     joinAll = [&sets](unsigned int some) {
    const unsigned int first = FindDelaunayRefinementBit(some);
    for (; some != 0; some &= some - 1)
    {
      sets.Join(first, FindDelaunayRefinementBit(some));
    }
  };
  for (const unsigned int edge : Edges)
  {
    if ((corners & edge) == edge || (corners & edge) == 0)
    {
      joinAll(edge);
    }
  }
  for (unsigned int i = 0; i < 6; ++i)
  {
    const unsigned int face = Faces[i];
    if (IsDiagonal(corners, face))
    {
      DelaunayRefinementPoint corner{};
      DelaunayRefinementPoint size{ 1.0, 1.0, 1.0 };
      corner[i / 2] = i % 2;
      size[i / 2] = 0.0;
      joinAll(CountEuler(content, corner, size, DeepestPart) == 1 ? corners & face : ~corners & face);
    }
  }
  std::set<std::uint32_t> inside;
  for (unsigned int i = 0; i < 8; ++i)
  {
    if (corners >> i & 1u)
    {
      inside.insert(sets.Find(i));
    }
  }
  if (CountEuler(content, {}, { 1.0, 1.0, 1.0 }, DeepestPart) != static_cast<int>(inside.size()))
  {
    // Something is joined away from the faces.
    DelaunayRefinementDisjointSets points = JoinPoints(MakeGrid(content));
    const auto                     placeOf = [](unsigned int i) {
      constexpr unsigned int last = PointsPerEdge - 1;
      return last * ((i & 1u) + PointsPerEdge * ((i >> 1 & 1u) + PointsPerEdge * (i >> 2)));
    };
    for (unsigned int i = 1; i < 8; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
      {
        if (points.Find(placeOf(i)) == points.Find(placeOf(j)))
        {
          sets.Join(i, j);
        }
      }
    }
  }
  return sets;
}
} // namespace

/** \class DelaunayRefinementLatticeOracle::TopologyCount
 * \brief The topology of the object, cell by cell. */
class DelaunayRefinementLatticeOracle::TopologyCount
{
public:
  explicit TopologyCount(const DelaunayRefinementLatticeOracle & oracle)
    : m_Oracle(oracle)
    , m_Cavities(*oracle.m_Components, oracle.m_Mask->GetSize())
  {}

  std::int64_t
  GetNumberOfCavities() const
  {
    return static_cast<std::int64_t>(m_Cavities.Get().size());
  }

  /** Of the object. */
  std::int64_t
  CountEuler() const
  {
    const auto &              bricks = m_Oracle.m_Bricks->GetActiveBricks();
    std::vector<std::int64_t> sums(DelaunayRefinementThreads::CountPieces(bricks.size(), BricksPerPiece), 0);
    DelaunayRefinementThreads::RunPieces(
      m_Oracle.m_Threads, bricks.size(), BricksPerPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
        {
          ForEachCell(
            *m_Oracle.m_Bricks, *m_Oracle.m_Mask, bricks[i], [&](const IndexType & cell, unsigned int corners) {
              const auto countWithin = [](const auto & content) { return CountEightfoldWithin(content); };
              sums[piece] +=
                this->IsOpen(corners) ? m_Oracle.VisitCell(cell, countWithin) : GetEightfoldCounts()[corners];
            });
        }
      });
    return std::accumulate(sums.begin(), sums.end(), std::int64_t{ 0 }) / 8;
  }

  /** Corrects numbers of components and cavities, which are those of voxels, by what is joined within cells. */
  void
  CountParts(DelaunayRefinementTopology & topology) const
  {
    DelaunayRefinementDisjointSets runs = this->JoinRuns();
    // The last one is all around the object.
    DelaunayRefinementDisjointSets cavities(m_Cavities.Get().size() + 1);
    for (const IndexType & brick : m_Oracle.m_Bricks->GetActiveBricks())
    {
      ForEachCell(*m_Oracle.m_Bricks, *m_Oracle.m_Mask, brick, [&](const IndexType & cell, unsigned int corners) {
        if (this->IsOpen(corners))
        {
          this->JoinCorners(cell, corners, runs, cavities);
        }
      });
    }
    topology.components = static_cast<std::int64_t>(runs.GetNumberOfSets());
    topology.cavities = static_cast<std::int64_t>(cavities.GetNumberOfSets()) - 1;
  }

private:
  /** Whether points within the cell have to be asked. */
  bool
  IsOpen(unsigned int corners) const
  {
    return m_Oracle.m_Model != ModelEnum::NEAREST && IsAmbiguous(corners);
  }

  /** Runs of voxels that share faces. */
  DelaunayRefinementDisjointSets
  JoinRuns() const
  {
    const auto &                   runs = m_Oracle.m_Components->GetRuns();
    DelaunayRefinementDisjointSets sets(runs.size());
    const auto &                   size = m_Oracle.m_Mask->GetSize();
    const auto joinRows = [&](std::int32_t y, std::int32_t z, std::int32_t otherY, std::int32_t otherZ) {
      std::size_t       i = m_Oracle.m_Components->GetFirstRun(y, z);
      std::size_t       j = m_Oracle.m_Components->GetFirstRun(otherY, otherZ);
      const std::size_t end = m_Oracle.m_Components->GetFirstRun(y + 1, z);
      const std::size_t otherEnd = m_Oracle.m_Components->GetFirstRun(otherY + 1, otherZ);
      while (i < end && j < otherEnd)
      {
        if (std::max(runs[i].first, runs[j].first) <= std::min(runs[i].last, runs[j].last))
        {
          sets.Join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        }
        ++(runs[i].last < runs[j].last ? i : j);
      }
    };
    for (std::int32_t z = 0; z < size[2]; ++z)
    {
      for (std::int32_t y = 0; y < size[1]; ++y)
      {
        if (y > 0)
        {
          joinRows(y, z, y - 1, z);
        }
        if (z > 0)
        {
          joinRows(y, z, y, z - 1);
        }
      }
    }
    return sets;
  }

  /** The run of a voxel inside. */
  std::uint32_t
  FindRun(const IndexType & voxel) const
  {
    const auto * const runs = m_Oracle.m_Components->GetRuns().data();
    const auto         begin = runs + m_Oracle.m_Components->GetFirstRun(voxel[1], voxel[2]);
    const auto         end = runs + m_Oracle.m_Components->GetFirstRun(voxel[1] + 1, voxel[2]);
    const auto         run = std::partition_point(begin, end, [&](const auto & r) { return r.last < voxel[0]; });
    return static_cast<std::uint32_t>(run - runs);
  }

  /** The cavity of a voxel outside, or the number of cavities. */
  std::uint32_t
  FindCavity(const IndexType & voxel) const
  {
    return std::min(static_cast<std::uint32_t>(m_Cavities.Get().size()), m_Cavities.Find(voxel));
  }

  /** Joins what the inside of a cell joins at its corners. */
  void
  JoinCorners(const IndexType &                cell,
              unsigned int                     corners,
              DelaunayRefinementDisjointSets & runs,
              DelaunayRefinementDisjointSets & cavities) const
  {
    auto joined =
      m_Oracle.VisitCell(cell, [corners](const auto & content) { return JoinCornersWithin(content, corners); });
    const auto voxelOf = [&cell](unsigned int corner) {
      return IndexType{ cell[0] - 1 + static_cast<std::int32_t>(corner & 1u),
                        cell[1] - 1 + static_cast<std::int32_t>(corner >> 1 & 1u),
                        cell[2] - 1 + static_cast<std::int32_t>(corner >> 2) };
    };
    for (unsigned int i = 1; i < 8; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
      {
        if (joined.Find(i) != joined.Find(j))
        {
          continue;
        }
        if (corners >> i & 1u)
        {
          runs.Join(this->FindRun(voxelOf(i)), this->FindRun(voxelOf(j)));
        }
        else
        {
          cavities.Join(this->FindCavity(voxelOf(i)), this->FindCavity(voxelOf(j)));
        }
      }
    }
  }

  const DelaunayRefinementLatticeOracle & m_Oracle;
  DelaunayRefinementVoxelCavities         m_Cavities; // of the mask as it is now
};

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
    ForEachCell(*m_Bricks, *m_Mask, brick, [this](const IndexType & cell, unsigned int corners) {
      unsigned int between = 0;
      for (const unsigned int face : Faces)
      {
        between |= IsDiagonal(corners, face) ? ~corners & face : 0;
      }
      for (std::int32_t i = 0; i < 8; ++i)
      {
        if (between >> i & 1u)
        {
          m_Raised->Set(cell[0] - 1 + (i & 1), cell[1] - 1 + (i >> 1 & 1), cell[2] - 1 + (i >> 2), true);
        }
      }
    });
  }
}

DelaunayRefinementTopology
DelaunayRefinementLatticeOracle::CountTopology() const
{
  const TopologyCount        count(*this);
  DelaunayRefinementTopology topology;
  topology.isKnown = true;
  // The surface has twice the Euler characteristic of what it bounds.
  topology.eulerCharacteristic = 2 * count.CountEuler();
  topology.components = this->GetNumberOfComponents();
  topology.cavities = count.GetNumberOfCavities();
  if (m_Model == ModelEnum::GREY || m_Model == ModelEnum::FIELD || m_Smoothed != nullptr)
  {
    count.CountParts(topology);
  }
  return topology;
}
} // end namespace itk
