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

/** The eighths of 4 x 4 x 4 cubes. */
constexpr std::uint64_t LowestEighth = 0x0000000000330033u;
constexpr std::uint64_t Eighths[8] = { LowestEighth,       LowestEighth << 2,  LowestEighth << 8,  LowestEighth << 10,
                                       LowestEighth << 32, LowestEighth << 34, LowestEighth << 40, LowestEighth << 42 };

constexpr unsigned int AllOctants = 0xFF;

/** The edge of a patch, in cells. */
double
GetSize(unsigned int level)
{
  return static_cast<double>(std::uint64_t{ 1 } << DelaunayRefinementLatticeOracle::CellLevel) /
         static_cast<double>(std::uint64_t{ 1 } << level);
}

PointType
ToPoint(const std::array<std::int32_t, 3> & index, double scale)
{
  return { index[0] * scale, index[1] * scale, index[2] * scale };
}

/** Of a cell's quarters those in one of its eighths, by number. */
unsigned int
GatherOctants(std::uint64_t quarters, const std::array<std::int32_t, 3> & eighth)
{
  const std::uint64_t bits = quarters >> (2 * (eighth[0] & 1) + 8 * (eighth[1] & 1) + 32 * (eighth[2] & 1));
  return static_cast<unsigned int>((bits & 3u) | (bits >> 2 & 12u) | (bits >> 12 & 48u) | (bits >> 14 & 192u));
}

