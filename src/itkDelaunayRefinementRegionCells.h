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
#ifndef itkDelaunayRefinementRegionCells_h
#define itkDelaunayRefinementRegionCells_h

#include "itkDelaunayRefinementCells.h"

#include <limits>

namespace itk
{
/** \class DelaunayRefinementTwoRegionsCell
 * \brief A cell with two regions, one of them possibly outside: another kind of cell says where the first is.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TCell>
class DelaunayRefinementTwoRegionsCell
{
public:
  using PointType = DelaunayRefinementPoint;

  /** \c cell is kept as it is, and must be there as long as this one is used. */
  DelaunayRefinementTwoRegionsCell(const TCell &            cell,
                                   DelaunayRefinementRegion inside,
                                   DelaunayRefinementRegion elsewhere)
    : m_Cell(cell)
    , m_Inside(inside)
    , m_Elsewhere(elsewhere)
  {}

  DelaunayRefinementRegion
  Classify(const PointType & p) const
  {
    return m_Cell.Classify(p) != 0 ? m_Inside : m_Elsewhere;
  }

  bool
  MayIntersect(const PointType & corner, double size) const
  {
    return m_Cell.MayIntersect(corner, size);
  }

  unsigned int
  FindOctants(const PointType & corner, double size) const
  {
    return m_Cell.FindOctants(corner, size);
  }

  static unsigned int
  SamplesPerSide(double size)
  {
    return TCell::SamplesPerSide(size);
  }

  bool
  FindFirstChange(const PointType & from, const PointType & to, DelaunayRefinementRegion region, double & share) const
  {
    if (region != m_Inside && region != m_Elsewhere)
    {
      share = 0.0;
      return true;
    }
    return m_Cell.FindFirstChange(from, to, region == m_Inside ? 1 : 0, share);
  }

  bool
  FindChangeTowardsFaces(const PointType & start, const PointType & corner, double size, PointType & found) const
  {
    return m_Cell.FindChangeTowardsFaces(start, corner, size, found);
  }

private:
  const TCell &            m_Cell;
  DelaunayRefinementRegion m_Inside;
  DelaunayRefinementRegion m_Elsewhere;
};

