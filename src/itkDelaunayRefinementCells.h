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
#ifndef itkDelaunayRefinementCells_h
#define itkDelaunayRefinementCells_h

#include "itkDelaunayRefinementTypes.h"

#include <algorithm>
#include <cmath>

namespace itk
{
/** The kinds of cells say which region is where in the unit cube between eight voxel centers; 0 is outside. All offer:
 * Classify(point), MayIntersect(corner, size) for a cube within the cell (false only if the surface misses it),
 * FindOctants(corner, size) (a bit for each octant of the cube, x fastest; 0 only if the surface misses it),
 * SamplesPerSide(size) (on a grid so fine the cube is mixed if it holds surface), FindFirstChange(from, to, region,
 * share): the first share of the way at which the region is not \c region, and FindChangeTowardsFaces(start, corner,
 * size, found): a change on the way from a point of a cube straight to one of its faces. Those here have one region
 * inside, numbered 1, but for nearest corners. */

/** FindOctants() by MayIntersect(). */
template <typename TCell>
unsigned int
FindOctantsOneByOne(const TCell & cell, const DelaunayRefinementPoint & corner, double size)
{
  const double half = 0.5 * size;
  unsigned int octants = 0;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const DelaunayRefinementPoint at{ corner[0] + (i & 1u) * half,
                                      corner[1] + (i >> 1 & 1u) * half,
                                      corner[2] + (i >> 2) * half };
    octants |= (cell.MayIntersect(at, half) ? 1u : 0u) << i;
  }
  return octants;
}

/** Whether the corners of a cube lie in different regions. */
template <typename TCell>
bool
HasDifferentCorners(const TCell & cell, const DelaunayRefinementPoint & corner, double size)
{
  const DelaunayRefinementRegion first = cell.Classify(corner);
  for (unsigned int i = 1; i < 8; ++i)
  {
    if (cell.Classify({ corner[0] + (i & 1u) * size, corner[1] + (i >> 1 & 1u) * size, corner[2] + (i >> 2) * size }) !=
        first)
    {
      return true;
    }
  }
  return false;
}

/** \class DelaunayRefinementOctantCorners
 * \brief The regions of the corners of a cube's octants.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementOctantCorners
{
public:
  /** The regions, x fastest. */
  explicit DelaunayRefinementOctantCorners(const std::array<DelaunayRefinementRegion, 27> & regions)
    : m_Regions(regions)
  {}

  /** Where the corners of an octant are among all, x fastest. */
  static std::array<unsigned int, 8>
  GetPlaces(unsigned int octant)
  {
    const unsigned int first = (octant & 1u) + 3 * (octant >> 1 & 1u) + 9 * (octant >> 2);
    return { first, first + 1, first + 3, first + 4, first + 9, first + 10, first + 12, first + 13 };
  }

  /** All of them. */
  const std::array<DelaunayRefinementRegion, 27> &
  Get() const
  {
    return m_Regions;
  }

  /** Those of one octant, x fastest. */
  std::array<DelaunayRefinementRegion, 8>
  Get(unsigned int octant) const
  {
    std::array<DelaunayRefinementRegion, 8> regions;
    const auto                              places = GetPlaces(octant);
    std::transform(places.begin(), places.end(), regions.begin(), [this](unsigned int i) { return m_Regions[i]; });
    return regions;
  }

private:
  std::array<DelaunayRefinementRegion, 27> m_Regions;
};

/** The regions of the corners of the octants of a cube in a cell, one by one. */
template <typename TCell>
DelaunayRefinementOctantCorners
FindOctantCorners(const TCell & cell, const DelaunayRefinementPoint & corner, double size)
{
  const double                             half = 0.5 * size;
  std::array<DelaunayRefinementRegion, 27> regions;
  for (unsigned int i = 0; i < 27; ++i)
  {
    regions[i] = cell.Classify({ corner[0] + i % 3 * half, corner[1] + i / 3 % 3 * half, corner[2] + i / 9 * half });
  }
  return DelaunayRefinementOctantCorners(regions);
}

