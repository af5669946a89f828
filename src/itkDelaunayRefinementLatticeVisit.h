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
#ifndef itkDelaunayRefinementLatticeVisit_h
#define itkDelaunayRefinementLatticeVisit_h

#include "itkDelaunayRefinementBricks.h"
#include "itkDelaunayRefinementCells.h"
#include "itkDelaunayRefinementLatticeOracle.h"
#include "itkDelaunayRefinementRegionCells.h"

// Shared by the sources of the lattice oracle alone.

namespace itk
{
/** The position within a cell, from lattice coordinates. */
inline DelaunayRefinementPoint
ToLocal(const DelaunayRefinementPoint & lattice, const std::array<std::int32_t, 3> & cell)
{
  return { lattice[0] - cell[0], lattice[1] - cell[1], lattice[2] - cell[2] };
}

/** A cube within a cell. */
struct DelaunayRefinementPlace
{
  std::array<std::int32_t, 3> cell;
  DelaunayRefinementPoint     corner;
  double                      size;
};

/** Where a patch of a level from CellLevel is. */
inline DelaunayRefinementPlace
FindDelaunayRefinementPlace(const DelaunayRefinementOracle::SurfacePatchIdentifier & patch)
{
  const unsigned int      shift = patch.level - DelaunayRefinementLatticeOracle::CellLevel;
  DelaunayRefinementPlace place;
  place.size = 1.0 / static_cast<double>(std::uint64_t{ 1 } << shift);
  for (unsigned int i = 0; i < 3; ++i)
  {
    place.cell[i] = patch.index[i] >> shift;
    place.corner[i] = patch.index[i] * place.size - place.cell[i];
  }
  return place;
}

/** An eighth of a patch. */
inline DelaunayRefinementOracle::SurfacePatchIdentifier
GetDelaunayRefinementChild(const DelaunayRefinementOracle::SurfacePatchIdentifier & patch, std::int32_t child)
{
  return {
    { 2 * patch.index[0] + (child & 1), 2 * patch.index[1] + (child >> 1 & 1), 2 * patch.index[2] + (child >> 2) },
    static_cast<std::uint8_t>(patch.level + 1)
  };
}

/** The cells of a mask's interpolated indicator, by configuration, with the quarters that may hold surface. */
struct DelaunayRefinementIndicatorCell
{
  DelaunayRefinementLinearCell cell;
  std::uint64_t                quarters;

  static const DelaunayRefinementIndicatorCell &
  Get(unsigned int configuration)
  {
    static const std::vector<DelaunayRefinementIndicatorCell> cells = MakeAll();
    return cells[configuration];
  }

  /** Of a configuration, with the mask raised at some of the corners outside. */
  static DelaunayRefinementLinearCell
  MakeRaised(unsigned int configuration, unsigned int raised)
  {
    std::array<double, 8> values;
    for (unsigned int i = 0; i < 8; ++i)
    {
      values[i] = (configuration >> i & 1u) ? 0.5 : (raised >> i & 1u) ? -0.25 : -0.5;
    }
    // Exact: quarters, at places with few digits.
    return { values, 0.0 };
  }

private:
  static std::vector<DelaunayRefinementIndicatorCell>
  MakeAll();
};

/** Two regions that share the corners of a cell between them. */
struct DelaunayRefinementPair
{
  /** The corners that belong to \c inside; 0 if there are more than two regions. */
  unsigned int configuration;
  /** The smaller one of the two that is not outside: at equal weights points are its own. */
  DelaunayRefinementRegion inside;
  DelaunayRefinementRegion elsewhere;
};

/** Of corners that are not all alike. */
inline DelaunayRefinementPair
FindDelaunayRefinementPair(const std::array<DelaunayRefinementRegion, 8> & corners)
{
  DelaunayRefinementPair pair{ 0, corners[0], corners[0] };
  for (const DelaunayRefinementRegion corner : corners)
  {
    pair.elsewhere = corner != pair.inside ? corner : pair.elsewhere;
  }
  if (pair.inside == 0 || (pair.elsewhere != 0 && pair.elsewhere < pair.inside))
  {
    std::swap(pair.inside, pair.elsewhere);
  }
  for (unsigned int i = 0; i < 8; ++i)
  {
    if (corners[i] == pair.inside)
    {
      pair.configuration |= 1u << i;
    }
    else if (corners[i] != pair.elsewhere)
    {
      pair.configuration = 0;
      break;
    }
  }
  return pair;
}

template <typename TVisitor>
auto
DelaunayRefinementLatticeOracle::VisitCell(const IndexType & cell, const TVisitor & visitor) const
{
  if (m_Model == ModelEnum::INDICATOR)
  {
    if (!this->HasRegions())
    {
      const unsigned int configuration = m_Mask->GetConfiguration(cell[0], cell[1], cell[2]);
      const unsigned int raised = this->GetRaised(cell);
      return raised != 0 ? visitor(DelaunayRefinementIndicatorCell::MakeRaised(configuration, raised))
                         : visitor(DelaunayRefinementIndicatorCell::Get(configuration).cell);
    }
    if (m_Smoothed != nullptr)
    {
      return visitor(this->MakeSmoothedCell(cell));
    }
    const auto corners = this->GetCellRegions(cell);
    if (const auto pair = FindDelaunayRefinementPair(corners); pair.configuration != 0)
    {
      const auto & indicator = DelaunayRefinementIndicatorCell::Get(pair.configuration).cell;
      return visitor(
        DelaunayRefinementTwoRegionsCell<DelaunayRefinementLinearCell>(indicator, pair.inside, pair.elsewhere));
    }
    return visitor(DelaunayRefinementRegionsCell(corners));
  }
  if (m_Model == ModelEnum::NEAREST)
  {
    return visitor(DelaunayRefinementNearestCell(this->GetCellRegions(cell)));
  }
  if (m_Model == ModelEnum::FIELD)
  {
    const auto isInside = [this, &cell](const PointType & local) {
      return this->IsInsideField({ local[0] + cell[0] - 1, local[1] + cell[1] - 1, local[2] + cell[2] - 1 });
    };
    return visitor(DelaunayRefinementFieldCell<decltype(isInside)>(isInside));
  }
  const std::array<double, 8> values = this->GetCellValues(cell);
  double                      largest = 0.0;
  for (const double value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  // Surface may lie in the faces of cubes, as it does half a voxel beyond the border; were a cube's corners taken as
  // they are rounded, it could be in none of them.
  constexpr double roundings = 128.0;
  return visitor(DelaunayRefinementLinearCell(values, roundings * std::numeric_limits<double>::epsilon() * largest));
}

} // end namespace itk

#endif
