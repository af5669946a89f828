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
#include "itkDelaunayRefinementBricks.h"
#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementVoxelCavities.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using Threads = DelaunayRefinementThreads;

/** Tetrahedra of the mesh for each delta squared of surface, as measured on brains and livers. */
constexpr double TetrahedraPerArea = 3.4;

/** Tetrahedra of the mesh for each cell size cubed of volume, as measured on a ball. */
constexpr double TetrahedraPerVolume = 6.0;

/** Over all orientations the faces of voxels have on average so many times the area of the smooth surface. */
constexpr double FaceAreaPerArea = 1.5;

constexpr double MostDefaultTetrahedra = 3e5;

/** Components differ much in the time they take. */
constexpr std::size_t ComponentsPerPiece = 4;

/** The default delta is at least this many voxels. */
constexpr double DefaultDeltaInVoxels = 1.5;

/** No component gets a delta below this many voxels at the start. */
constexpr double LeastDeltaInVoxels = 0.1;

/** A component that holds no larger ball, in voxels, has no shape worth a fine mesh: it gets a larger delta. */
constexpr double ThinInVoxels = 0.75;
constexpr double DeltaPerRadiusOfThin = 2.0;

/** The same for those of few voxels: single ones would be lost at more, and R1 asked again for their sake. */
constexpr double DeltaPerRadiusOfFew = 1.5;

/** A component of fewer voxels may be left out. */
constexpr std::size_t FewVoxels = 8;

/** Inscribed radii are too small by this share at most. */
constexpr double Slack = 0.02;

/** The same for a mask's components of fewer voxels, whose cells take long to search, if nobody needs to know better.
 */
constexpr double      SlackOfSmall = 0.1;
constexpr std::size_t SmallVoxels = 64;

/** The radius of a ball in a single voxel's half level, in voxels. */
constexpr double RadiusOfVoxel = 0.35;

/** Voxels at the level of a grey image may make components without volume; these hold no larger ball. */
constexpr double LeastRadiusInVoxels = 0.01;

/** Components of few voxels are left out if delta is larger than this many radii. */
constexpr double LargestDeltaPerRadius = 4.0;
} // namespace

std::vector<DelaunayRefinementComponent>
DelaunayRefinementLatticeOracle::ComputeComponents(double enough, bool isAccurate) const
{
  // A tiny delta is no reason to call components thin.
  enough = std::max(enough, this->GetLeastSpacing());
  const auto & infos = m_Components->GetComponents();
  // Widths are measured along axes; a ball as wide as that along each may have less than that for a radius.
  const std::vector<IndexType> centers = this->FindThickVoxels(2.0 * enough + this->GetLeastSpacing());
  const double                 voxelVolume = this->GetVoxelVolume();
  // Single voxels of a mask look the same everywhere.
  const bool                               isMask = m_Model == ModelEnum::INDICATOR || m_Model == ModelEnum::NEAREST;
  std::vector<DelaunayRefinementComponent> components(infos.size());
  Threads::RunPieces(m_Threads, infos.size(), ComponentsPerPiece, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const IndexType & first = infos[i].firstVoxel;
      const bool        isSmall = isMask && !isAccurate && infos[i].numberOfVoxels < SmallVoxels;
      components[i].numberOfVoxels = infos[i].numberOfVoxels;
      components[i].volume = voxelVolume * static_cast<double>(infos[i].numberOfVoxels);
      components[i].firstVoxel = this->ToPhysical(PointType{ first[0] + 1.0, first[1] + 1.0, first[2] + 1.0 });
      components[i].inscribedRadius =
        isMask && infos[i].numberOfVoxels < FewVoxels
          ? RadiusOfVoxel * this->GetLeastSpacing()
          : this->ClimbToInscribedRadius(centers[i], enough, isSmall ? SlackOfSmall : Slack);
      components[i].region = infos[i].region;
    }
  });
  return components;
}

