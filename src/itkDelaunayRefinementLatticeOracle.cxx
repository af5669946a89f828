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
#include "itkDelaunayRefinementLatticeOracle.h"

#include "itkDelaunayRefinementBricks.h"
#include "itkDelaunayRefinementCells.h"
#include "itkDelaunayRefinementGeometry.h"

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

/** Patches of this level are single cells; those of level 0 are bricks. */
constexpr unsigned int CellLevel = 2;

/** The least eigenvalue of a symmetric matrix with a unit diagonal. */
double
ComputeLeastEigenvalue(double xy, double xz, double yz)
{
  const double squares = xy * xy + xz * xz + yz * yz;
  if (squares == 0.0)
  {
    return 1.0;
  }
  const double scale = std::sqrt(squares / 3.0);
  const double cosine = std::clamp(xy * xz * yz / (scale * scale * scale), -1.0, 1.0);
  const double third = 2.0943951023931953;
  return 1.0 + 2.0 * scale * std::cos(std::acos(cosine) / 3.0 + third);
}

/** Three numbers in [0, 1) that depend on the arguments alone. */
PointType
Scatter(const std::array<std::int32_t, 3> & index, unsigned int level)
{
  std::uint64_t state = static_cast<std::uint32_t>(index[0]) * 0x9E3779B97F4A7C15ull ^
                        static_cast<std::uint32_t>(index[1]) * 0xC2B2AE3D27D4EB4Full ^
                        static_cast<std::uint32_t>(index[2]) * 0x165667B19E3779F9ull ^
                        (level + 1) * 0xD6E8FEB86659FD93ull;
  PointType numbers;
  for (double & number : numbers)
  {
    state += 0x9E3779B97F4A7C15ull;
    std::uint64_t bits = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9ull;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBull;
    number = static_cast<double>((bits ^ (bits >> 31)) >> 11) * 0x1p-53;
  }
  return numbers;
}

std::array<std::int32_t, 3>
ToIndex(const PointType & lattice)
{
  return { static_cast<std::int32_t>(std::floor(lattice[0])),
           static_cast<std::int32_t>(std::floor(lattice[1])),
           static_cast<std::int32_t>(std::floor(lattice[2])) };
}

PointType
ToLocal(const PointType & lattice, const std::array<std::int32_t, 3> & cell)
{
  return { lattice[0] - cell[0], lattice[1] - cell[1], lattice[2] - cell[2] };
}
} // namespace

DelaunayRefinementLatticeOracle::DelaunayRefinementLatticeOracle() = default;

DelaunayRefinementLatticeOracle::~DelaunayRefinementLatticeOracle() = default;

void
DelaunayRefinementLatticeOracle::Initialize(ModelEnum                         model,
                                            const FrameType &                 frame,
                                            DelaunayRefinementVoxelMask       mask,
                                            DelaunayRefinementVoxelComponents components)
{
  m_Model = model;
  m_Frame = frame;
  const auto & axes = frame.axes;
  const double determinant = Geometry::Dot(axes[0], Geometry::Cross(axes[1], axes[2]));
  m_InverseRows = { Geometry::Cross(axes[1], axes[2]),
                    Geometry::Cross(axes[2], axes[0]),
                    Geometry::Cross(axes[0], axes[1]) };
  m_LatticeOrigin = frame.origin;
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_LatticeOrigin = Geometry::AddScaled(m_LatticeOrigin, -1.0, axes[i]);
    for (unsigned int j = 0; j < 3; ++j)
    {
      m_InverseRows[i][j] /= determinant;
      m_Gram[i][j] = Geometry::Dot(axes[i], axes[j]);
    }
  }
  const auto cosine = [&](unsigned int i, unsigned int j) {
    return m_Gram[i][j] / std::sqrt(m_Gram[i][i] * m_Gram[j][j]);
  };
  // Rounding errors of a direction matrix are no shear.
  constexpr double noShear = 1e-12;
  m_LeastStretch = std::max(0.0, ComputeLeastEigenvalue(cosine(0, 1), cosine(0, 2), cosine(1, 2)) - noShear);
  m_Mask = std::make_unique<DelaunayRefinementVoxelMask>(std::move(mask));
  m_Components = std::make_unique<DelaunayRefinementVoxelComponents>(std::move(components));
  m_Bricks = std::make_unique<DelaunayRefinementBricks>(*m_Mask);
}

