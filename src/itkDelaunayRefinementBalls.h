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
#ifndef itkDelaunayRefinementBalls_h
#define itkDelaunayRefinementBalls_h

#include "itkDelaunayRefinementTypes.h"
#include "itkDelaunayRefinementWideLoops.h"

#include <algorithm>
#include <cmath>

namespace itk
{
/** \class DelaunayRefinementBalls
 * \brief The balls through the origin and three points u, v, w each, of several cells at once: one array for each
 * number, so that compilers do them together.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementBalls
{
public:
  using PointType = DelaunayRefinementPoint;

  static constexpr std::size_t Size = 4;
  using NumbersType = std::array<double, Size>;

  DelaunayRefinementBalls()
  {
    for (std::size_t i = 0; i < Size; ++i)
    {
      this->SetAny(i);
    }
  }

  /** Something to compute with where there is no cell. */
  void
  SetAny(std::size_t i)
  {
    this->SetPoints(i, {}, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 });
  }

  void
  SetPoints(std::size_t i, const PointType & origin, const PointType & a, const PointType & b, const PointType & c)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      m_U[j][i] = a[j] - origin[j];
      m_V[j][i] = b[j] - origin[j];
      m_W[j][i] = c[j] - origin[j];
    }
  }

  ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
  void
  Compute(const PointType & origin)
  {
    const double far = SmallestDeciding * std::max({ std::abs(origin[0]), std::abs(origin[1]), std::abs(origin[2]) });
    const double squaredFar = far * far;
    for (std::size_t i = 0; i < Size; ++i)
    {
      const double ux = m_U[0][i];
      const double uy = m_U[1][i];
      const double uz = m_U[2][i];
      const double vx = m_V[0][i];
      const double vy = m_V[1][i];
      const double vz = m_V[2][i];
      const double wx = m_W[0][i];
      const double wy = m_W[1][i];
      const double wz = m_W[2][i];
      const double vwX = vy * wz - vz * wy;
      const double vwY = vz * wx - vx * wz;
      const double vwZ = vx * wy - vy * wx;
      const double uu = ux * ux + uy * uy + uz * uz;
      const double vv = vx * vx + vy * vy + vz * vz;
      const double ww = wx * wx + wy * wy + wz * wz;
      const double determinant = ux * vwX + uy * vwY + uz * vwZ;
      const double factor = 0.5 / determinant;
      const double x = factor * (uu * vwX + vv * (wy * uz - wz * uy) + ww * (uy * vz - uz * vy));
      const double y = factor * (uu * vwY + vv * (wz * ux - wx * uz) + ww * (uz * vx - ux * vz));
      const double z = factor * (uu * vwZ + vv * (wx * uy - wy * ux) + ww * (ux * vy - uy * vx));
      const double greater = uu > vv ? uu : vv;
      const double greatest = greater > ww ? greater : ww;
      const double flattest = FlattestDeciding * FlattestDeciding * greatest * greatest * greatest;
      const double squaredRadius = x * x + y * y + z * z;
      const double deciding = greatest > squaredFar ? squaredRadius : -squaredRadius;
      m_Center[0][i] = x;
      m_Center[1][i] = y;
      m_Center[2][i] = z;
      m_SignedSquaredRadius[i] = determinant * determinant > flattest ? deciding : -squaredRadius;
    }
  }

  PointType
  GetCenter(std::size_t i, const PointType & origin) const
  {
    return { origin[0] + m_Center[0][i], origin[1] + m_Center[1][i], origin[2] + m_Center[2][i] };
  }

  /** Negative if the ball is not known well enough to decide with. */
  double
  GetSignedSquaredRadius(std::size_t i) const
  {
    return m_SignedSquaredRadius[i];
  }

private:
  /** Of finite cells that are flatter, or further from the origin for their size, the circumball decides nothing. Its
   * center is known to some 30 roundings times (longest edge)^3 / determinant of the radius, which leaves
   * the triangulation's DecidingShare a margin of ten. */
  static constexpr double FlattestDeciding = 1e-6;
  static constexpr double SmallestDeciding = 1e-7;

  std::array<NumbersType, 3> m_U;
  std::array<NumbersType, 3> m_V;
  std::array<NumbersType, 3> m_W;
  std::array<NumbersType, 3> m_Center;
  NumbersType                m_SignedSquaredRadius;
};
} // end namespace itk

#endif
