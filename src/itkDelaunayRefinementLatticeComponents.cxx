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

#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementGeometry.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** Tetrahedra of the mesh for each delta squared of surface, as measured on brains and livers. */
constexpr double TetrahedraPerArea = 3.4;

/** Tetrahedra of the mesh for each cell size cubed of volume, as measured on a ball. */
constexpr double TetrahedraPerVolume = 6.0;

constexpr double MostDefaultTetrahedra = 3e5;

/** The default delta is at least this many voxels. */
constexpr double DefaultDeltaInVoxels = 1.5;

/** No component gets a delta below this many voxels at the start. */
constexpr double LeastDeltaInVoxels = 0.1;

/** A component that holds no larger ball, in voxels, has no shape worth a fine mesh: it gets a larger delta. */
constexpr double ThinInVoxels = 0.75;
constexpr double DeltaPerRadiusOfThin = 1.5;

/** A component of fewer voxels may be left out. */
constexpr std::size_t FewVoxels = 8;

/** The radius of a ball in a single voxel's half level, in voxels. */
constexpr double RadiusOfVoxel = 0.35;

/** Voxels at the level of a grey image may make components without volume; these hold no larger ball. */
constexpr double LeastRadiusInVoxels = 0.01;

/** Components of few voxels are left out if delta is larger than this many radii. */
constexpr double LargestDeltaPerRadius = 4.0;
} // namespace

std::vector<DelaunayRefinementComponent>
DelaunayRefinementLatticeOracle::ComputeComponents(double enough) const
{
  // A tiny delta is no reason to call components thin.
  enough = std::max(enough, this->GetLeastSpacing());
  const auto & infos = m_Components->GetComponents();
  // Widths are measured along axes; a ball as wide as that along each may have less than that for a radius.
  const std::vector<IndexType> centers = this->FindThickVoxels(2.0 * enough + this->GetLeastSpacing());
  const double                 voxelVolume =
    std::abs(Geometry::Dot(m_Frame.axes[0], Geometry::Cross(m_Frame.axes[1], m_Frame.axes[2])));
  std::vector<DelaunayRefinementComponent> components(infos.size());
  // Single voxels of a mask look the same everywhere.
  const bool isMask = m_Model == ModelEnum::INDICATOR || m_Model == ModelEnum::NEAREST;
  for (std::size_t i = 0; i < infos.size(); ++i)
  {
    const IndexType & first = infos[i].firstVoxel;
    components[i].numberOfVoxels = infos[i].numberOfVoxels;
    components[i].volume = voxelVolume * static_cast<double>(infos[i].numberOfVoxels);
    components[i].firstVoxel = this->ToPhysical(PointType{ first[0] + 1.0, first[1] + 1.0, first[2] + 1.0 });
    components[i].inscribedRadius = isMask && infos[i].numberOfVoxels < FewVoxels
                                      ? RadiusOfVoxel * this->GetLeastSpacing()
                                      : this->ClimbToInscribedRadius(centers[i], enough);
  }
  return components;
}

std::vector<DelaunayRefinementLatticeOracle::IndexType>
DelaunayRefinementLatticeOracle::FindThickVoxels(double enough) const
{
  // The middles of some runs of each component; the thickness is that along the axis where it is least.
  constexpr std::size_t    mostCandidates = 256;
  const auto &             runs = m_Components->GetRuns();
  const auto &             size = m_Mask->GetSize();
  std::vector<std::size_t> numbersOfRuns(m_Components->GetComponents().size(), 0);
  for (const auto & run : runs)
  {
    ++numbersOfRuns[run.component];
  }
  std::vector<std::size_t> seen(numbersOfRuns.size(), 0);
  std::vector<IndexType>   thickest(numbersOfRuns.size());

  std::vector<std::pair<double, double>> best(numbersOfRuns.size());
  const auto                             measure = [&](const IndexType & voxel, unsigned int axis) {
    const double spacing = std::sqrt(m_Gram[axis][axis]);
    IndexType    low = voxel;
    IndexType    high = voxel;
    double       width = 0.0;
    while (width < enough && m_Mask->Get(low[0], low[1], low[2]) && m_Mask->Get(high[0], high[1], high[2]))
    {
      --low[axis];
      ++high[axis];
      width += spacing;
    }
    return width;
  };
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t i = m_Components->GetFirstRun(y, z); i < m_Components->GetFirstRun(y + 1, z); ++i)
      {
        const auto &      run = runs[i];
        const std::size_t stride = 1 + numbersOfRuns[run.component] / mostCandidates;
        if (seen[run.component]++ % stride == 0)
        {
          const IndexType             voxel{ (run.first + run.last) / 2, y, z };
          const std::array<double, 3> widths{ measure(voxel, 0), measure(voxel, 1), measure(voxel, 2) };
          // Between equals the sum decides, for grey values their height above the level.
          const double                    width = *std::min_element(widths.begin(), widths.end());
          const std::pair<double, double> thickness =
            m_Model == ModelEnum::GREY ? std::make_pair(width, this->GetVoxelValue(voxel[0], voxel[1], voxel[2]))
                                       : std::make_pair(width + 1e-3 * (widths[0] + widths[1] + widths[2]), 0.0);
          if (thickness > best[run.component])
          {
            best[run.component] = thickness;
            thickest[run.component] = voxel;
          }
        }
      }
    }
  }
  return thickest;
}