void
DelaunayRefinementLatticeOracle::RemoveComponents(const std::vector<bool> & isRemoved)
{
  m_Components->Remove(isRemoved, *m_Mask);
  m_Bricks = std::make_unique<DelaunayRefinementBricks>(*m_Mask);
}

double
DelaunayRefinementLatticeOracle::GetVoxelValue(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  return m_Mask->Get(x, y, z) ? 0.5 : -0.5;
}

bool
DelaunayRefinementLatticeOracle::IsInsideField(const PointType &) const
{
  return false;
}

PointType
DelaunayRefinementLatticeOracle::ToLattice(const PointType & physical) const
{
  const PointType d = Geometry::Subtract(physical, m_LatticeOrigin);
  return { Geometry::Dot(m_InverseRows[0], d), Geometry::Dot(m_InverseRows[1], d), Geometry::Dot(m_InverseRows[2], d) };
}

PointType
DelaunayRefinementLatticeOracle::ToPhysical(const PointType & lattice) const
{
  PointType point = m_LatticeOrigin;
  for (unsigned int i = 0; i < 3; ++i)
  {
    point = Geometry::AddScaled(point, lattice[i], m_Frame.axes[i]);
  }
  return point;
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementLatticeOracle::ToPhysical(const BoundsType & lattice) const
{
  BoundsType bounds{ m_LatticeOrigin, m_LatticeOrigin };
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      const double low = lattice.minimum[i] * m_Frame.axes[i][j];
      const double high = lattice.maximum[i] * m_Frame.axes[i][j];
      bounds.minimum[j] += std::min(low, high);
      bounds.maximum[j] += std::max(low, high);
    }
  }
  return bounds;
}

double
DelaunayRefinementLatticeOracle::GetSquaredLength(const PointType & v) const
{
  return v[0] * (m_Gram[0][0] * v[0] + 2.0 * (m_Gram[0][1] * v[1] + m_Gram[0][2] * v[2])) +
         v[1] * (m_Gram[1][1] * v[1] + 2.0 * m_Gram[1][2] * v[2]) + m_Gram[2][2] * v[2] * v[2];
}

double
DelaunayRefinementLatticeOracle::GetLeastSquaredLength(const PointType & s) const
{
  return m_LeastStretch * (m_Gram[0][0] * s[0] * s[0] + m_Gram[1][1] * s[1] * s[1] + m_Gram[2][2] * s[2] * s[2]);
}

double
DelaunayRefinementLatticeOracle::GetGreatestLength(const PointType & e) const
{
  return std::sqrt(m_Gram[0][0] * e[0] * e[0] + m_Gram[1][1] * e[1] * e[1] + m_Gram[2][2] * e[2] * e[2] +
                   2.0 * (std::abs(m_Gram[0][1]) * e[0] * e[1] + std::abs(m_Gram[0][2]) * e[0] * e[2] +
                          std::abs(m_Gram[1][2]) * e[1] * e[2]));
}

double
DelaunayRefinementLatticeOracle::GetCornerValue(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  // The mask prevails: removed components and the outer layer are mirrored about the level.
  constexpr double   leastOutside = 1e-30;
  const auto &       size = m_Mask->GetSize();
  const std::int32_t nearX = std::clamp(x, 0, size[0] - 1);
  const std::int32_t nearY = std::clamp(y, 0, size[1] - 1);
  const std::int32_t nearZ = std::clamp(z, 0, size[2] - 1);
  const double       value = this->GetVoxelValue(nearX, nearY, nearZ);
  return m_Mask->Get(x, y, z) ? std::abs(value) : -std::max(std::abs(value), leastOutside);
}

std::array<double, 8>
DelaunayRefinementLatticeOracle::GetCellValues(const IndexType & cell) const
{
  std::array<double, 8> values;
  if (m_Model == ModelEnum::INDICATOR)
  {
    const unsigned int configuration = m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
    for (unsigned int i = 0; i < 8; ++i)
    {
      values[i] = (configuration >> i & 1u) ? 0.5 : -0.5;
    }
    return values;
  }
  for (std::int32_t i = 0; i < 8; ++i)
  {
    values[i] = this->GetCornerValue(cell[0] - 1 + (i & 1), cell[1] - 1 + (i >> 1 & 1), cell[2] - 1 + (i >> 2));
  }
  return values;
}

