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

#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementLatticeVisit.h"
#include "itkDelaunayRefinementSmoothedRegions.h"
#include "itkDelaunayRefinementVoxelCavities.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using PointType = DelaunayRefinementPoint;

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

/** By so many cells the surface of a component may be outside those of its voxels: a field's may be anywhere near. */
std::int32_t
GetMargin(DelaunayRefinementLatticeOracle::ModelEnum model)
{
  return model == DelaunayRefinementLatticeOracle::ModelEnum::FIELD ? 1 : 0;
}
} // namespace

DelaunayRefinementLatticeOracle::DelaunayRefinementLatticeOracle() = default;

DelaunayRefinementLatticeOracle::~DelaunayRefinementLatticeOracle() = default;

void
DelaunayRefinementLatticeOracle::Initialize(ModelEnum                                        model,
                                            const FrameType &                                frame,
                                            DelaunayRefinementVoxelMask                      mask,
                                            DelaunayRefinementVoxelComponents                components,
                                            DelaunayRefinementThreads *                      threads,
                                            std::unique_ptr<DelaunayRefinementRegionChanges> changes)
{
  m_Threads = threads;
  m_Model = model;
  m_Frame = frame;
  const auto & axes = frame.axes;
  m_InverseRows = Geometry::Invert(axes);
  m_LatticeOrigin = frame.origin;
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_LatticeOrigin = Geometry::AddScaled(m_LatticeOrigin, -1.0, axes[i]);
    for (unsigned int j = 0; j < 3; ++j)
    {
      m_Gram[i][j] = Geometry::Dot(axes[i], axes[j]);
    }
  }
  const auto cosine = [&](unsigned int i, unsigned int j) {
    return m_Gram[i][j] / std::sqrt(m_Gram[i][i] * m_Gram[j][j]);
  };
  // Rounding errors of a direction matrix are no shear.
  constexpr double noShear = 1e-12;
  // No eigenvalue is greater than the greatest sum of a row.
  const double cosines[3] = { std::abs(cosine(0, 1)), std::abs(cosine(0, 2)), std::abs(cosine(1, 2)) };
  const double greatestStretch =
    1.0 + std::max({ cosines[0] + cosines[1], cosines[0] + cosines[2], cosines[1] + cosines[2] });
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_CellEdges[i] = std::sqrt((greatestStretch + noShear) * m_Gram[i][i]);
  }
  m_LeastStretch = std::max(0.0, ComputeLeastEigenvalue(cosine(0, 1), cosine(0, 2), cosine(1, 2)) - noShear);
  m_Mask = std::make_unique<DelaunayRefinementVoxelMask>(std::move(mask));
  m_Components = std::make_unique<DelaunayRefinementVoxelComponents>(std::move(components));
  m_Changes = std::move(changes);
  m_Bricks = std::make_unique<DelaunayRefinementBricks>(*m_Mask, m_Changes.get(), m_Threads);
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_CornerOffsets[corner][i] =
        static_cast<float>((corner & 1u) * axes[0][i] + (corner >> 1 & 1u) * axes[1][i] + (corner >> 2) * axes[2][i]);
    }
  }
  if (m_Model == ModelEnum::INDICATOR)
  {
    m_CellShapes = this->MakeCellShapes();
  }
}

void
DelaunayRefinementLatticeOracle::RemoveComponents(const std::vector<bool> & isRemoved)
{
  std::vector<DelaunayRefinementBricks::BoxType> boxes;
  for (std::size_t i = 0; i < isRemoved.size(); ++i)
  {
    if (isRemoved[i])
    {
      const auto & info = m_Components->GetComponents()[i];
      boxes.push_back({ info.minimum, info.maximum });
    }
  }
  m_Components->Remove(isRemoved, *m_Mask);
  m_Bricks->Update(*m_Mask, m_Changes.get(), boxes);
}

double
DelaunayRefinementLatticeOracle::GetVoxelValue(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  return m_Mask->Get(x, y, z) ? 0.5 : -0.5;
}