std::vector<DelaunayRefinementCavity>
DelaunayRefinementLatticeOracle::FindCavities()
{
  if (m_Smoothed == nullptr)
  {
    m_Cavities = std::make_unique<DelaunayRefinementVoxelCavities>(*m_Components, m_Mask->GetSize());
  }
  std::vector<DelaunayRefinementCavity> cavities;
  for (const auto & cavity : m_Cavities->Get())
  {
    const IndexType & first = cavity.firstVoxel;
    cavities.push_back({ cavity.numberOfVoxels,
                         this->GetVoxelVolume() * static_cast<double>(cavity.numberOfVoxels),
                         this->ToPhysical(PointType{ first[0] + 1.0, first[1] + 1.0, first[2] + 1.0 }) });
  }
  return cavities;
}

double
DelaunayRefinementLatticeOracle::GetVoxelVolume() const
{
  return std::abs(Geometry::Dot(m_Frame.axes[0], Geometry::Cross(m_Frame.axes[1], m_Frame.axes[2])));
}

std::vector<DelaunayRefinementLatticeOracle::CandidateType>
DelaunayRefinementLatticeOracle::ChooseCandidates() const
{
  // The middles of every so many runs of each component.
  constexpr std::size_t    mostCandidates = 256;
  const auto &             runs = m_Components->GetRuns();
  const auto &             size = m_Mask->GetSize();
  std::vector<std::size_t> numbersOfRuns(m_Components->GetComponents().size(), 0);
  for (const auto & run : runs)
  {
    ++numbersOfRuns[run.component];
  }
  std::vector<std::size_t>   runsToSkip(numbersOfRuns.size(), 0);
  std::vector<CandidateType> candidates;
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      const std::size_t end = m_Components->GetFirstRun(y + 1, z);
      for (std::size_t i = m_Components->GetFirstRun(y, z); i < end; ++i)
      {
        const auto &  run = runs[i];
        std::size_t & toSkip = runsToSkip[run.component];
        if (toSkip == 0)
        {
          candidates.push_back({ { (run.first + run.last) / 2, y, z }, run.component });
          toSkip = 1 + numbersOfRuns[run.component] / mostCandidates;
        }
        --toSkip;
      }
    }
  }
  return candidates;
}

std::pair<double, double>
DelaunayRefinementLatticeOracle::MeasureThickness(const IndexType & voxel, double enough) const
{
  const RegionType region = this->HasRegions() ? this->GetRegion(voxel[0], voxel[1], voxel[2]) : 1;
  const auto       isInside = [&](const IndexType & v) {
    return m_Mask->Get(v[0], v[1], v[2]) && (!this->HasRegions() || this->GetRegion(v[0], v[1], v[2]) == region);
  };
  std::array<double, 3> widths{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double spacing = std::sqrt(m_Gram[axis][axis]);
    IndexType    low = voxel;
    IndexType    high = voxel;
    while (widths[axis] < enough && isInside(low) && isInside(high))
    {
      --low[axis];
      ++high[axis];
      widths[axis] += spacing;
    }
  }
  // Between equals the sum decides, for grey values their height above the level.
  const double width = *std::min_element(widths.begin(), widths.end());
  return m_Model == ModelEnum::GREY ? std::make_pair(width, this->GetValue(voxel[0], voxel[1], voxel[2]))
                                    : std::make_pair(width + 1e-3 * (widths[0] + widths[1] + widths[2]), 0.0);
}

std::vector<DelaunayRefinementLatticeOracle::IndexType>
DelaunayRefinementLatticeOracle::FindThickVoxels(double enough) const
{
  constexpr std::size_t                  leastLength = 64;
  const std::vector<CandidateType>       candidates = this->ChooseCandidates();
  std::vector<std::pair<double, double>> thicknesses(candidates.size());
  Threads::RunPieces(m_Threads,
                     candidates.size(),
                     Threads::ChoosePieceLength(m_Threads, candidates.size(), leastLength),
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i)
                       {
                         thicknesses[i] = this->MeasureThickness(candidates[i].voxel, enough);
                       }
                     });
  std::vector<IndexType>                 thickest(m_Components->GetComponents().size());
  std::vector<std::pair<double, double>> best(thickest.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (thicknesses[i] > best[candidates[i].component])
    {
      best[candidates[i].component] = thicknesses[i];
      thickest[candidates[i].component] = candidates[i].voxel;
    }
  }
  return thickest;
}