template <typename TVisitor>
auto
DelaunayRefinementLatticeOracle::VisitCell(const IndexType & cell, const TVisitor & visitor) const
{
  if (m_Model == ModelEnum::NEAREST)
  {
    return visitor(DelaunayRefinementNearestCell(m_Mask->GetConfiguration(cell[0], cell[1], cell[2])));
  }
  if (m_Model == ModelEnum::FIELD)
  {
    const auto isInside = [this, &cell](const PointType & local) {
      return this->IsInsideField({ local[0] + cell[0] - 1, local[1] + cell[1] - 1, local[2] + cell[2] - 1 });
    };
    return visitor(DelaunayRefinementFieldCell<decltype(isInside)>(isInside));
  }
  return visitor(DelaunayRefinementLinearCell(this->GetCellValues(cell)));
}

bool
DelaunayRefinementLatticeOracle::IsInsideCell(const IndexType & cell, const PointType & lattice) const
{
  const unsigned int configuration = m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
  if (configuration == 0 || configuration == 255)
  {
    return configuration != 0;
  }
  return this->VisitCell(cell, [&](const auto & content) { return content.IsInside(ToLocal(lattice, cell)); });
}

DelaunayRefinementOracle::RegionType
DelaunayRefinementLatticeOracle::Classify(const PointType & point) const
{
  const PointType lattice = this->ToLattice(point);
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (!(lattice[i] >= 0.0 && lattice[i] < m_Mask->GetSize()[i] + 1))
    {
      return 0;
    }
  }
  return this->IsInsideCell(ToIndex(lattice), lattice) ? 1 : 0;
}

bool
DelaunayRefinementLatticeOracle::MayIntersectBox(const BoundsType & box) const
{
  IndexType first;
  IndexType last;
  for (unsigned int i = 0; i < 3; ++i)
  {
    double center = 0.0;
    double extent = 0.0;
    for (unsigned int j = 0; j < 3; ++j)
    {
      center += m_InverseRows[i][j] * (0.5 * (box.minimum[j] + box.maximum[j]) - m_LatticeOrigin[j]);
      extent += std::abs(m_InverseRows[i][j]) * 0.5 * (box.maximum[j] - box.minimum[j]);
    }
    // A hair more, for rounding errors.
    extent += 1e-9 * (1.0 + std::abs(center));
    const double size = m_Mask->GetSize()[i] + 1;
    first[i] = static_cast<std::int32_t>(std::floor(std::clamp(center - extent, -1.0, size + 1.0)));
    last[i] = static_cast<std::int32_t>(std::floor(std::clamp(center + extent, -1.0, size + 1.0)));
  }
  return m_Bricks->IsAnyActive(first, last);
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementLatticeOracle::GetSurfaceBounds() const
{
  const IndexType & first = m_Bricks->GetFirstCell();
  const IndexType & last = m_Bricks->GetLastCell();
  BoundsType        lattice;
  for (unsigned int i = 0; i < 3; ++i)
  {
    lattice.minimum[i] = first[i];
    lattice.maximum[i] = last[i] + 1;
  }
  return this->ToPhysical(lattice);
}

bool
DelaunayRefinementLatticeOracle::FindFirstCrossing(const PointType & from,
                                                   const PointType & to,
                                                   PointType &       crossing) const
{
  const PointType start = this->ToLattice(from);
  const PointType end = this->ToLattice(to);
  const PointType direction = Geometry::Subtract(end, start);

  // The part of the way between the first and the last cells with surface.
  double begin = 0.0;
  double finish = 1.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double low = m_Bricks->GetFirstCell()[i];
    const double high = m_Bricks->GetLastCell()[i] + 1;
    if (direction[i] == 0.0)
    {
      if (start[i] < low || start[i] > high)
      {
        return false;
      }
      continue;
    }
    const double one = (low - start[i]) / direction[i];
    const double other = (high - start[i]) / direction[i];
    begin = std::max(begin, std::min(one, other));
    finish = std::min(finish, std::max(one, other));
  }
  if (!(begin <= finish))
  {
    return false;
  }

  // From brick to brick.
  const bool            isInside = this->Classify(from) != 0;
  constexpr double      size = DelaunayRefinementBricks::BrickSize;
  const IndexType &     levelSize = m_Bricks->GetLevelSize(0);
  IndexType             brick;
  IndexType             step{};
  std::array<double, 3> next;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double position = start[i] + begin * direction[i];
    brick[i] = std::clamp(static_cast<std::int32_t>(std::floor(position / size)), 0, levelSize[i] - 1);
    step[i] = direction[i] > 0.0 ? 1 : direction[i] < 0.0 ? -1 : 0;
    next[i] = step[i] == 0 ? 2.0 : (size * (brick[i] + (step[i] > 0 ? 1 : 0)) - start[i]) / direction[i];
  }
  double share = begin;
  while (true)
  {
    const unsigned int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const double       exit = std::min(next[axis], finish);
    double             found;
    if (m_Bricks->IsActiveNode(0, brick) &&
        this->FindChangeInBrick(brick, start, direction, share, exit, isInside, found))
    {
      crossing = this->ToPhysical(Geometry::AddScaled(start, found, direction));
      return true;
    }
    if (next[axis] >= finish)
    {
      return false;
    }
    share = exit;
    brick[axis] += step[axis];
    if (brick[axis] < 0 || brick[axis] >= levelSize[axis])
    {
      return false;
    }
    next[axis] += size * step[axis] / direction[axis];
  }
}