/** \class DelaunayRefinementRegionsCell
 * \brief A cell with any number of regions, each with weights at the corners that are interpolated in between.
 *
 * Outside is where all regions together weigh less than one half. Elsewhere the region with the largest weight has the
 * point, of equals the one with the smallest number.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementRegionsCell
{
public:
  using PointType = DelaunayRefinementPoint;

  /** A region and its weights at the corners, x fastest. */
  struct WeightsType
  {
    DelaunayRefinementRegion region;
    std::array<double, 8>    values;
  };

  /** All is outside. */
  DelaunayRefinementRegionsCell() = default;

  /** Each corner belongs to one region, x fastest. */
  explicit DelaunayRefinementRegionsCell(const std::array<DelaunayRefinementRegion, 8> & corners)
  {
    for (unsigned int i = 0; i < 8; ++i)
    {
      if (corners[i] != 0)
      {
        this->Add(corners[i], i, 1.0);
        this->SetUnion(i, 1.0);
      }
    }
  }

  /** Sets the weight of all regions together at a corner. */
  void
  SetUnion(unsigned int corner, double weight)
  {
    m_Union[corner] = weight;
  }

  /** Sets the weight of a region at a corner. Of more regions than a cell is likely to have the last ones weigh
   * nothing. */
  void
  Add(DelaunayRefinementRegion region, unsigned int corner, double weight)
  {
    unsigned int place = 0;
    while (place < m_Number && m_Weights[place].region < region)
    {
      ++place;
    }
    if (place == m_Number || m_Weights[place].region != region)
    {
      if (m_Number == MostRegions)
      {
        return;
      }
      std::copy_backward(m_Weights.begin() + place, m_Weights.begin() + m_Number, m_Weights.begin() + m_Number + 1);
      m_Weights[place] = { region, {} };
      ++m_Number;
    }
    m_Weights[place].values[corner] = weight;
  }

  DelaunayRefinementRegion
  Classify(const PointType & p) const
  {
    const auto shares = ComputeShares(p);
    if (Interpolate(m_Union, shares) < 0.5)
    {
      return 0;
    }
    DelaunayRefinementRegion region = 0;
    double                   largest = -std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < m_Number; ++i)
    {
      const double weight = Interpolate(m_Weights[i].values, shares);
      if (weight > largest)
      {
        largest = weight;
        region = m_Weights[i].region;
      }
    }
    return region;
  }

  bool
  MayIntersect(const PointType & corner, double size) const
  {
    // Differences of weights stay between their values at a cube's corners: so does what decides.
    return HasDifferentCorners(*this, corner, size);
  }

  unsigned int
  FindOctants(const PointType & corner, double size) const
  {
    const DelaunayRefinementOctantCorners all = this->FindOctantCorners(corner, size);
    unsigned int                          octants = 0;
    for (unsigned int i = 0; i < 8; ++i)
    {
      const auto corners = all.Get(i);
      octants |=
        (std::any_of(corners.begin(), corners.end(), [&](auto other) { return other != corners[0]; }) ? 1u : 0u) << i;
    }
    return octants;
  }

  /** The regions of the corners of a cube's octants. */
  DelaunayRefinementOctantCorners
  FindOctantCorners(const PointType & corner, double size) const
  {
    GridsType grids;
    this->InterpolateOnGrid(corner, size, grids);
    GridType largest;
    largest.fill(-std::numeric_limits<double>::infinity());
    std::array<DelaunayRefinementRegion, 27> regions{};
    for (unsigned int j = 0; j < m_Number; ++j)
    {
      for (unsigned int i = 0; i < 27; ++i)
      {
        regions[i] = grids.weights[j][i] > largest[i] ? m_Weights[j].region : regions[i];
        largest[i] = std::max(largest[i], grids.weights[j][i]);
      }
    }
    for (unsigned int i = 0; i < 27; ++i)
    {
      regions[i] = grids.all[i] < 0.5 ? 0 : regions[i];
    }
    return DelaunayRefinementOctantCorners(regions);
  }

  /** For each octant of a cube no less than the number of regions that have points there, outside counted. */
  std::array<unsigned int, 8>
  CountRegions(const PointType & corner, double size) const
  {
    GridsType grids;
    this->InterpolateOnGrid(corner, size, grids);
    std::array<unsigned int, 8> numbers;
    for (unsigned int octant = 0; octant < 8; ++octant)
    {
      numbers[octant] = this->CountRegions(grids, DelaunayRefinementOctantCorners::GetPlaces(octant));
    }
    return numbers;
  }

  static unsigned int
  SamplesPerSide(double)
  {
    return 1;
  }

  bool
  FindFirstChange(const PointType & from, const PointType & to, DelaunayRefinementRegion region, double & share) const
  {
    share = 0.0;
    if (this->Classify(from) != region)
    {
      return true;
    }
    // The first of the places where the region loses to outside or to another region.
    bool       isFound = false;
    const auto lookAt = [&](const std::array<double, 8> & values, DelaunayRefinementRegion side) {
      double found;
      if (DelaunayRefinementLinearCell(values, 0.0).FindFirstChange(from, to, side, found))
      {
        share = isFound ? std::min(share, found) : found;
        isFound = true;
      }
    };
    std::array<double, 8> values;
    for (unsigned int i = 0; i < 8; ++i)
    {
      values[i] = m_Union[i] - 0.5;
    }
    lookAt(values, region != 0 ? 1 : 0);
    const std::array<double, 8> * own = nullptr;
    for (unsigned int i = 0; i < m_Number && region != 0; ++i)
    {
      own = m_Weights[i].region == region ? &m_Weights[i].values : own;
    }
    for (unsigned int i = 0; i < m_Number && own != nullptr; ++i)
    {
      const bool isBefore = m_Weights[i].region < region;
      for (unsigned int j = 0; j < 8; ++j)
      {
        const double difference = m_Weights[i].values[j] - (*own)[j];
        values[j] = isBefore ? difference : -difference;
      }
      if (m_Weights[i].region != region)
      {
        lookAt(values, isBefore ? 0 : 1);
      }
    }
    return isFound;
  }

  bool
  FindChangeTowardsFaces(const PointType & start, const PointType & corner, double size, PointType & found) const
  {
    return FindChangeTowardsFacesOneByOne(*this, start, corner, size, found);
  }