double
DelaunayRefinementLatticeOracle::ClimbToInscribedRadius(const IndexType & voxel, double enough, double slack) const
{
  constexpr unsigned int maximumNumberOfSteps = 16;
  constexpr double       smallestGain = 0.05;
  PointType              point = this->ToPhysical(PointType{ voxel[0] + 1.0, voxel[1] + 1.0, voxel[2] + 1.0 });
  const RegionType       region = this->HasRegions() ? this->GetRegion(voxel[0], voxel[1], voxel[2]) : 1;
  const auto             radiusAt = [&](const PointType & p, double nearEnough, PointType & closest) {
    return this->Classify(p) == region && this->FindClosestSurfacePoint(p, enough, nearEnough, slack, closest)
                         ? Geometry::Distance(p, closest)
                         : -1.0;
  };
  PointType closest;
  double    radius = radiusAt(point, 0.0, closest);
  if (radius < 0.0)
  {
    // Nothing near, if inside at all.
    return this->Classify(point) == region ? enough : 0.0;
  }
  double stride = 0.5;
  for (unsigned int step = 0; step < maximumNumberOfSteps && radius < enough && stride > smallestGain; ++step)
  {
    const PointType next = Geometry::AddScaled(point, stride, Geometry::Subtract(point, closest));
    if (this->Classify(next) != region)
    {
      stride *= 0.5;
      continue;
    }
    const double leastRadius = radius * (1.0 + smallestGain);
    PointType    nextClosest;
    const double nextRadius = radiusAt(next, leastRadius, nextClosest);
    if (nextRadius < 0.0)
    {
      return enough;
    }
    if (nextRadius > leastRadius)
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
  return (1.0 - slack) * radius;
}

double
DelaunayRefinementLatticeOracle::EstimateSurfaceArea() const
{
  const DelaunayRefinementVoxelMask &     mask = *m_Mask;
  constexpr std::size_t                   leastLength = 512;
  const std::size_t                       rowsPerSlice = static_cast<std::size_t>(mask.GetSize()[1]) + 1;
  const std::size_t                       rows = rowsPerSlice * (static_cast<std::size_t>(mask.GetSize()[2]) + 1);
  const std::size_t                       words = mask.GetWordsPerRow();
  const std::size_t                       length = Threads::ChoosePieceLength(m_Threads, rows, leastLength);
  std::vector<std::array<std::size_t, 3>> facesOfPieces(Threads::CountPieces(rows, length));
  Threads::RunPieces(m_Threads, rows, length, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    std::array<std::size_t, 3> faces{};
    for (std::size_t r = begin; r < end; ++r)
    {
      const auto y = static_cast<std::int32_t>(r % rowsPerSlice);
      const auto z = static_cast<std::int32_t>(r / rowsPerSlice);
      if (mask.IsRowEmpty(y, z) && mask.IsRowEmpty(y + 1, z) && mask.IsRowEmpty(y, z + 1))
      {
        continue;
      }
      const std::uint64_t * row = mask.GetRow(y, z);
      const std::uint64_t * nextY = mask.GetRow(y + 1, z);
      const std::uint64_t * nextZ = mask.GetRow(y, z + 1);
      for (std::size_t i = 0; i < words; ++i)
      {
        const std::uint64_t nextX = row[i] >> 1 | (i + 1 < words ? row[i + 1] << 63 : 0);
        std::uint64_t       changes[3] = { row[i] ^ nextX, row[i] ^ nextY[i], row[i] ^ nextZ[i] };
        if (this->HasRegions())
        {
          const std::uint64_t * along = m_Changes->GetRow(0, y, z);
          changes[0] |= row[i] & nextX & (along[i] >> 1 | (i + 1 < words ? along[i + 1] << 63 : 0));
          changes[1] |= row[i] & nextY[i] & m_Changes->GetRow(1, y + 1, z)[i];
          changes[2] |= row[i] & nextZ[i] & m_Changes->GetRow(2, y, z + 1)[i];
        }
        if (changes[0] | changes[1] | changes[2])
        {
          for (unsigned int axis = 0; axis < 3; ++axis)
          {
            faces[axis] += CountDelaunayRefinementBits(changes[axis]);
          }
        }
      }
    }
    facesOfPieces[piece] = faces;
  });
  std::array<double, 3> faces{};
  for (const auto & some : facesOfPieces)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      faces[axis] += static_cast<double>(some[axis]);
    }
  }
  double area = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    area += faces[i] * this->GetFaceArea(i) / FaceAreaPerArea;
  }
  return area;
}