bool
DelaunayRefinementLatticeOracle::FindChangeInBrick(const IndexType & brick,
                                                   const PointType & from,
                                                   const PointType & direction,
                                                   double            begin,
                                                   double            end,
                                                   bool              isInside,
                                                   double &          share) const
{
  IndexType             cell;
  IndexType             step{};
  std::array<double, 3> next;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double position = from[i] + begin * direction[i];
    cell[i] = std::clamp(static_cast<std::int32_t>(std::floor(position)), 4 * brick[i], 4 * brick[i] + 3);
    step[i] = direction[i] > 0.0 ? 1 : direction[i] < 0.0 ? -1 : 0;
    next[i] = step[i] == 0 ? 2.0 : (cell[i] + (step[i] > 0 ? 1 : 0) - from[i]) / direction[i];
  }
  double entry = begin;
  while (true)
  {
    const unsigned int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const double       exit = std::min(next[axis], end);
    if (exit >= entry && m_Bricks->IsActiveCell(cell))
    {
      const PointType one = ToLocal(Geometry::AddScaled(from, entry, direction), cell);
      const PointType other = ToLocal(Geometry::AddScaled(from, exit, direction), cell);
      double          found;
      if (this->VisitCell(cell,
                          [&](const auto & content) { return content.FindFirstChange(one, other, isInside, found); }))
      {
        share = entry + found * (exit - entry);
        return true;
      }
    }
    if (next[axis] >= end)
    {
      return false;
    }
    entry = std::max(entry, exit);
    cell[axis] += step[axis];
    if ((cell[axis] >> 2) != brick[axis])
    {
      return false;
    }
    next[axis] += step[axis] / direction[axis];
  }
}

/** The search for the closest surface point: down the pyramid, the bricks and the cells, nearest first. */
class DelaunayRefinementLatticeOracle::ClosestSearch
{
public:
  ClosestSearch(const DelaunayRefinementLatticeOracle & oracle, const PointType & lattice, double maximumDistance)
    : m_Oracle(oracle)
    , m_Query(lattice)
    , m_Best(maximumDistance * maximumDistance)
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
    PointType any;
    return this->Run(any);
  }

private:
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
    if (!m_Oracle.m_Bricks->IsActiveNode(level, node) || this->GetLeastSquaredDistance(corner, size) >= m_Best)
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
    // The nearest cell of each axis first.
    std::array<std::int32_t, 3> nearest;
    for (unsigned int i = 0; i < 3; ++i)
    {
      nearest[i] = m_Query[i] > 4 * brick[i] + 2 ? 3 : 0;
    }
    for (std::int32_t i = 0; i < 64; ++i)
    {
      const IndexType    within{ (i & 3) ^ nearest[0], (i >> 2 & 3) ^ nearest[1], (i >> 4) ^ nearest[2] };
      const unsigned int bit = DelaunayRefinementBricks::GetBit(within);
      if (cells >> bit & 1u)
      {
        const IndexType cell{ 4 * brick[0] + within[0], 4 * brick[1] + within[1], 4 * brick[2] + within[2] };
        const PointType corner{ double(cell[0]), double(cell[1]), double(cell[2]) };
        if (m_IsAnyEnough && this->IsCubeWithin(corner, 1.0))
        {
          m_Best = -1.0;
          m_IsFound = true;
          return;
        }
        if (this->GetLeastSquaredDistance(corner, 1.0) < m_Best)
        {
          m_Oracle.VisitCell(cell, [&](const auto & content) { this->SearchCube(content, corner, corner, 1.0); });
        }
      }
    }
  }

  template <typename TCell>
  void
  SearchCube(const TCell & cell, const PointType & cellCorner, const PointType & corner, double size)
  {
    if (this->GetLeastSquaredDistance(corner, size) >= m_Best)
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
          m_Best = m_IsAnyEnough ? -1.0 : squared;
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
  PointType                               m_Closest{};
  bool                                    m_IsFound{ false };
  bool                                    m_IsAnyEnough{ false };
};