private:
  /** How much each corner counts at a point. */
  static std::array<double, 8>
  ComputeShares(const PointType & p)
  {
    const PointType q{ 1.0 - p[0], 1.0 - p[1], 1.0 - p[2] };
    return { q[0] * q[1] * q[2], p[0] * q[1] * q[2], q[0] * p[1] * q[2], p[0] * p[1] * q[2],
             q[0] * q[1] * p[2], p[0] * q[1] * p[2], q[0] * p[1] * p[2], p[0] * p[1] * p[2] };
  }

  static double
  Interpolate(const std::array<double, 8> & values, const std::array<double, 8> & shares)
  {
    double sum = 0.0;
    for (unsigned int i = 0; i < 8; ++i)
    {
      sum += values[i] * shares[i];
    }
    return sum;
  }

  static constexpr unsigned int MostRegions = 24;

  /** Values at the corners of a cube's octants, x fastest. */
  using GridType = std::array<double, 27>;

  struct GridsType
  {
    GridType                          all;
    std::array<GridType, MostRegions> weights;
  };

  void
  InterpolateOnGrid(const PointType & corner, double size, GridsType & grids) const
  {
    InterpolateOnGrid(m_Union, corner, size, grids.all);
    for (unsigned int j = 0; j < m_Number; ++j)
    {
      InterpolateOnGrid(m_Weights[j].values, corner, size, grids.weights[j]);
    }
  }

  /** Axis by axis. */
  static void
  InterpolateOnGrid(const std::array<double, 8> & values, const PointType & corner, double size, GridType & grid)
  {
    std::array<double, 12> rows;
    std::array<double, 18> slices;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double share = corner[0] + 0.5 * i * size;
      for (unsigned int j = 0; j < 4; ++j)
      {
        rows[i + 3 * j] = (1.0 - share) * values[2 * j] + share * values[2 * j + 1];
      }
    }
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double share = corner[1] + 0.5 * i * size;
      for (unsigned int j = 0; j < 3; ++j)
      {
        slices[3 * i + j] = (1.0 - share) * rows[j] + share * rows[3 + j];
        slices[9 + 3 * i + j] = (1.0 - share) * rows[6 + j] + share * rows[9 + j];
      }
    }
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double share = corner[2] + 0.5 * i * size;
      for (unsigned int j = 0; j < 9; ++j)
      {
        grid[9 * i + j] = (1.0 - share) * slices[j] + share * slices[9 + j];
      }
    }
  }

  /** Of an octant, by the places of its corners in a grid. */
  unsigned int
  CountRegions(const GridsType & grids, const std::array<unsigned int, 8> & corners) const
  {
    const auto isInside = [&grids](unsigned int i) { return grids.all[i] >= 0.5; };
    if (std::none_of(corners.begin(), corners.end(), isInside))
    {
      return 1;
    }
    unsigned int number = std::all_of(corners.begin(), corners.end(), isInside) ? 0 : 1;
    for (unsigned int j = 0; j < m_Number; ++j)
    {
      // Weights' differences have their extremes at corners.
      bool mayHavePoints = true;
      for (unsigned int k = 0; k < m_Number && mayHavePoints; ++k)
      {
        const GridType & own = grids.weights[j];
        const GridType & other = grids.weights[k];
        mayHavePoints = j == k || std::any_of(corners.begin(), corners.end(), [&](unsigned int i) {
                          return j < k ? own[i] >= other[i] : own[i] > other[i];
                        });
      }
      number += mayHavePoints ? 1 : 0;
    }
    return number;
  }

  // In the order of the regions.
  std::array<WeightsType, MostRegions> m_Weights;
  unsigned int                         m_Number{ 0 };
  std::array<double, 8>                m_Union{};
};

/** The regions of the corners of the octants of a cube in a cell, all at once. */
inline DelaunayRefinementOctantCorners
FindOctantCorners(const DelaunayRefinementRegionsCell & cell, const DelaunayRefinementPoint & corner, double size)
{
  return cell.FindOctantCorners(corner, size);
}
} // end namespace itk

#endif