DelaunayRefinementOracle::RegionType
DelaunayRefinementLatticeOracle::GetVoxelRegion(std::int32_t, std::int32_t, std::int32_t) const
{
  return 1;
}

void
DelaunayRefinementLatticeOracle::GetVoxelRegions(const IndexType &           first,
                                                 unsigned int                voxels,
                                                 std::array<RegionType, 8> & regions) const
{
  for (std::int32_t i = 0; i < 8; ++i)
  {
    if (voxels >> i & 1u)
    {
      regions[i] = this->GetVoxelRegion(first[0] + (i & 1), first[1] + (i >> 1 & 1), first[2] + (i >> 2));
    }
  }
}

bool
DelaunayRefinementLatticeOracle::MayHaveJunctions(const std::array<std::int32_t, 3> &) const
{
  return true;
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

DelaunayRefinementLatticeOracle::PointType
DelaunayRefinementLatticeOracle::GetHalfExtents(const PointType & e) const
{
  PointType half;
  for (unsigned int i = 0; i < 3; ++i)
  {
    half[i] =
      std::abs(m_Frame.axes[0][i]) * e[0] + std::abs(m_Frame.axes[1][i]) * e[1] + std::abs(m_Frame.axes[2][i]) * e[2];
  }
  return half;
}

double
DelaunayRefinementLatticeOracle::GetCornerValue(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  // The mask prevails: removed components and the outer layer are mirrored about the level. No value is at the level
  // itself, so that a plateau there ends half a voxel beyond its last voxel, too.
  constexpr double least = 1e-30;
  const double     magnitude = std::max(std::abs(this->GetValue(x, y, z)), least);
  return m_Mask->Get(x, y, z) ? magnitude : -magnitude;
}

std::vector<DelaunayRefinementIndicatorCell>
DelaunayRefinementIndicatorCell::MakeAll()
{
  std::vector<DelaunayRefinementIndicatorCell> cells;
  for (unsigned int configuration = 0; configuration < 256; ++configuration)
  {
    const DelaunayRefinementLinearCell cell = MakeRaised(configuration, 0);
    std::uint64_t                      quarters = 0;
    for (unsigned int i = 0; i < 64; ++i)
    {
      const PointType corner{ 0.25 * (i & 3u), 0.25 * (i >> 2 & 3u), 0.25 * (i >> 4) };
      quarters |= static_cast<std::uint64_t>(cell.MayIntersect(corner, 0.25) ? 1u : 0u) << i;
    }
    cells.push_back({ cell, quarters });
  }
  return cells;
}

std::array<double, 8>
DelaunayRefinementLatticeOracle::GetCellValues(const IndexType & cell) const
{
  std::array<double, 8> values;
  for (std::int32_t i = 0; i < 8; ++i)
  {
    values[i] = this->GetCornerValue(cell[0] - 1 + (i & 1), cell[1] - 1 + (i >> 1 & 1), cell[2] - 1 + (i >> 2));
  }
  return values;
}

DelaunayRefinementOracle::RegionType
DelaunayRefinementLatticeOracle::Classify(const PointType & point) const
{
  const PointType lattice = this->ToLattice(point);
  IndexType       cell;
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (!(lattice[i] >= 0.0 && lattice[i] < m_Mask->GetSize()[i] + 1))
    {
      return 0;
    }
    cell[i] = static_cast<std::int32_t>(lattice[i]);
  }
  using BrickEnum = DelaunayRefinementBricks::BrickEnum;
  const BrickEnum brick = m_Bricks->GetKind({ cell[0] >> 2, cell[1] >> 2, cell[2] >> 2 });
  if (brick != BrickEnum::MIXED)
  {
    return brick == BrickEnum::INSIDE ? this->GetUniformRegion(cell) : 0;
  }
  if (this->HasRegions())
  {
    if (!m_Bricks->IsActiveCell(cell))
    {
      return m_Mask->GetConfiguration(cell[0], cell[1], cell[2]) == 0 ? 0 : this->GetUniformRegion(cell);
    }
    const PointType local = ToLocal(lattice, cell);
    return this->VisitCell(cell, [&local](const auto & content) { return content.Classify(local); });
  }
  const unsigned int configuration = m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
  if (configuration == 0 || configuration == 255)
  {
    return configuration == 0 ? 0 : 1;
  }
  const PointType local = ToLocal(lattice, cell);
  return m_Model == ModelEnum::INDICATOR && m_Raised == nullptr
           ? DelaunayRefinementIndicatorCell::Get(configuration).cell.Classify(local)
           : this->VisitCell(cell, [&local](const auto & content) { return content.Classify(local); });
}