/** Octants, by number, as one of the eighths of 4 x 4 x 4 cubes. */
std::uint64_t
ScatterOctants(std::uint64_t octants, std::int32_t eighth)
{
  const std::uint64_t bits = (octants & 3u) | (octants & 12u) << 2 | (octants & 48u) << 12 | (octants & 192u) << 14;
  return bits << (2 * (eighth & 1) + 8 * (eighth >> 1 & 1) + 32 * (eighth >> 2));
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

DelaunayRefinementOracle::SurfacePatches
DelaunayRefinementLatticeOracle::GetSurfacePatches() const
{
  SurfacePatches patches(this->GetSurfaceBounds().minimum);
  patches.Reserve(m_Bricks->GetActiveBricks().size());
  for (const IndexType & brick : m_Bricks->GetActiveBricks())
  {
    constexpr double size = DelaunayRefinementBricks::BrickSize;
    patches.Add(this->MakeShapeOfCubes(m_Bricks->GetCells(brick), 1.0),
                patches.MakeCorner(this->ToPhysical(ToPoint(brick, size))),
                { brick, 0 });
  }
  return patches;
}

void
DelaunayRefinementLatticeOracle::SplitSurfacePatch(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const
{
  if (patch.level < CellLevel)
  {
    this->SplitBrick(patch, parts);
    return;
  }
  if (patch.level == CellLevel)
  {
    this->SplitCell(patch, parts);
    return;
  }
  const unsigned int octants = this->GetOctants(patch);
  const double       quarter = 0.25 * GetSize(patch.level);
  const auto         shape = this->MakeShape({ quarter, quarter, quarter }, { quarter, quarter, quarter });
  for (std::int32_t i = 0; i < 8; ++i)
  {
    if (octants >> i & 1u)
    {
      const SurfacePatchIdentifier child = GetDelaunayRefinementChild(patch, i);
      parts.Add(shape, parts.MakeCorner(this->ToPhysical(ToPoint(child.index, 2.0 * quarter))), child);
    }
  }
}

unsigned int
DelaunayRefinementLatticeOracle::GetOctants(const SurfacePatchIdentifier & patch) const
{
  if (patch.level == CellLevel)
  {
    if (const unsigned int configuration = this->GetIndicatorConfiguration(patch.index))
    {
      return m_CellShapes[configuration].octants;
    }
    return m_Model == ModelEnum::NEAREST || m_Model == ModelEnum::FIELD
             ? AllOctants
             : this->FindOctants(patch.index, { 0.0, 0.0, 0.0 }, 1.0);
  }
  const DelaunayRefinementPlace place = FindDelaunayRefinementPlace(patch);
  const unsigned int configuration = patch.level == CellLevel + 1 ? this->GetIndicatorConfiguration(place.cell) : 0;
  return configuration != 0 ? GatherOctants(DelaunayRefinementIndicatorCell::Get(configuration).quarters, patch.index)
                            : this->FindOctants(place.cell, place.corner, place.size);
}

DelaunayRefinementOracle::SurfaceCells::AxesType
DelaunayRefinementLatticeOracle::GetCellAxes() const
{
  SurfaceCells::AxesType axes = m_InverseRows;
  for (unsigned int i = 0; i < 3; ++i)
  {
    axes[i] = { m_CellEdges[i] * axes[i][0], m_CellEdges[i] * axes[i][1], m_CellEdges[i] * axes[i][2] };
  }
  return axes;
}

DelaunayRefinementOracle::SurfaceCells
DelaunayRefinementLatticeOracle::GetCellsOfPatch(const SurfacePatches::PatchType & patch) const
{
  const SurfacePatchIdentifier & whole = patch.identifier;
  SurfaceCells                   cells;
  cells.first = { { 4 * whole.index[0], 4 * whole.index[1], 4 * whole.index[2] },
                  static_cast<std::uint8_t>(whole.level + 2) };
  cells.margin = 0.0;
  const double size = GetSize(cells.first.level);
  for (unsigned int i = 0; i < 3; ++i)
  {
    cells.corner[i] = m_CellEdges[i] * (Geometry::Dot(m_InverseRows[i], m_LatticeOrigin) + size * cells.first.index[i]);
    cells.edges[i] = size * m_CellEdges[i];
  }
  if (whole.level == 0)
  {
    cells.bits = m_Bricks->GetCells(whole.index);
    return cells;
  }
  cells.bits = 0;
  const unsigned int octants = whole.level < CellLevel ? AllOctants : this->GetOctants(whole);
  for (std::int32_t i = 0; i < 8; ++i)
  {
    const SurfacePatchIdentifier child = GetDelaunayRefinementChild(whole, i);
    if ((octants >> i & 1u) && (whole.level >= CellLevel || m_Bricks->IsActiveCell(child.index)))
    {
      cells.bits |= ScatterOctants(this->GetOctants(child), i);
    }
  }
  return cells;
}

void
DelaunayRefinementLatticeOracle::AppendCells(const SurfaceCells & cells, SurfacePatches & patches) const
{
  const unsigned int level = cells.first.level;
  const double       half = 0.5 * GetSize(level);
  const auto         cube = this->MakeShape({ half, half, half }, { half, half, half });
  for (std::uint64_t bits = cells.bits; bits != 0; bits &= bits - 1)
  {
    const SurfacePatchIdentifier patch = SurfaceCells::GetPatch(cells.first, FindDelaunayRefinementBit(bits));
    const auto                   corner = patches.MakeCorner(this->ToPhysical(ToPoint(patch.index, 2.0 * half)));
    if (level == CellLevel)
    {
      this->AddCell(patch, corner, patches);
    }
    else
    {
      patches.Add(cube, corner, patch);
    }
  }
}

void
DelaunayRefinementLatticeOracle::AddCell(const SurfacePatchIdentifier & cell,
                                         const std::array<float, 3> &   corner,
                                         SurfacePatches &               patches) const
{
  if (const unsigned int configuration = this->GetIndicatorConfiguration(cell.index))
  {
    patches.Add(m_CellShapes[configuration].cell, corner, cell);
  }
  else if (const std::uint64_t quarters = this->GetQuarters(cell.index))
  {
    patches.Add(this->MakeShapeOfCubes(quarters, 0.25), corner, cell);
  }
}

void
DelaunayRefinementLatticeOracle::SplitBrick(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const
{
  const IndexType brick{ patch.index[0] >> patch.level, patch.index[1] >> patch.level, patch.index[2] >> patch.level };
  const std::uint64_t cells = m_Bricks->GetCells(brick);
  if (patch.level == 0)
  {
    constexpr double size = DelaunayRefinementBricks::BrickSize;
    const auto       corner = parts.MakeCorner(this->ToPhysical(ToPoint(brick, size)));
    for (std::int32_t i = 0; i < 8; ++i)
    {
      if (cells & Eighths[i])
      {
        parts.Add(this->MakeShapeOfCubes(cells & Eighths[i], 1.0), corner, GetDelaunayRefinementChild(patch, i));
      }
    }
    return;
  }
  const auto first = parts.MakeCorner(this->ToPhysical(ToPoint(patch.index, 2.0)));
  for (std::int32_t i = 0; i < 8; ++i)
  {
    const SurfacePatchIdentifier child = GetDelaunayRefinementChild(patch, i);
    if (cells >> DelaunayRefinementBricks::GetBit(child.index) & 1u)
    {
      const std::array<float, 3> corner{ first[0] + m_CornerOffsets[i][0],
                                         first[1] + m_CornerOffsets[i][1],
                                         first[2] + m_CornerOffsets[i][2] };
      this->AddCell(child, corner, parts);
    }
  }
}

void
DelaunayRefinementLatticeOracle::SplitCell(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const
{
  const IndexType & cell = patch.index;
  const auto        corner = parts.MakeCorner(this->ToPhysical(ToPoint(cell, 1.0)));
  if (const unsigned int configuration = this->GetIndicatorConfiguration(cell))
  {
    const CellShapesType & shapes = m_CellShapes[configuration];
    for (std::int32_t i = 0; i < 8; ++i)
    {
      if (shapes.octants >> i & 1u)
      {
        parts.Add(shapes.parts[i], corner, GetDelaunayRefinementChild(patch, i));
      }
    }
    return;
  }
  const std::uint64_t quarters = this->GetQuarters(cell);
  for (std::int32_t i = 0; i < 8; ++i)
  {
    if (quarters & Eighths[i])
    {
      parts.Add(this->MakeShapeOfCubes(quarters & Eighths[i], 0.25), corner, GetDelaunayRefinementChild(patch, i));
    }
  }
}

std::uint64_t
DelaunayRefinementLatticeOracle::GetQuarters(const IndexType & cell) const
{
  if (m_Model == ModelEnum::NEAREST || m_Model == ModelEnum::FIELD)
  {
    return ~std::uint64_t{ 0 };
  }
  const unsigned int octants = this->FindOctants(cell, { 0.0, 0.0, 0.0 }, 1.0);
  std::uint64_t      quarters = 0;
  for (unsigned int i = 0; i < 8; ++i)
  {
    quarters |= (octants >> i & 1u) ? Eighths[i] : 0;
  }
  return quarters;
}

std::vector<DelaunayRefinementLatticeOracle::CellShapesType>
DelaunayRefinementLatticeOracle::MakeCellShapes() const
{
  std::vector<CellShapesType> shapes(256);
  for (unsigned int configuration = 1; configuration < 255; ++configuration)
  {
    const std::uint64_t quarters = DelaunayRefinementIndicatorCell::Get(configuration).quarters;
    shapes[configuration].cell = this->MakeShapeOfCubes(quarters, 0.25);
    for (unsigned int i = 0; i < 8; ++i)
    {
      if (quarters & Eighths[i])
      {
        shapes[configuration].octants |= 1u << i;
        shapes[configuration].parts[i] = this->MakeShapeOfCubes(quarters & Eighths[i], 0.25);
      }
    }
  }
  return shapes;
}

unsigned int
DelaunayRefinementLatticeOracle::FindOctants(const IndexType & cell, const PointType & corner, double size) const
{
  return this->VisitCell(cell, [&](const auto & content) { return content.FindOctants(corner, size); });
}

DelaunayRefinementOracle::SurfacePatches::ShapeType
DelaunayRefinementLatticeOracle::MakeShape(const PointType & center, const PointType & extents) const
{
  const PointType physical = Geometry::Subtract(this->ToPhysical(center), m_LatticeOrigin);
  return SurfacePatches::MakeShape(physical, this->GetHalfExtents(extents), this->GetGreatestLength(extents));
}

DelaunayRefinementOracle::SurfacePatches::ShapeType
DelaunayRefinementLatticeOracle::MakeShapeOfCubes(std::uint64_t cubes, double cubeSize) const
{
  // Twice the middle of the first and the last number along an axis, and how many there are from one to the other.
  constexpr std::uint8_t middles[16] = { 4, 1, 3, 2, 5, 3, 4, 3, 7, 4, 5, 4, 6, 4, 5, 4 };
  constexpr std::uint8_t lengths[16] = { 4, 1, 1, 2, 1, 3, 2, 3, 1, 4, 3, 4, 2, 4, 3, 4 };
  PointType              center;
  PointType              extents;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int numbers = GetDelaunayRefinementLayers(cubes, i);
    center[i] = 0.5 * cubeSize * middles[numbers];
    extents[i] = 0.5 * cubeSize * lengths[numbers];
  }
  return this->MakeShape(center, extents);
}

bool
DelaunayRefinementLatticeOracle::FindPointOfPatch(const SurfacePatchIdentifier & patch, PointType & point) const
{
  const PointType random = Scatter(patch.index, patch.level);
  const auto      findIn = [&](const DelaunayRefinementPlace & place) {
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
    point = this->ToPhysical(Geometry::AddScaled(ToPoint(place.cell, 1.0), 1.0, found));
    return true;
  };
  if (patch.level >= CellLevel)
  {
    return findIn(FindDelaunayRefinementPlace(patch));
  }

  // Some cell of those with surface; the others if a field has none there.
  const IndexType brick{ patch.index[0] >> patch.level, patch.index[1] >> patch.level, patch.index[2] >> patch.level };
  std::uint64_t   cells = m_Bricks->GetCells(brick);
  if (patch.level > 0)
  {
    cells &= Eighths[(patch.index[0] & 1) | (patch.index[1] & 1) << 1 | (patch.index[2] & 1) << 2];
  }
  std::uint64_t after = cells;
  for (auto skipped = static_cast<unsigned int>(random[0] * CountDelaunayRefinementBits(cells)); skipped > 0; --skipped)
  {
    after &= after - 1;
  }
  while (cells != 0)
  {
    const unsigned int chosen = FindDelaunayRefinementBit(after != 0 ? after : cells);
    if (findIn({ DelaunayRefinementBricks::GetCell(brick, chosen), {}, 1.0 }))
    {
      return true;
    }
    cells &= ~(std::uint64_t{ 1 } << chosen);
    after &= cells;
  }
  return false;
}
} // end namespace itk
