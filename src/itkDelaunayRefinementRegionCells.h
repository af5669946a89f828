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
    const DelaunayRefinementOctantCorners all(*this, corner, size);
    unsigned int                          octants = 0;
    for (unsigned int i = 0; i < 8; ++i)
    {
      const auto corners = all.Get(i);
      octants |=
        (std::any_of(corners.begin(), corners.end(), [&](auto other) { return other != corners[0]; }) ? 1u : 0u) << i;
    }
    return octants;
  }

  /** No less than the number of regions that have points in a cube, outside counted. */
  unsigned int
  CountRegions(const PointType & corner, double size) const
  {
    std::array<std::array<double, 8>, MostRegions> weights;
    bool                                           isAnyInside = false;
    bool                                           isAnyOutside = false;
    for (unsigned int i = 0; i < 8; ++i)
    {
      const auto shares =
        ComputeShares({ corner[0] + (i & 1u) * size, corner[1] + (i >> 1 & 1u) * size, corner[2] + (i >> 2) * size });
      const bool isOutside = Interpolate(m_Union, shares) < 0.5;
      isAnyOutside = isAnyOutside || isOutside;
      isAnyInside = isAnyInside || !isOutside;
      for (unsigned int j = 0; j < m_Number; ++j)
      {
        weights[j][i] = Interpolate(m_Weights[j].values, shares);
      }
    }
    unsigned int number = isAnyOutside ? 1 : 0;
    for (unsigned int j = 0; j < m_Number && isAnyInside; ++j)
    {
      // Weights' differences have their extremes at corners.
      bool mayHavePoints = true;
      for (unsigned int k = 0; k < m_Number && mayHavePoints; ++k)
      {
        mayHavePoints = j == k;
        for (unsigned int i = 0; i < 8; ++i)
        {
          mayHavePoints = mayHavePoints || (j < k ? weights[j][i] >= weights[k][i] : weights[j][i] > weights[k][i]);
        }
      }
      number += mayHavePoints ? 1 : 0;
    }
    return number;
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

  // In the order of the regions.
  std::array<WeightsType, MostRegions> m_Weights;
  unsigned int                         m_Number{ 0 };
  std::array<double, 8>                m_Union{};
};
} // end namespace itk

#endif