/** Finds the first change between a point of a cell and another in another region; false if that is in the same. */
template <typename TCell>
bool
FindChangeTowards(const TCell &                   cell,
                  const DelaunayRefinementPoint & start,
                  const DelaunayRefinementPoint & end,
                  DelaunayRefinementPoint &       found)
{
  const DelaunayRefinementRegion region = cell.Classify(start);
  if (cell.Classify(end) == region)
  {
    return false;
  }
  // Rounding may hide a change that is at the very end.
  double share;
  if (!cell.FindFirstChange(start, end, region, share))
  {
    share = 1.0;
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    found[i] = start[i] + share * (end[i] - start[i]);
  }
  return true;
}

/** FindChangeTowardsFaces() by FindChangeTowards(). */
template <typename TCell>
bool
FindChangeTowardsFacesOneByOne(const TCell &                   cell,
                               const DelaunayRefinementPoint & start,
                               const DelaunayRefinementPoint & corner,
                               double                          size,
                               DelaunayRefinementPoint &       found)
{
  for (unsigned int face = 0; face < 6; ++face)
  {
    DelaunayRefinementPoint end = start;
    end[face / 2] = corner[face / 2] + (face % 2) * size;
    if (FindChangeTowards(cell, start, end, found))
    {
      return true;
    }
  }
  return false;
}