bool
DelaunayRefinementLatticeOracle::FindClosestSurfacePoint(const PointType & point,
                                                         double            maximumDistance,
                                                         PointType &       closest) const
{
  PointType lattice;
  if (!ClosestSearch(*this, this->ToLattice(point), maximumDistance).Run(lattice))
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
  return ClosestSearch(*this, this->ToLattice(point), distance).RunForAny();
}

std::vector<DelaunayRefinementOracle::SurfacePatch>
DelaunayRefinementLatticeOracle::GetSurfacePatches() const
{
  std::vector<SurfacePatch> patches;
  patches.reserve(m_Bricks->GetActiveBricks().size());
  for (const IndexType & brick : m_Bricks->GetActiveBricks())
  {
    SurfacePatch patch;
    if (this->MakePatch(brick, 0, patch))
    {
      patches.push_back(patch);
    }
  }
  return patches;
}

void
DelaunayRefinementLatticeOracle::SplitSurfacePatch(const SurfacePatch & patch, std::vector<SurfacePatch> & parts) const
{
  for (std::int32_t child = 0; child < 8; ++child)
  {
    SurfacePatch part;
    if (this->MakePatch({ 2 * patch.index[0] + (child & 1),
                          2 * patch.index[1] + (child >> 1 & 1),
                          2 * patch.index[2] + (child >> 2) },
                        patch.level + 1u,
                        part))
    {
      parts.push_back(part);
    }
  }
}

std::uint64_t
DelaunayRefinementLatticeOracle::GetCellsOfPatch(const IndexType & index, unsigned int level) const
{
  const unsigned int shift = CellLevel - level;
  const std::int32_t extent = (1 << shift) - 1;
  const IndexType    first{ (index[0] << shift) & 3, (index[1] << shift) & 3, (index[2] << shift) & 3 };
  const IndexType    last{ first[0] + extent, first[1] + extent, first[2] + extent };
  return m_Bricks->GetCells({ index[0] >> level, index[1] >> level, index[2] >> level }) &
         DelaunayRefinementBricks::GetBits(first, last);
}

bool
DelaunayRefinementLatticeOracle::MakePatch(const IndexType & index, unsigned int level, SurfacePatch & patch) const
{
  const double size = std::ldexp(DelaunayRefinementBricks::BrickSize, -static_cast<int>(level));
  const double half = 0.5 * size;
  PointType    center{ index[0] * size + half, index[1] * size + half, index[2] * size + half };
  PointType    extents{ half, half, half };
  if (level < CellLevel)
  {
    const std::uint64_t active = this->GetCellsOfPatch(index, level);
    if (active == 0)
    {
      return false;
    }
    // The bounds of the cells with surface.
    for (unsigned int i = 0; i < 3; ++i)
    {
      constexpr std::uint64_t slices[3][4] = {
        { 0x1111111111111111u, 0x2222222222222222u, 0x4444444444444444u, 0x8888888888888888u },
        { 0x000F000F000F000Fu, 0x00F000F000F000F0u, 0x0F000F000F000F00u, 0xF000F000F000F000u },
        { 0x000000000000FFFFu, 0x00000000FFFF0000u, 0x0000FFFF00000000u, 0xFFFF000000000000u }
      };
      std::int32_t low = 0;
      std::int32_t high = 3;
      while (!(active & slices[i][low]))
      {
        ++low;
      }
      while (!(active & slices[i][high]))
      {
        --high;
      }
      const std::int32_t brickStart = index[i] >> level << CellLevel;
      extents[i] = 0.5 * (high + 1 - low);
      center[i] = brickStart + low + extents[i];
    }
  }
  else
  {
    const unsigned int shift = level - CellLevel;
    const IndexType    cell{ index[0] >> shift, index[1] >> shift, index[2] >> shift };
    if (!m_Bricks->IsActiveCell(cell))
    {
      return false;
    }
    const PointType local{ index[0] * size - cell[0], index[1] * size - cell[1], index[2] * size - cell[2] };
    if (shift > 0 && !this->VisitCell(cell, [&](const auto & content) { return content.MayIntersect(local, size); }))
    {
      return false;
    }
  }
  patch.center = this->ToPhysical(center);
  patch.radius = this->GetGreatestLength(extents);
  patch.index = index;
  patch.level = static_cast<std::uint8_t>(level);
  return true;
}