double
DelaunayRefinementLatticeOracle::ClimbToInscribedRadius(const IndexType & voxel, double enough) const
{
  constexpr unsigned int maximumNumberOfSteps = 16;
  constexpr double       smallestGain = 0.05;
  PointType              point = this->ToPhysical(PointType{ voxel[0] + 1.0, voxel[1] + 1.0, voxel[2] + 1.0 });
  const auto             radiusAt = [&](const PointType & p, PointType & closest) {
    return this->Classify(p) != 0 && this->FindClosestSurfacePoint(p, enough, closest) ? Geometry::Distance(p, closest)
                                                                                                   : -1.0;
  };
  PointType closest;
  double    radius = radiusAt(point, closest);
  if (radius < 0.0)
  {
    // Nothing near, if inside at all.
    return this->Classify(point) != 0 ? enough : 0.0;
  }
  double stride = 0.5;
  for (unsigned int step = 0; step < maximumNumberOfSteps && radius < enough && stride > smallestGain; ++step)
  {
    const PointType next = Geometry::AddScaled(point, stride, Geometry::Subtract(point, closest));
    if (this->Classify(next) == 0)
    {
      stride *= 0.5;
      continue;
    }
    PointType    nextClosest;
    const double nextRadius = radiusAt(next, nextClosest);
    if (nextRadius < 0.0)
    {
      return enough;
    }
    if (nextRadius > radius * (1.0 + smallestGain))
    {
      point = next;
      closest = nextClosest;
      radius = nextRadius;
    }
    else
    {
      stride *= 0.5;
    }
  }
  return radius;
}

double
DelaunayRefinementLatticeOracle::EstimateSurfaceArea() const
{
  std::array<double, 3>               faces{};
  const DelaunayRefinementVoxelMask & mask = *m_Mask;
  const auto &                        size = mask.GetSize();
  const std::size_t                   words = mask.GetWordsPerRow();
  for (std::int32_t z = 0; z <= size[2]; ++z)
  {
    for (std::int32_t y = 0; y <= size[1]; ++y)
    {
      const std::uint64_t * row = mask.GetRow(y, z);
      const std::uint64_t * nextY = mask.GetRow(y + 1, z);
      const std::uint64_t * nextZ = mask.GetRow(y, z + 1);
      for (std::size_t i = 0; i < words; ++i)
      {
        const std::uint64_t carry = i + 1 < words ? row[i + 1] << 63 : 0;
        const std::uint64_t changes[3] = { row[i] ^ (row[i] >> 1 | carry), row[i] ^ nextY[i], row[i] ^ nextZ[i] };
        if (changes[0] | changes[1] | changes[2])
        {
          for (unsigned int axis = 0; axis < 3; ++axis)
          {
            faces[axis] += CountDelaunayRefinementBits(changes[axis]);
          }
        }
      }
    }
  }
  // Over all orientations the faces of voxels have on average one and a half times the area of the smooth surface.
  double area = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const PointType normal = Geometry::Cross(m_Frame.axes[(i + 1) % 3], m_Frame.axes[(i + 2) % 3]);
    area += faces[i] * std::sqrt(Geometry::Dot(normal, normal)) / 1.5;
  }
  return area;
}

double
DelaunayRefinementLatticeOracle::ComputeVoxelVolume() const
{
  return std::abs(Geometry::Dot(m_Frame.axes[0], Geometry::Cross(m_Frame.axes[1], m_Frame.axes[2]))) *
         static_cast<double>(m_Mask->Count());
}

double
DelaunayRefinementLatticeOracle::ComputeDefaultDelta() const
{
  const double voxel =
    std::cbrt(std::abs(Geometry::Dot(m_Frame.axes[0], Geometry::Cross(m_Frame.axes[1], m_Frame.axes[2]))));
  return std::max(DefaultDeltaInVoxels * voxel,
                  std::sqrt(TetrahedraPerArea * this->EstimateSurfaceArea() / MostDefaultTetrahedra));
}

double
DelaunayRefinementLatticeOracle::ComputeComponentDelta(const DelaunayRefinementComponent & component,
                                                       double                              delta) const
{
  const double spacing = this->GetLeastSpacing();
  const double factor = component.inscribedRadius < ThinInVoxels * spacing ? DeltaPerRadiusOfThin : 1.0;
  return std::min(delta, std::max(factor * component.inscribedRadius, LeastDeltaInVoxels * spacing));
}

bool
DelaunayRefinementLatticeOracle::IsNegligible(const DelaunayRefinementComponent & component, double delta) const
{
  return component.numberOfVoxels < FewVoxels && delta > LargestDeltaPerRadius * component.inscribedRadius;
}

bool
DelaunayRefinementLatticeOracle::HasVolume(const DelaunayRefinementComponent & component) const
{
  return component.inscribedRadius > LeastRadiusInVoxels * this->GetLeastSpacing();
}

double
DelaunayRefinementLatticeOracle::GetLeastSpacing() const
{
  return std::sqrt(std::min({ m_Gram[0][0], m_Gram[1][1], m_Gram[2][2] }));
}

double
DelaunayRefinementLatticeOracle::EstimateNumberOfTetrahedra(const DelaunayRefinementParameters & parameters) const
{
  const double surface = TetrahedraPerArea * this->EstimateSurfaceArea() / (parameters.delta * parameters.delta);
  const double volume = TetrahedraPerVolume * this->ComputeVoxelVolume() / std::pow(parameters.cellSize, 3);
  return surface + volume;
}
} // end namespace itk