/** \class DelaunayRefinementLinearCell
 * \brief Inside is where the trilinear interpolation of eight corner values is >= 0.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementLinearCell
{
public:
  using PointType = DelaunayRefinementPoint;

  /** Corner values in the order of voxel masks' configurations: x fastest. \c noise bounds what rounding does to
   * interpolated values; those nearer to 0 may be on either side. 0 where they are exact. */
  DelaunayRefinementLinearCell(const std::array<double, 8> & v, double noise)
    : m_Noise(noise)
    , m_Constant(v[0])
    , m_X(v[1] - v[0])
    , m_Y(v[2] - v[0])
    , m_Z(v[4] - v[0])
    , m_XY(v[3] - v[2] - v[1] + v[0])
    , m_XZ(v[5] - v[4] - v[1] + v[0])
    , m_YZ(v[6] - v[4] - v[2] + v[0])
    , m_XYZ(v[7] - v[6] - v[5] - v[3] + v[4] + v[2] + v[1] - v[0])
  {}

  double
  Evaluate(const PointType & p) const
  {
    return this->EvaluateAtZero(p[1], p[2]) + p[0] * this->ComputeSlope(p[1], p[2]);
  }

  DelaunayRefinementRegion
  Classify(const PointType & p) const
  {
    return this->Evaluate(p) >= 0.0 ? 1 : 0;
  }

  bool
  MayIntersect(const PointType & corner, double size) const
  {
    // Within a cube a trilinear function stays between its values at the corners.
    bool hasInside = false;
    bool hasOutside = false;
    for (unsigned int i = 0; i < 8 && !(hasInside && hasOutside); ++i)
    {
      const double value =
        this->Evaluate({ corner[0] + (i & 1u) * size, corner[1] + (i >> 1 & 1u) * size, corner[2] + (i >> 2) * size });
      hasInside = hasInside || value >= -m_Noise;
      hasOutside = hasOutside || value < m_Noise;
    }
    return hasInside && hasOutside;
  }

  unsigned int
  FindOctants(const PointType & corner, double size) const
  {
    // Of the grid of 27 points: the least and the greatest value at the corners of each octant, axis by axis.
    const double half = 0.5 * size;
    double       least[18];
    double       greatest[18];
    for (unsigned int row = 0; row < 9; ++row)
    {
      const double y = corner[1] + row % 3 * half;
      const double z = corner[2] + row / 3 * half;
      const double slope = this->ComputeSlope(y, z);
      const double low = this->EvaluateAtZero(y, z) + corner[0] * slope;
      const double middle = low + half * slope;
      const double high = low + size * slope;
      least[2 * row] = std::min(low, middle);
      least[2 * row + 1] = std::min(middle, high);
      greatest[2 * row] = std::max(low, middle);
      greatest[2 * row + 1] = std::max(middle, high);
    }
    unsigned int octants = 0;
    for (unsigned int i = 0; i < 8; ++i)
    {
      const unsigned int at = (i & 1u) + 2 * (i >> 1 & 1u) + 6 * (i >> 2);
      const double       low = std::min(std::min(least[at], least[at + 2]), std::min(least[at + 6], least[at + 8]));
      const double       high =
        std::max(std::max(greatest[at], greatest[at + 2]), std::max(greatest[at + 6], greatest[at + 8]));
      octants |= (low < m_Noise && high >= -m_Noise ? 1u : 0u) << i;
    }
    return octants;
  }

  static unsigned int
  SamplesPerSide(double)
  {
    return 1;
  }

  bool
  FindFirstChange(const PointType & from, const PointType & to, DelaunayRefinementRegion region, double & share) const
  {
    // A cubic along the way, in Bernstein form: it stays between the least and the greatest of its coefficients.
    const PointType d{ to[0] - from[0], to[1] - from[1], to[2] - from[2] };
    const double    dxy = d[0] * d[1];
    const double    dxz = d[0] * d[2];
    const double    dyz = d[1] * d[2];
    const double    c0 = this->Evaluate(from);
    const double    c1 = d[0] * (m_X + from[1] * m_XY + from[2] * m_XZ + from[1] * from[2] * m_XYZ) +
                      d[1] * (m_Y + from[0] * m_XY + from[2] * m_YZ + from[0] * from[2] * m_XYZ) +
                      d[2] * (m_Z + from[0] * m_XZ + from[1] * m_YZ + from[0] * from[1] * m_XYZ);
    const double c2 = dxy * (m_XY + from[2] * m_XYZ) + dxz * (m_XZ + from[1] * m_XYZ) + dyz * (m_YZ + from[0] * m_XYZ);
    const double c3 = dxy * d[2] * m_XYZ;
    const double third = 1.0 / 3.0;
    return FindFirstChange(
      { c0, c0 + third * c1, c0 + 2.0 * third * c1 + third * c2, c0 + c1 + c2 + c3 }, region != 0, 0.0, 1.0, share);
  }

  bool
  FindChangeTowardsFaces(const PointType & start, const PointType & corner, double size, PointType & found) const
  {
    // Straight along an axis a trilinear function is linear.
    const double    x = start[0];
    const double    y = start[1];
    const double    z = start[2];
    const double    value = this->Evaluate(start);
    const PointType slopes{ this->ComputeSlope(y, z),
                            m_Y + x * (m_XY + z * m_XYZ) + z * m_YZ,
                            m_Z + x * (m_XZ + y * m_XYZ) + y * m_YZ };
    for (unsigned int face = 0; face < 6; ++face)
    {
      const unsigned int axis = face / 2;
      const double       way = corner[axis] + (face % 2) * size - start[axis];
      const double       end = value + way * slopes[axis];
      if ((end >= 0.0) != (value >= 0.0))
      {
        found = start;
        found[axis] += value / (value - end) * way;
        return true;
      }
    }
    return false;
  }

