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
#ifndef itkDelaunayRefinementPredicates_h
#define itkDelaunayRefinementPredicates_h

#include "itkDelaunayRefinementTypes.h"

#include <algorithm>
#include <cmath>

namespace itk
{
/** \class DelaunayRefinementPredicates
 * \brief On which side a point is: signs that are always right, by filters before exact arithmetic.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPredicates
{
public:
  using PointType = DelaunayRefinementPoint;

  /** The sign of det(b - a, c - a, d - a): positive in VTK's order, 0 if the points are coplanar. */
  static int
  Orientation(const PointType & a, const PointType & b, const PointType & c, const PointType & d)
  {
    const double ux = b[0] - a[0];
    const double uy = b[1] - a[1];
    const double uz = b[2] - a[2];
    const double vx = c[0] - a[0];
    const double vy = c[1] - a[1];
    const double vz = c[2] - a[2];
    const double wx = d[0] - a[0];
    const double wy = d[1] - a[1];
    const double wz = d[2] - a[2];
    const double determinant = ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
    // Six products of three, with some eight roundings each.
    constexpr double share = 1e-14;
    const double     bound = share * std::max({ std::abs(ux), std::abs(vx), std::abs(wx) }) *
                         std::max({ std::abs(uy), std::abs(vy), std::abs(wy) }) *
                         std::max({ std::abs(uz), std::abs(vz), std::abs(wz) });
    if (std::abs(determinant) > bound && bound > SmallestBound)
    {
      return determinant > 0.0 ? 1 : -1;
    }
    return ExactOrientation(a, b, c, d);
  }

  /** 1 if \c p is inside the circumsphere of a tetrahedron in VTK's order, -1 if outside, 0 if on it. */
  static int
  ExactSideOfSphere(const PointType & a,
                    const PointType & b,
                    const PointType & c,
                    const PointType & d,
                    const PointType & p);

private:
  /** Below it products may have lost digits by underflow. */
  static constexpr double SmallestBound = 1e-290;

  static int
  ExactOrientation(const PointType & a, const PointType & b, const PointType & c, const PointType & d);
};
} // end namespace itk

#endif
