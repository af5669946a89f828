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
#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementLatticeVisit.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using PointType = DelaunayRefinementPoint;

/** Closest points are searched down to cubes of this size, in voxels. */
constexpr double SmallestCube = 1.0 / 64.0;

} // namespace

/** \class DelaunayRefinementLatticeOracle::ClosestSearch
 * \brief The search for the closest surface point: down the pyramid, the bricks and the cells, nearest first. */
class DelaunayRefinementLatticeOracle::ClosestSearch
{
public:
  ClosestSearch(const DelaunayRefinementLatticeOracle & oracle,
                const PointType &                       lattice,
                double                                  maximumDistance,
                double                                  nearEnough = 0.0,
                double                                  slack = 0.0)
    : m_Oracle(oracle)
    , m_Query(lattice)
    , m_Best(maximumDistance * maximumDistance)
    , m_NearEnough(nearEnough * nearEnough)
    , m_ShareWorthASearch((1.0 - slack) * (1.0 - slack))
  {}

  bool
  Run(PointType & closest)
  {
    const unsigned int top = m_Oracle.m_Bricks->GetNumberOfLevels() - 1;
    this->SearchNode(top, { 0, 0, 0 });
    closest = m_Closest;
    return m_IsFound;
  }

  /** Whether there is any, the closest or not. */
  bool
  RunForAny()
  {
    m_IsAnyEnough = true;
    // The bricks around the ball.
    const auto & size = m_Oracle.m_Bricks->GetLevelSize(0);
    IndexType    first;
    IndexType    last;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const auto &     row = m_Oracle.m_InverseRows[i];
      const double     extent = std::sqrt(m_Best * Geometry::Dot(row, row));
      constexpr double brickSize = DelaunayRefinementBricks::BrickSize;
      first[i] = static_cast<std::int32_t>(std::clamp((m_Query[i] - extent) / brickSize, 0.0, size[i] - 1.0));
      last[i] = static_cast<std::int32_t>(std::clamp((m_Query[i] + extent) / brickSize, 0.0, size[i] - 1.0));
    }
    constexpr double mostBricks = 1000.0;
    if ((last[0] - first[0] + 1.0) * (last[1] - first[1] + 1.0) * (last[2] - first[2] + 1.0) > mostBricks)
    {
      PointType any;
      return this->Run(any);
    }
    for (std::int32_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::int32_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::int32_t x = first[0]; x <= last[0] && !m_IsFound; ++x)
        {
          this->SearchNode(0, { x, y, z });
        }
      }
    }
    return m_IsFound;
  }