private:
  /** Along x: the value at x = 0. */
  double
  EvaluateAtZero(double y, double z) const
  {
    return m_Constant + y * (m_Y + z * m_YZ) + z * m_Z;
  }

  /** Along x: the derivative. */
  double
  ComputeSlope(double y, double z) const
  {
    return m_X + y * (m_XY + z * m_XYZ) + z * m_XZ;
  }

  static bool
  FindFirstChange(const std::array<double, 4> & b, bool isInside, double low, double high, double & share)
  {
    constexpr double narrowest = 1e-7;
    const auto       differs = [isInside](double value) { return (value >= 0.0) != isInside; };
    if (differs(b[0]))
    {
      share = low;
      return true;
    }
    const unsigned int change = (differs(b[1]) ? 1u : 0u) | (differs(b[2]) ? 2u : 0u) | (differs(b[3]) ? 4u : 0u);
    if (change == 0)
    {
      return false;
    }
    if (change == 4u || change == 6u || change == 7u)
    {
      // The coefficients change sign once, and so does the cubic.
      share = low + (high - low) * FindOnlyChange(b);
      return true;
    }
    if (high - low < narrowest)
    {
      share = high;
      return differs(b[3]);
    }
    const double ab = 0.5 * (b[0] + b[1]);
    const double bc = 0.5 * (b[1] + b[2]);
    const double cd = 0.5 * (b[2] + b[3]);
    const double abc = 0.5 * (ab + bc);
    const double bcd = 0.5 * (bc + cd);
    const double middle = 0.5 * (abc + bcd);
    const double half = 0.5 * (low + high);
    return FindFirstChange({ b[0], ab, abc, middle }, isInside, low, half, share) ||
           FindFirstChange({ middle, bcd, cd, b[3] }, isInside, half, high, share);
  }

  /** The root of a cubic with ends of different signs, by regula falsi in the Illinois way. */
  static double
  FindOnlyChange(const std::array<double, 4> & b)
  {
    constexpr double       precision = 1e-9;
    constexpr unsigned int mostSteps = 60;
    double                 low = 0.0;
    double                 high = 1.0;
    double                 valueLow = b[0];
    double                 valueHigh = b[3];
    for (unsigned int step = 0; step < mostSteps && high - low > precision; ++step)
    {
      const double s = (low * valueHigh - high * valueLow) / (valueHigh - valueLow);
      const double t = 1.0 - s;
      const double value = t * t * (t * b[0] + 3.0 * s * b[1]) + s * s * (3.0 * t * b[2] + s * b[3]);
      if (std::abs(value) < precision * std::abs(b[3] - b[0]))
      {
        return s;
      }
      if ((value >= 0.0) == (b[0] >= 0.0))
      {
        low = s;
        valueLow = value;
        valueHigh *= 0.5;
      }
      else
      {
        high = s;
        valueHigh = value;
        valueLow *= 0.5;
      }
    }
    return high;
  }

  double m_Noise;
  double m_Constant;
  double m_X;
  double m_Y;
  double m_Z;
  double m_XY;
  double m_XZ;
  double m_YZ;
  double m_XYZ;
};

/** \class DelaunayRefinementNearestCell
 * \brief The region is that of the nearest corner; halfway counts for the upper one.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementNearestCell
{
public:
  using PointType = DelaunayRefinementPoint;

  /** The corners' regions, x fastest. */
  explicit DelaunayRefinementNearestCell(const std::array<DelaunayRefinementRegion, 8> & regions)
    : m_Regions(regions)
  {}

  DelaunayRefinementRegion
  Classify(const PointType & p) const
  {
    return m_Regions[(p[0] >= 0.5 ? 1u : 0u) | (p[1] >= 0.5 ? 2u : 0u) | (p[2] >= 0.5 ? 4u : 0u)];
  }

  bool
  MayIntersect(const PointType & corner, double size) const
  {
    return HasDifferentCorners(*this, corner, size);
  }

  unsigned int
  FindOctants(const PointType & corner, double size) const
  {
    return FindOctantsOneByOne(*this, corner, size);
  }

  static unsigned int
  SamplesPerSide(double)
  {
    return 1;
  }

  bool
  FindFirstChange(const PointType & from, const PointType & to, DelaunayRefinementRegion region, double & share) const
  {
    // The region can only change where a coordinate passes one half.
    std::array<double, 5> stops{ 0.0, 1.0, 1.0, 1.0, 1.0 };
    for (unsigned int i = 0; i < 3; ++i)
    {
      if ((from[i] < 0.5) != (to[i] < 0.5))
      {
        stops[i + 1] = std::clamp((0.5 - from[i]) / (to[i] - from[i]), 0.0, 1.0);
      }
    }
    std::sort(stops.begin(), stops.end());
    for (unsigned int i = 0; i + 1 < stops.size(); ++i)
    {
      const double s = 0.5 * (stops[i] + stops[i + 1]);
      if (stops[i] < stops[i + 1] && this->Classify({ from[0] + s * (to[0] - from[0]),
                                                      from[1] + s * (to[1] - from[1]),
                                                      from[2] + s * (to[2] - from[2]) }) != region)
      {
        share = stops[i];
        return true;
      }
    }
    share = 1.0;
    return this->Classify(to) != region;
  }

  bool
  FindChangeTowardsFaces(const PointType & start, const PointType & corner, double size, PointType & found) const
  {
    return FindChangeTowardsFacesOneByOne(*this, start, corner, size, found);
  }

