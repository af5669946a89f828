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
#ifndef itkDelaunayRefinementGeometry_h
#define itkDelaunayRefinementGeometry_h

#include "itkDelaunayRefinementTypes.h"

#include <algorithm>
#include <cmath>

namespace itk
{
/** \class DelaunayRefinementGeometry
 * \brief Measures of points, triangles and tetrahedra. No state.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementGeometry
{
public:
  using PointType = DelaunayRefinementPoint;

  static constexpr double RadiansPerDegree = 0.017453292519943295;

  static PointType
  Subtract(const PointType & a, const PointType & b)
  {
    return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  }

  /** a + factor * b. */
  static PointType
  AddScaled(const PointType & a, double factor, const PointType & b)
  {
    return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
  }

  static double
  Dot(const PointType & a, const PointType & b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static PointType
  Cross(const PointType & a, const PointType & b)
  {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }

  /** The vectors whose products with three others are 1 for their own and 0 for the rest. */
  static std::array<PointType, 3>
  Invert(const std::array<PointType, 3> & vectors)
  {
    std::array<PointType, 3> inverse{ Cross(vectors[1], vectors[2]),
                                      Cross(vectors[2], vectors[0]),
                                      Cross(vectors[0], vectors[1]) };
    const double             determinant = Dot(vectors[0], inverse[0]);
    for (PointType & vector : inverse)
    {
      vector = { vector[0] / determinant, vector[1] / determinant, vector[2] / determinant };
    }
    return inverse;
  }

  static double
  SquaredDistance(const PointType & a, const PointType & b)
  {
    const PointType d = Subtract(a, b);
    return Dot(d, d);
  }

  static double
  Distance(const PointType & a, const PointType & b)
  {
    return std::sqrt(SquaredDistance(a, b));
  }

  /** The nearest number of single precision. */
  static double
  RoundToFloat(double number)
  {
    // GCC 12 drops the rounding where it vectorizes, unless the float is stored.
    volatile float rounded = static_cast<float>(number);
    return rounded;
  }

  /** The same for each coordinate. */
  static PointType
  RoundPointToFloat(const PointType & point)
  {
    return { RoundToFloat(point[0]), RoundToFloat(point[1]), RoundToFloat(point[2]) };
  }

  /** Six times the signed volume: positive in VTK's order. */
  static double
  Determinant(const PointType & a, const PointType & b, const PointType & c, const PointType & d)
  {
    return Dot(Subtract(b, a), Cross(Subtract(c, a), Subtract(d, a)));
  }

  /** A sphere by center and squared radius. */
  struct SphereType
  {
    PointType center;
    double    squaredRadius;
  };

  /** A circumsphere in floating point, and what tells how far to trust it. */
  struct RoundedSphereType
  {
    SphereType ball;
    /** Six times the volume, and the square of the longest of the three edges at the first point. */
    double determinant;
    double greatestSquare;
  };

  static RoundedSphereType
  ComputeRoundedCircumsphere(const PointType & a, const PointType & b, const PointType & c, const PointType & d)
  {
    const PointType u = Subtract(b, a);
    const PointType v = Subtract(c, a);
    const PointType w = Subtract(d, a);
    const PointType vw = Cross(v, w);
    const PointType wu = Cross(w, u);
    const PointType uv = Cross(u, v);
    const double    determinant = Dot(u, vw);
    const double    uu = Dot(u, u);
    const double    vv = Dot(v, v);
    const double    ww = Dot(w, w);
    const double    factor = 0.5 / determinant;
    const PointType offset{ factor * (uu * vw[0] + vv * wu[0] + ww * uv[0]),
                            factor * (uu * vw[1] + vv * wu[1] + ww * uv[1]),
                            factor * (uu * vw[2] + vv * wu[2] + ww * uv[2]) };
    return { { AddScaled(a, 1.0, offset), Dot(offset, offset) }, determinant, std::max({ uu, vv, ww }) };
  }

  /** The sphere through four points that are not coplanar; exact before rounding where the points are nearly so. */
  static SphereType
  ComputeCircumsphere(const PointType & a, const PointType & b, const PointType & c, const PointType & d);

  /** The smallest sphere through three points that are not collinear. */
  static SphereType
  ComputeCircumsphere(const PointType & a, const PointType & b, const PointType & c);

  /** Squared length of the shortest of the six edges. */
  static double
  ComputeSquaredShortestEdge(const PointType & a, const PointType & b, const PointType & c, const PointType & d);

  /** Squared length of the longest of the six edges. */
  static double
  ComputeSquaredLongestEdge(const PointType & a, const PointType & b, const PointType & c, const PointType & d);

  /** Cosine of the smallest of the six dihedral angles. */
  static double
  ComputeLargestDihedralCosine(const PointType & a, const PointType & b, const PointType & c, const PointType & d);

  /** Cosine of the smallest of the three angles of a triangle. */
  static double
  ComputeLargestCosine(const PointType & a, const PointType & b, const PointType & c);

private:
  static SphereType
  ComputeExactCircumsphere(const PointType & a, const PointType & b, const PointType & c, const PointType & d);
};
} // end namespace itk

#endif
