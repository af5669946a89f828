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

/** Patches of this level are single cells; those of level 0 are bricks. */
constexpr unsigned int CellLevel = 2;

/** A cube within a cell. */
struct PlaceType
{
  std::array<std::int32_t, 3> cell;
  PointType                   corner;
  double                      size;
};

/** In voxels. */
double
GetPatchSize(unsigned int level)
{
  return static_cast<double>(DelaunayRefinementBricks::BrickSize) / static_cast<double>(std::uint64_t{ 1 } << level);
}

PlaceType
ToPlace(const std::array<std::int32_t, 3> & index, unsigned int level)
{
  const unsigned int shift = level - CellLevel;
  PlaceType          place;
  place.size = GetPatchSize(level);
  for (unsigned int i = 0; i < 3; ++i)
  {
    place.cell[i] = index[i] >> shift;
    place.corner[i] = index[i] * place.size - place.cell[i];
  }
  return place;
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

} // namespace

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
  unsigned int octants = 0xFFu;
  if (patch.level >= CellLevel)
  {
    const PlaceType place = ToPlace(patch.index, patch.level);
    octants = this->FindOctants(place.cell, place.corner, place.size);
  }
  for (std::int32_t child = 0; child < 8; ++child)
  {
    SurfacePatch part;
    if ((octants >> child & 1u) && this->MakePatch({ 2 * patch.index[0] + (child & 1),
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

unsigned int
DelaunayRefinementLatticeOracle::FindOctants(const IndexType & cell, const PointType & corner, double size) const
{
  if (m_Model == ModelEnum::INDICATOR && size == 1.0)
  {
    return DelaunayRefinementIndicatorCell::Get(m_Mask->GetConfiguration(cell[0], cell[1], cell[2])).octants;
  }
  return this->VisitCell(cell, [&](const auto & content) { return content.FindOctants(corner, size); });
}

bool
DelaunayRefinementLatticeOracle::MakePatch(const IndexType & index, unsigned int level, SurfacePatch & patch) const
{
  const double size = GetPatchSize(level);
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
    unsigned int octants = 0xFFu;
    if (level == CellLevel)
    {
      if (!m_Bricks->IsActiveCell(index))
      {
        return false;
      }
      if (m_Model == ModelEnum::INDICATOR || m_Model == ModelEnum::GREY)
      {
        octants = this->FindOctants(index, { 0.0, 0.0, 0.0 }, 1.0);
      }
    }
    // The bounds of the octants with surface.
    constexpr unsigned int lower[3] = { 0x55u, 0x33u, 0x0Fu };
    for (unsigned int i = 0; i < 3; ++i)
    {
      const bool hasLower = octants & lower[i];
      const bool hasUpper = octants & ~lower[i];
      if (hasLower != hasUpper)
      {
        extents[i] *= 0.5;
        center[i] += hasLower ? -extents[i] : extents[i];
      }
    }
  }
  patch.center = this->ToPhysical(center);
  if (extents[0] == half && extents[1] == half && extents[2] == half)
  {
    patch.radius = half * m_CubeRadius;
    patch.halfExtents = { half * m_CubeHalfExtents[0], half * m_CubeHalfExtents[1], half * m_CubeHalfExtents[2] };
  }
  else
  {
    patch.radius = this->GetGreatestLength(extents);
    patch.halfExtents = this->GetHalfExtents(extents);
  }
  patch.index = index;
  patch.level = static_cast<std::uint8_t>(level);
  return true;
}

bool
DelaunayRefinementLatticeOracle::FindPointOfPatch(const SurfacePatch & patch, PointType & point) const
{
  const unsigned int level = patch.level;
  const PointType    random = Scatter(patch.index, level);
  PlaceType          place{ {}, {}, 1.0 };
  if (level < CellLevel)
  {
    // Some cell of those with surface.
    std::uint64_t active = this->GetCellsOfPatch(patch.index, level);
    for (auto skipped = static_cast<unsigned int>(random[0] * CountDelaunayRefinementBits(active)); skipped > 0;
         --skipped)
    {
      active &= active - 1;
    }
    const auto chosen = static_cast<std::int32_t>(FindDelaunayRefinementBit(active));
    place.cell = { (patch.index[0] >> level << CellLevel) + (chosen & 3),
                   (patch.index[1] >> level << CellLevel) + (chosen >> 2 & 3),
                   (patch.index[2] >> level << CellLevel) + (chosen >> 4) };
  }
  else
  {
    place = ToPlace(patch.index, level);
  }
  const PointType start{ place.corner[0] + random[0] * place.size,
                         place.corner[1] + random[1] * place.size,
                         place.corner[2] + random[2] * place.size };
  PointType       found;
  if (!this->VisitCell(place.cell, [&](const auto & content) {
        return FindSurfacePointInCube(content, place.corner, place.size, start, found);
      }))
  {
    return false;
  }
  point = this->ToPhysical(PointType{ found[0] + place.cell[0], found[1] + place.cell[1], found[2] + place.cell[2] });
  return true;
}
} // end namespace itk