private:
  /** Whether what is no nearer can't hold a closest point, or one that is nearer by more than the slack. */
  bool
  IsTooFar(double squaredDistance) const
  {
    return squaredDistance >= (m_IsFound ? m_ShareWorthASearch * m_Best : m_Best);
  }

  /** To a cube, in lattice coordinates. */
  double
  GetLeastSquaredDistance(const PointType & corner, double size) const
  {
    PointType separations;
    for (unsigned int i = 0; i < 3; ++i)
    {
      separations[i] = std::max({ 0.0, corner[i] - m_Query[i], m_Query[i] - corner[i] - size });
    }
    return m_Oracle.GetLeastSquaredLength(separations);
  }

  /** Whether a cube lies within the distance that is asked for. */
  bool
  IsCubeWithin(const PointType & corner, double size) const
  {
    PointType extents;
    for (unsigned int i = 0; i < 3; ++i)
    {
      extents[i] = std::max(std::abs(corner[i] - m_Query[i]), std::abs(corner[i] + size - m_Query[i]));
    }
    const double length = m_Oracle.GetGreatestLength(extents);
    return length * length <= m_Best;
  }

  /** Bit i set: the query is beyond the middle of the cube along axis i. */
  std::int32_t
  FindOctant(const PointType & corner, double size) const
  {
    const double half = 0.5 * size;
    return (m_Query[0] > corner[0] + half ? 1 : 0) | (m_Query[1] > corner[1] + half ? 2 : 0) |
           (m_Query[2] > corner[2] + half ? 4 : 0);
  }

  void
  SearchNode(unsigned int level, const IndexType & node)
  {
    const double    size = 4 << level;
    const PointType corner{ node[0] * size, node[1] * size, node[2] * size };
    if (!m_Oracle.m_Bricks->IsActiveNode(level, node) || this->IsTooFar(this->GetLeastSquaredDistance(corner, size)))
    {
      return;
    }
    if (m_IsAnyEnough && this->IsCubeWithin(corner, size))
    {
      m_Best = -1.0;
      m_IsFound = true;
      return;
    }
    if (level == 0)
    {
      this->SearchBrick(node);
      return;
    }
    const IndexType &  sizeBelow = m_Oracle.m_Bricks->GetLevelSize(level - 1);
    const std::int32_t nearest = this->FindOctant(corner, size);
    for (std::int32_t i = 0; i < 8; ++i)
    {
      const std::int32_t child = i ^ nearest;
      const IndexType    below{ 2 * node[0] + (child & 1), 2 * node[1] + (child >> 1 & 1), 2 * node[2] + (child >> 2) };
      if (below[0] < sizeBelow[0] && below[1] < sizeBelow[1] && below[2] < sizeBelow[2])
      {
        this->SearchNode(level - 1, below);
      }
    }
  }

  void
  SearchBrick(const IndexType & brick)
  {
    const std::uint64_t cells = m_Oracle.m_Bricks->GetCells(brick);
    // The nearest cell of each axis first; squared distances are sums over the axes.
    std::array<std::int32_t, 3>          nearest;
    std::array<std::array<double, 4>, 3> squares;
    for (unsigned int i = 0; i < 3; ++i)
    {
      nearest[i] = m_Query[i] > 4 * brick[i] + 2 ? 3 : 0;
      for (std::int32_t j = 0; j < 4; ++j)
      {
        PointType    separations{};
        const double corner = 4 * brick[i] + (j ^ nearest[i]);
        separations[i] = std::max({ 0.0, corner - m_Query[i], m_Query[i] - corner - 1.0 });
        squares[i][j] = m_Oracle.GetLeastSquaredLength(separations);
      }
    }
    for (std::int32_t i = 0; i < 64; ++i)
    {
      const IndexType    within{ (i & 3) ^ nearest[0], (i >> 2 & 3) ^ nearest[1], (i >> 4) ^ nearest[2] };
      const unsigned int bit = DelaunayRefinementBricks::GetBit(within);
      if ((cells >> bit & 1u) && !this->IsTooFar(squares[0][i & 3] + squares[1][i >> 2 & 3] + squares[2][i >> 4]))
      {
        const IndexType cell{ 4 * brick[0] + within[0], 4 * brick[1] + within[1], 4 * brick[2] + within[2] };
        const PointType corner{ double(cell[0]), double(cell[1]), double(cell[2]) };
        if (m_IsAnyEnough && this->IsCubeWithin(corner, 1.0))
        {
          m_Best = -1.0;
          m_IsFound = true;
          return;
        }
        m_Oracle.VisitCell(cell, [&](const auto & content) { this->SearchCube(content, corner, corner, 1.0); });
      }
    }
  }

  template <typename TCell>
  void
  SearchCube(const TCell & cell, const PointType & cellCorner, const PointType & corner, double size)
  {
    if (this->IsTooFar(this->GetLeastSquaredDistance(corner, size)))
    {
      return;
    }
    const PointType local = Geometry::Subtract(corner, cellCorner);
    if (!cell.MayIntersect(local, size))
    {
      return;
    }
    if (size <= SmallestCube)
    {
      PointType       found;
      const PointType middle{ local[0] + 0.5 * size, local[1] + 0.5 * size, local[2] + 0.5 * size };
      if (FindSurfacePointInCube(cell, local, size, middle, found))
      {
        const PointType lattice = Geometry::AddScaled(cellCorner, 1.0, found);
        const double    squared = m_Oracle.GetSquaredLength(Geometry::Subtract(lattice, m_Query));
        if (squared <= m_Best)
        {
          // Nothing is nearer than less than nothing: the search ends.
          m_Best = m_IsAnyEnough || squared < m_NearEnough ? -1.0 : squared;
          m_Closest = lattice;
          m_IsFound = true;
        }
      }
      return;
    }
    const std::int32_t nearest = this->FindOctant(corner, size);
    const double       half = 0.5 * size;
    for (std::int32_t i = 0; i < 8; ++i)
    {
      const std::int32_t child = i ^ nearest;
      this->SearchCube(
        cell,
        cellCorner,
        { corner[0] + (child & 1) * half, corner[1] + (child >> 1 & 1) * half, corner[2] + (child >> 2) * half },
        half);
    }
  }

  const DelaunayRefinementLatticeOracle & m_Oracle;
  PointType                               m_Query;
  double                                  m_Best;
  double                                  m_NearEnough;
  double                                  m_ShareWorthASearch;
  PointType                               m_Closest{};
  bool                                    m_IsFound{ false };
  bool                                    m_IsAnyEnough{ false };
};

bool
DelaunayRefinementLatticeOracle::FindClosestSurfacePoint(const PointType & point,
                                                         double            maximumDistance,
                                                         PointType &       closest) const
{
  return this->FindClosestSurfacePoint(point, maximumDistance, 0.0, 0.0, closest);
}

bool
DelaunayRefinementLatticeOracle::FindClosestSurfacePoint(const PointType & point,
                                                         double            maximumDistance,
                                                         double            nearEnough,
                                                         double            slack,
                                                         PointType &       closest) const
{
  PointType lattice;
  if (!ClosestSearch(*this, this->ToLattice(point), maximumDistance, nearEnough, slack).Run(lattice))
  {
    return false;
  }
  closest = this->ToPhysical(lattice);
  // The way there may meet the surface before.
  PointType crossing;
  if (this->FindFirstCrossing(point, closest, crossing))
  {
    closest = crossing;
  }
  return true;
}

bool
DelaunayRefinementLatticeOracle::IsSurfaceWithin(const PointType & point, double distance) const
{
  // The cubes around and within the ball decide most cases.
  const auto cube = [&point](double half) {
    return BoundsType{ { point[0] - half, point[1] - half, point[2] - half },
                       { point[0] + half, point[1] + half, point[2] + half } };
  };
  if (!this->MayIntersectBox(cube(distance)))
  {
    return false;
  }
  // The cells that meet a cube of half width 1 lie within its bounds in the lattice, and one cell more.
  PointType extents;
  for (unsigned int i = 0; i < 3; ++i)
  {
    extents[i] = std::abs(m_InverseRows[i][0]) + std::abs(m_InverseRows[i][1]) + std::abs(m_InverseRows[i][2]);
  }
  const double inner = (distance - this->GetGreatestLength({ 1.0, 1.0, 1.0 })) / this->GetGreatestLength(extents);
  if (inner > 0.0 && this->MayIntersectBox(cube(inner)))
  {
    return true;
  }
  return ClosestSearch(*this, this->ToLattice(point), distance).RunForAny();
}
} // end namespace itk