std::array<DelaunayRefinementOracle::RegionType, 8>
DelaunayRefinementLatticeOracle::GetCellRegions(const IndexType & cell) const
{
  const unsigned int        configuration = m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
  std::array<RegionType, 8> regions{};
  if (this->HasRegions() && m_Smoothed == nullptr)
  {
    this->GetVoxelRegions({ cell[0] - 1, cell[1] - 1, cell[2] - 1 }, configuration, regions);
    return regions;
  }
  for (std::int32_t i = 0; i < 8; ++i)
  {
    if (configuration >> i & 1u)
    {
      regions[i] = this->HasRegions()
                     ? this->GetRegion(cell[0] - 1 + (i & 1), cell[1] - 1 + (i >> 1 & 1), cell[2] - 1 + (i >> 2))
                     : 1;
    }
  }
  return regions;
}

unsigned int
DelaunayRefinementLatticeOracle::GetIndicatorConfiguration(const IndexType & cell) const
{
  if (m_Model != ModelEnum::INDICATOR || m_Smoothed != nullptr || this->GetRaised(cell) != 0)
  {
    return 0;
  }
  return this->HasRegions() ? FindDelaunayRefinementPair(this->GetCellRegions(cell)).configuration
                            : m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
}

DelaunayRefinementOracle::RegionType
DelaunayRefinementLatticeOracle::GetUniformRegion(const IndexType & cell) const
{
  return this->HasRegions() ? this->GetRegion(cell[0] - 1, cell[1] - 1, cell[2] - 1) : 1;
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
  // The nearest voxel of the object, or of the point's region, among those around; rounding may put the point a little
  // off its cell.
  const RegionType region = this->HasRegions() ? this->Classify(point) : 0;
  const PointType  lattice = this->ToLattice(point);
  const auto &     size = m_Mask->GetSize();
  for (const std::int32_t reach : { 0, 1, 2 })
  {
    double    best = std::numeric_limits<double>::infinity();
    IndexType nearest{};
    IndexType first;
    IndexType last;
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
          if (squared < best && m_Mask->Get(x, y, z) && (region == 0 || this->GetRegion(x, y, z) == region))
          {
            best = squared;
            nearest = { x, y, z };
          }
        }
      }
    }
    if (best < std::numeric_limits<double>::infinity())
    {
      return m_Components->Find(nearest[0], nearest[1], nearest[2]);
    }
  }
  return 0;
}

double
DelaunayRefinementLatticeOracle::FindLeastAt(const PointType & point, const std::vector<double> & values) const
{
  const PointType lattice = this->ToLattice(point);
  const auto &    size = m_Mask->GetSize();
  IndexType       cell;
  for (unsigned int i = 0; i < 3; ++i)
  {
    cell[i] = static_cast<std::int32_t>(std::clamp(lattice[i], 0.0, static_cast<double>(size[i])));
  }
  return this->FindRangeInCells(cell, cell, point, values).least;
}