double
DelaunayRefinementLatticeOracle::GetFaceArea(unsigned int axis) const
{
  const PointType normal = Geometry::Cross(m_Frame.axes[(axis + 1) % 3], m_Frame.axes[(axis + 2) % 3]);
  return std::sqrt(Geometry::Dot(normal, normal));
}

double
DelaunayRefinementLatticeOracle::ComputeVoxelVolume() const
{
  std::size_t numberOfVoxels = 0;
  for (const auto & info : m_Components->GetComponents())
  {
    numberOfVoxels += info.numberOfVoxels;
  }
  return this->GetVoxelVolume() * static_cast<double>(numberOfVoxels);
}

double
DelaunayRefinementLatticeOracle::ComputeDefaultDelta() const
{
  const double voxel = std::cbrt(this->GetVoxelVolume());
  return std::max(DefaultDeltaInVoxels * voxel,
                  std::sqrt(TetrahedraPerArea * this->EstimateSurfaceArea() / MostDefaultTetrahedra));
}

double
DelaunayRefinementLatticeOracle::ComputeComponentDelta(const DelaunayRefinementComponent & component,
                                                       double                              delta) const
{
  const double spacing = this->GetLeastSpacing();
  const double ofThin = component.numberOfVoxels < FewVoxels ? DeltaPerRadiusOfFew : DeltaPerRadiusOfThin;
  const double factor = component.inscribedRadius < ThinInVoxels * spacing ? ofThin : 1.0;
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
  return this->EstimateNumberOfTetrahedra(this->EstimateSurfaceArea(), parameters);
}

double
DelaunayRefinementLatticeOracle::BoundNumberOfTetrahedra(const DelaunayRefinementParameters & parameters) const
{
  // Around each face of voxels that differ are four cells with surface, and each of these has at most four such faces
  // across an axis.
  const double facesPerAxis = static_cast<double>(m_Bricks->CountActiveCells());
  return this->EstimateNumberOfTetrahedra(
    facesPerAxis * (this->GetFaceArea(0) + this->GetFaceArea(1) + this->GetFaceArea(2)) / FaceAreaPerArea, parameters);
}

double
DelaunayRefinementLatticeOracle::EstimateNumberOfTetrahedra(double                               area,
                                                            const DelaunayRefinementParameters & parameters) const
{
  const double surface = TetrahedraPerArea * area / (parameters.delta * parameters.delta);
  const double volume = TetrahedraPerVolume * this->ComputeVoxelVolume() / std::pow(parameters.cellSize, 3);
  return surface + volume;
}

double
DelaunayRefinementLatticeOracle::EstimateNumberOfTetrahedra(const DelaunayRefinementComponent & component,
                                                            double                              delta) const
{
  // A ball has three times its volume over its radius for a surface; no voxel has more than its six faces.
  const double radius = std::max(component.inscribedRadius, 0.5 * this->GetLeastSpacing());
  return TetrahedraPerArea * 3.0 * component.volume / (radius * delta * delta);
}
} // end namespace itk