bool
DelaunayRefinementLatticeOracle::FindPointOfPatch(const SurfacePatch & patch, PointType & point) const
{
  const unsigned int level = patch.level;
  const PointType    random = Scatter(patch.index, level);
  IndexType          cell;
  PointType          local{};
  double             size = 1.0;
  if (level < CellLevel)
  {
    // Some cell of those with surface.
    const std::uint64_t          active = this->GetCellsOfPatch(patch.index, level);
    std::array<std::int32_t, 64> bits;
    std::int32_t                 number = 0;
    for (std::int32_t bit = 0; bit < 64; ++bit)
    {
      if (active >> bit & 1u)
      {
        bits[number++] = bit;
      }
    }
    const std::int32_t chosen = bits[static_cast<std::int32_t>(random[0] * number)];
    cell = { (patch.index[0] >> level << CellLevel) + (chosen & 3),
             (patch.index[1] >> level << CellLevel) + (chosen >> 2 & 3),
             (patch.index[2] >> level << CellLevel) + (chosen >> 4) };
  }
  else
  {
    const unsigned int shift = level - CellLevel;
    size = std::ldexp(1.0, -static_cast<int>(shift));
    for (unsigned int i = 0; i < 3; ++i)
    {
      cell[i] = patch.index[i] >> shift;
      local[i] = patch.index[i] * size - cell[i];
    }
  }
  const PointType start{ local[0] + random[0] * size, local[1] + random[1] * size, local[2] + random[2] * size };
  PointType       found;
  if (!this->VisitCell(
        cell, [&](const auto & content) { return FindSurfacePointInCube(content, local, size, start, found); }))
  {
    return false;
  }
  point = this->ToPhysical(PointType{ found[0] + cell[0], found[1] + cell[1], found[2] + cell[2] });
  return true;
}

DelaunayRefinementOracle::ComponentType
DelaunayRefinementLatticeOracle::GetNumberOfComponents() const
{
  return static_cast<ComponentType>(m_Components->GetComponents().size());
}

DelaunayRefinementOracle::ComponentType
DelaunayRefinementLatticeOracle::FindComponent(const PointType & point) const
{
  if (this->GetNumberOfComponents() < 2)
  {
    return 0;
  }
  // The nearest voxel of the object among those around; rounding may put the point a little off its cell.
  const PointType lattice = this->ToLattice(point);
  const auto &    size = m_Mask->GetSize();
  for (const std::int32_t reach : { 0, 1, 2 })
  {
    double        best = std::numeric_limits<double>::infinity();
    ComponentType component = 0;
    IndexType     first;
    IndexType     last;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const auto voxel = static_cast<std::int32_t>(std::floor(std::clamp(lattice[i], 0.0, size[i] + 1.0))) - 1;
      first[i] = std::clamp(voxel - reach, 0, size[i] - 1);
      last[i] = std::clamp(voxel + 1 + reach, 0, size[i] - 1);
    }
    for (std::int32_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::int32_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::int32_t x = first[0]; x <= last[0]; ++x)
        {
          const double squared = this->GetSquaredLength({ x + 1 - lattice[0], y + 1 - lattice[1], z + 1 - lattice[2] });
          if (squared < best && m_Mask->Get(x, y, z))
          {
            best = squared;
            component = m_Components->Find(x, y, z);
          }
        }
      }
    }
    if (best < std::numeric_limits<double>::infinity())
    {
      return component;
    }
  }
  return 0;
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementLatticeOracle::GetComponentBounds(ComponentType component) const
{
  const auto & info = m_Components->GetComponents()[component];
  BoundsType   lattice;
  for (unsigned int i = 0; i < 3; ++i)
  {
    lattice.minimum[i] = info.minimum[i];
    lattice.maximum[i] = info.maximum[i] + 2;
  }
  return this->ToPhysical(lattice);
}
} // end namespace itk
