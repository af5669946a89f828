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
#ifndef itkDelaunayRefinementDihedralAngles_h
#define itkDelaunayRefinementDihedralAngles_h

#include "itkDelaunayRefinementGeometry.h"

namespace itk
{
/** \class DelaunayRefinementDihedralAngles
 * \brief How far the dihedral angles of a tetrahedron are below a bound.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementDihedralAngles
{
public:
  using PointType = DelaunayRefinementPoint;

  /** The bound, in degrees; 0 if there is none. A little is added to it, so that another formula for the same angle
   * agrees. */
  explicit DelaunayRefinementDihedralAngles(double bound)
    : m_Bound((bound + Margin) * DelaunayRefinementGeometry::RadiansPerDegree)
    , m_SquaredCosine(bound > 0.0 ? std::cos(m_Bound) * std::cos(m_Bound) : std::numeric_limits<double>::infinity())
  {}

  bool
  IsBounded() const
  {
    return std::isfinite(m_SquaredCosine);
  }

  /** 0 if no angle is below the bound. Each that is adds from 0.1, at the bound, to 1.1, at 0 degrees. */
  double
  ComputeBadness(const PointType & a, const PointType & b, const PointType & c, const PointType & d) const
  {
    // The dihedral angle at an edge is pi minus the angle between the outward normals of its two faces.
    using Geometry = DelaunayRefinementGeometry;
    const PointType                u = Geometry::Subtract(b, a);
    const PointType                v = Geometry::Subtract(c, a);
    const PointType                w = Geometry::Subtract(d, a);
    const std::array<PointType, 3> normals{ Geometry::Cross(v, w), Geometry::Cross(w, u), Geometry::Cross(u, v) };
    const PointType                last{ -normals[0][0] - normals[1][0] - normals[2][0],
                          -normals[0][1] - normals[1][1] - normals[2][1],
                          -normals[0][2] - normals[1][2] - normals[2][2] };
    const std::array<double, 4>    squares{ Geometry::Dot(normals[0], normals[0]),
                                         Geometry::Dot(normals[1], normals[1]),
                                         Geometry::Dot(normals[2], normals[2]),
                                         Geometry::Dot(last, last) };
    return this->ComputeBadness(-Geometry::Dot(normals[0], normals[1]), squares[0] * squares[1]) +
           this->ComputeBadness(-Geometry::Dot(normals[0], normals[2]), squares[0] * squares[2]) +
           this->ComputeBadness(-Geometry::Dot(normals[1], normals[2]), squares[1] * squares[2]) +
           this->ComputeBadness(-Geometry::Dot(normals[0], last), squares[0] * squares[3]) +
           this->ComputeBadness(-Geometry::Dot(normals[1], last), squares[1] * squares[3]) +
           this->ComputeBadness(-Geometry::Dot(normals[2], last), squares[2] * squares[3]);
  }

private:
  static constexpr double Margin = 0.01;
  static constexpr double LeastBadness = 0.1;

  /** Of an angle, by its cosine times the root of a square. */
  double
  ComputeBadness(double product, double square) const
  {
    if (!(product > 0.0 && product * product > m_SquaredCosine * square))
    {
      return 0.0;
    }
    const double angle = std::acos(std::min(1.0, product / std::sqrt(square)));
    const double lack = (m_Bound - angle) / m_Bound;
    return LeastBadness + lack * lack;
  }

  double m_Bound;
  double m_SquaredCosine;
};
} // end namespace itk

#endif
