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
#include "itkDelaunayRefinementOracle.h"

#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementGeometry.h"

#include <algorithm>
#include <cmath>

namespace itk
{
DelaunayRefinementOracle::~DelaunayRefinementOracle() = default;

bool
DelaunayRefinementOracle::IsSurfaceWithin(const PointType & point, double distance) const
{
  PointType closest;
  return this->FindClosestSurfacePoint(point, distance, closest);
}

bool
DelaunayRefinementOracle::KnowsAllSurface() const
{
  return true;
}

DelaunayRefinementOracle::SurfaceCells::AxesType
DelaunayRefinementOracle::GetCellAxes() const
{
  return { PointType{ 1.0, 0.0, 0.0 }, PointType{ 0.0, 1.0, 0.0 }, PointType{ 0.0, 0.0, 1.0 } };
}

DelaunayRefinementOracle::SurfaceCells
DelaunayRefinementOracle::GetCellsOfPatch(const SurfacePatches::PatchType & patch) const
{
  using Geometry = DelaunayRefinementGeometry;
  return { 1,
           patch.identifier,
           Geometry::Subtract(patch.center, patch.halfExtents),
           Geometry::AddScaled(patch.halfExtents, 1.0, patch.halfExtents),
           0.0 };
}

void
DelaunayRefinementOracle::AppendCells(const SurfaceCells & cells, SurfacePatches & patches) const
{
  using Geometry = DelaunayRefinementGeometry;
  const auto   directions = Geometry::Invert(this->GetCellAxes());
  const double radius = 0.5 * std::sqrt(Geometry::Dot(cells.edges, cells.edges)) + 3.0 * cells.margin;
  PointType    halfExtents{};
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      halfExtents[j] += (0.5 * cells.edges[i] + cells.margin) * std::abs(directions[i][j]);
    }
  }
  for (std::uint64_t bits = cells.bits; bits != 0; bits &= bits - 1)
  {
    const auto patch = SurfaceCells::GetPatch(cells.first, FindDelaunayRefinementBit(bits));
    PointType  center{};
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double place = cells.corner[i] + (patch.index[i] - cells.first.index[i] + 0.5) * cells.edges[i];
      center = Geometry::AddScaled(center, place, directions[i]);
    }
    patches.Add(center, halfExtents, radius, patch);
  }
}

DelaunayRefinementOracle::JunctionPatchesType
DelaunayRefinementOracle::GetJunctionPatches() const
{
  return {};
}

void
DelaunayRefinementOracle::SplitJunctionPatch(const SurfacePatchIdentifier &, unsigned int, SurfacePatches &) const
{}

bool
DelaunayRefinementOracle::FindJunctionInPatch(const SurfacePatchIdentifier &, unsigned int, PointType &) const
{
  return false;
}

double
DelaunayRefinementOracle::FindLeastAt(const PointType & point, const std::vector<double> & values) const
{
  return values[this->FindComponent(point)];
}

DelaunayRefinementOracle::RangeType
DelaunayRefinementOracle::FindLeastInPatch(const SurfacePatches::PatchType & patch,
                                           const std::vector<double> &       values) const
{
  const double own = this->FindLeastAt(patch.center, values);
  RangeType    range{ own, own };
  for (ComponentType component = 0; component < values.size(); ++component)
  {
    const BoundsType bounds = this->GetComponentBounds(component);
    bool             isNear = true;
    for (unsigned int i = 0; i < 3; ++i)
    {
      isNear = isNear && bounds.minimum[i] - patch.radius <= patch.center[i] &&
               patch.center[i] <= bounds.maximum[i] + patch.radius;
    }
    if (isNear)
    {
      range.least = std::min(range.least, values[component]);
      range.greatest = std::max(range.greatest, values[component]);
    }
  }
  return range;
}

std::uint32_t
DelaunayRefinementOracle::GetNumberOfCavities() const
{
  return 0;
}

std::uint32_t
DelaunayRefinementOracle::FindCavity(const PointType &) const
{
  return this->GetNumberOfCavities();
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementOracle::GetComponentBounds(ComponentType) const
{
  return this->GetSurfaceBounds();
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementOracle::GetCavityBounds(std::uint32_t) const
{
  return this->GetSurfaceBounds();
}

DelaunayRefinementTopology
DelaunayRefinementOracle::CountTopology() const
{
  return {};
}
} // end namespace itk