private:
  std::array<DelaunayRefinementRegion, 8> m_Regions;
};

/** \class DelaunayRefinementFieldCell
 * \brief Inside is what a function says, which is asked on a grid of quarters of the cell: finer detail is missed.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TFunction>
class DelaunayRefinementFieldCell
{
public:
  using PointType = DelaunayRefinementPoint;

  explicit DelaunayRefinementFieldCell(const TFunction & isInside)
    : m_IsInside(isInside)
  {}

  DelaunayRefinementRegion
  Classify(const PointType & p) const
  {
    return m_IsInside(p) ? 1 : 0;
  }

  bool
  MayIntersect(const PointType & corner, double size) const
  {
    const unsigned int samples = SamplesPerSide(size);
    const double       step = size / samples;
    const bool         first = m_IsInside(corner);
    for (unsigned int z = 0; z <= samples; ++z)
    {
      for (unsigned int y = 0; y <= samples; ++y)
      {
        for (unsigned int x = 0; x <= samples; ++x)
        {
          if (m_IsInside({ corner[0] + x * step, corner[1] + y * step, corner[2] + z * step }) != first)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  unsigned int
  FindOctants(const PointType & corner, double size) const
  {
    return FindOctantsOneByOne(*this, corner, size);
  }

  static unsigned int
  SamplesPerSide(double size)
  {
    return size > 0.25 ? static_cast<unsigned int>(std::ceil(4.0 * size)) : 1;
  }

  bool
  FindFirstChange(const PointType & from, const PointType & to, DelaunayRefinementRegion region, double & share) const
  {
    const auto at = [&](double s) {
      return m_IsInside(
        { from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]), from[2] + s * (to[2] - from[2]) });
    };
    const bool   isInside = region != 0;
    const double length = std::max({ std::abs(to[0] - from[0]), std::abs(to[1] - from[1]), std::abs(to[2] - from[2]) });
    const unsigned int steps = 2 * SamplesPerSide(length);
    for (unsigned int i = 0; i <= steps; ++i)
    {
      double high = static_cast<double>(i) / steps;
      if (at(high) != isInside)
      {
        double low = i == 0 ? 0.0 : static_cast<double>(i - 1) / steps;
        for (unsigned int halving = 0; halving < 20 && i > 0; ++halving)
        {
          const double middle = 0.5 * (low + high);
          (at(middle) != isInside ? high : low) = middle;
        }
        share = high;
        return true;
      }
    }
    return false;
  }

  bool
  FindChangeTowardsFaces(const PointType & start, const PointType & corner, double size, PointType & found) const
  {
    return FindChangeTowardsFacesOneByOne(*this, start, corner, size, found);
  }

private:
  const TFunction & m_IsInside;
};

/** A point of the surface in a cube of a cell: on the way from \c start, a point of the cube, to the first point in
 * another region, of those across on its faces and then of a grid. False if there is none. */
template <typename TCell>
bool
FindSurfacePointInCube(const TCell &                   cell,
                       const DelaunayRefinementPoint & corner,
                       double                          size,
                       const DelaunayRefinementPoint & start,
                       DelaunayRefinementPoint &       found)
{
  // Surface that lies in a face is met at its corners alone otherwise, where points tend to be on common spheres.
  if (cell.FindChangeTowardsFaces(start, corner, size, found))
  {
    return true;
  }
  const unsigned int samples = TCell::SamplesPerSide(size);
  const double       step = size / samples;
  for (unsigned int z = 0; z <= samples; ++z)
  {
    for (unsigned int y = 0; y <= samples; ++y)
    {
      for (unsigned int x = 0; x <= samples; ++x)
      {
        if (FindChangeTowards(cell, start, { corner[0] + x * step, corner[1] + y * step, corner[2] + z * step }, found))
        {
          return true;
        }
      }
    }
  }
  return false;
}
} // end namespace itk

#endif