DelaunayRefinementOracle::RangeType
DelaunayRefinementLatticeOracle::FindLeastInPatch(const SurfacePatches::PatchType & patch,
                                                  const std::vector<double> &       values) const
{
  const SurfacePatchIdentifier & identifier = patch.identifier;
  if (identifier.level >= CellLevel)
  {
    const IndexType cell = FindDelaunayRefinementPlace(identifier).cell;
    const double    least = this->FindRangeInCells(cell, cell, patch.center, values).least;
    return { least, least };
  }
  const std::int32_t edge = 1 << (CellLevel - identifier.level);
  IndexType          first = identifier.index;
  IndexType          last = identifier.index;
  for (unsigned int i = 0; i < 3; ++i)
  {
    first[i] *= edge;
    last[i] = first[i] + edge - 1;
  }
  const RangeType all = this->FindRangeInCells(first, last, patch.center, values);
  RangeType       range = all;
  if (all.least < all.greatest)
  {
    range = { all.greatest, all.least };
    for (std::int32_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::int32_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::int32_t x = first[0]; x <= last[0]; ++x)
        {
          if (m_Bricks->IsActiveCell({ x, y, z }))
          {
            const double least = this->FindRangeInCells({ x, y, z }, { x, y, z }, patch.center, values).least;
            range.least = std::min(range.least, least);
            range.greatest = std::max(range.greatest, least);
          }
        }
      }
    }
  }
  return range.least <= range.greatest ? range : all;
}

DelaunayRefinementOracle::RangeType
DelaunayRefinementLatticeOracle::FindRangeInCells(IndexType                   first,
                                                  IndexType                   last,
                                                  const PointType &           point,
                                                  const std::vector<double> & values) const
{
  const std::int32_t margin = GetMargin(m_Model);
  for (unsigned int i = 0; i < 3; ++i)
  {
    first[i] -= 1 + margin;
    last[i] += margin;
  }
  RangeType range{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  m_Components->VisitInBox(first, last, [&](ComponentType component) {
    range.least = std::min(range.least, values[component]);
    range.greatest = std::max(range.greatest, values[component]);
  });
  if (range.least > range.greatest)
  {
    range.least = values[this->FindComponent(point)];
    range.greatest = range.least;
  }
  return range;
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementLatticeOracle::GetComponentBounds(ComponentType component) const
{
  const auto &       info = m_Components->GetComponents()[component];
  const std::int32_t margin = GetMargin(m_Model);
  BoundsType         lattice;
  for (unsigned int i = 0; i < 3; ++i)
  {
    lattice.minimum[i] = info.minimum[i] - margin;
    lattice.maximum[i] = info.maximum[i] + 2 + margin;
  }
  return this->ToPhysical(lattice);
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementLatticeOracle::GetCavityBounds(std::uint32_t cavity) const
{
  const auto & info = m_Cavities->Get()[cavity];
  BoundsType   lattice;
  for (unsigned int i = 0; i < 3; ++i)
  {
    // Voxels are one further than their indexes, and the surface is within one of their centers.
    lattice.minimum[i] = info.least[i];
    lattice.maximum[i] = info.greatest[i] + 2;
  }
  return this->ToPhysical(lattice);
}

std::uint32_t
DelaunayRefinementLatticeOracle::GetNumberOfCavities() const
{
  return m_Cavities == nullptr ? 0 : static_cast<std::uint32_t>(m_Cavities->Get().size());
}

std::uint32_t
DelaunayRefinementLatticeOracle::FindCavity(const PointType & point) const
{
  const std::uint32_t number = this->GetNumberOfCavities();
  if (number == 0)
  {
    return number;
  }
  const PointType lattice = this->ToLattice(point);
  IndexType       cell;
  IndexType       nearest;
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (!(lattice[i] > 0.0 && lattice[i] < m_Mask->GetSize()[i] + 1.0))
    {
      return number;
    }
    cell[i] = static_cast<std::int32_t>(lattice[i]);
    nearest[i] = static_cast<std::int32_t>(lattice[i] + 0.5) - 1;
  }
  std::uint32_t cavity = m_Cavities->Find(nearest);
  if (m_Mask->Get(nearest[0], nearest[1], nearest[2]))
  {
    // A point outside may be nearest to a voxel of the object.
    for (std::int32_t i = 0; i < 8 && cavity == DelaunayRefinementVoxelCavities::None; ++i)
    {
      cavity = m_Cavities->Find({ cell[0] - 1 + (i & 1), cell[1] - 1 + (i >> 1 & 1), cell[2] - 1 + (i >> 2) });
    }
  }
  return std::min(cavity, number);
}
} // end namespace itk
