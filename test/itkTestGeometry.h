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
#ifndef itkTestGeometry_h
#define itkTestGeometry_h

#include "itkDelaunayRefinementTypes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace itk::DelaunayRefinementTest
{
using PointType = DelaunayRefinementPoint;

/** Vector of higher precision, for figures that are compared with a bound. */
using LongVectorType = std::array<long double, 3>;

constexpr double Pi = 3.14159265358979323846;

template <typename T>
inline std::array<T, 3>
Add(const std::array<T, 3> & a, const std::array<T, 3> & b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

template <typename T>
inline std::array<T, 3>
Subtract(const std::array<T, 3> & a, const std::array<T, 3> & b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

template <typename T>
inline std::array<T, 3>
Scale(const std::array<T, 3> & a, T factor)
{
  return { a[0] * factor, a[1] * factor, a[2] * factor };
}

template <typename T>
inline T
Dot(const std::array<T, 3> & a, const std::array<T, 3> & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename T>
inline std::array<T, 3>
Cross(const std::array<T, 3> & a, const std::array<T, 3> & b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <typename T>
inline T
Norm(const std::array<T, 3> & a)
{
  return std::sqrt(Dot(a, a));
}

inline double
Distance(const PointType & a, const PointType & b)
{
  return Norm(Subtract(a, b));
}

/** b - a. */
inline LongVectorType
LongDifference(const PointType & a, const PointType & b)
{
  return { static_cast<long double>(b[0]) - a[0],
           static_cast<long double>(b[1]) - a[1],
           static_cast<long double>(b[2]) - a[2] };
}

/** The angle between two vectors, in degrees; precise for small angles, too. */
inline double
ComputeAngle(const LongVectorType & a, const LongVectorType & b)
{
  return static_cast<double>(std::atan2(Norm(Cross(a, b)), Dot(a, b)) * 180.0L / Pi);
}

/** To single precision and back. Volatile, as GCC 12 leaves out pairs of such conversions when it vectorizes. */
inline double
RoundToFloat(double value)
{
  const volatile float rounded = static_cast<float>(value);
  return rounded;
}

inline PointType
RoundToFloat(const PointType & point)
{
  return { RoundToFloat(point[0]), RoundToFloat(point[1]), RoundToFloat(point[2]) };
}

/** \class ExactSum
 * \brief A sum of doubles without rounding errors: nonoverlapping terms of growing size.
 *
 * \par References
 * J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete &
 * Computational Geometry 18, 1997, section 2.
 */
class ExactSum
{
public:
  void
  Add(double value)
  {
    for (double & term : m_Terms)
    {
      const double sum = value + term;
      const double virtualTerm = sum - value;
      term = (value - (sum - virtualTerm)) + (term - virtualTerm);
      value = sum;
    }
    m_Terms.push_back(value);
  }

  void
  AddProduct(double a, double b, double c)
  {
    const double product = a * b;
    const double error = std::fma(a, b, -product);
    for (const double factor : { product, error })
    {
      const double high = factor * c;
      this->Add(std::fma(factor, c, -high));
      this->Add(high);
    }
  }

  int
  GetSign() const
  {
    for (auto it = m_Terms.rbegin(); it != m_Terms.rend(); ++it)
    {
      if (*it != 0.0)
      {
        return *it > 0.0 ? 1 : -1;
      }
    }
    return 0;
  }

private:
  std::vector<double> m_Terms{};
};

/** The exact sign of det(p1 - p0, p2 - p0, p3 - p0): 1 for a positively oriented tetrahedron. */
inline int
ComputeOrientation(const PointType & p0, const PointType & p1, const PointType & p2, const PointType & p3)
{
  const LongVectorType a = LongDifference(p0, p1);
  const LongVectorType b = LongDifference(p0, p2);
  const LongVectorType c = LongDifference(p0, p3);
  const long double    determinant = Dot(a, Cross(b, c));
  const long double    errorBound = 32 * std::numeric_limits<long double>::epsilon() * Norm(a) * Norm(b) * Norm(c);
  if (std::abs(determinant) > errorBound)
  {
    return determinant > 0 ? 1 : -1;
  }

  ExactSum   sum;
  const auto addDeterminant = [&sum](double sign, const PointType & u, const PointType & v, const PointType & w) {
    for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3;
      const unsigned int k = (i + 2) % 3;
      sum.AddProduct(sign * u[i], v[j], w[k]);
      sum.AddProduct(-sign * u[i], v[k], w[j]);
    }
  };
  addDeterminant(1.0, p1, p2, p3);
  addDeterminant(-1.0, p0, p2, p3);
  addDeterminant(1.0, p0, p1, p3);
  addDeterminant(-1.0, p0, p1, p2);
  return sum.GetSign();
}

inline double
ComputeTetrahedronVolume(const PointType & p0, const PointType & p1, const PointType & p2, const PointType & p3)
{
  return static_cast<double>(Dot(LongDifference(p0, p1), Cross(LongDifference(p0, p2), LongDifference(p0, p3))) / 6.0L);
}

/** \class Circumsphere
 * \brief Center relative to the tetrahedron's first vertex, and radius.
 */
struct Circumsphere
{
  LongVectorType center;
  long double    radius;
};

/** Infinite for a flat tetrahedron. */
inline Circumsphere
ComputeCircumsphere(const PointType & p0, const PointType & p1, const PointType & p2, const PointType & p3)
{
  const LongVectorType a = LongDifference(p0, p1);
  const LongVectorType b = LongDifference(p0, p2);
  const LongVectorType c = LongDifference(p0, p3);
  const long double    determinant = Dot(a, Cross(b, c));
  if (determinant == 0)
  {
    constexpr long double infinity = std::numeric_limits<long double>::infinity();
    return { { infinity, infinity, infinity }, infinity };
  }
  const LongVectorType sum =
    Add(Add(Scale(Cross(b, c), Dot(a, a)), Scale(Cross(c, a), Dot(b, b))), Scale(Cross(a, b), Dot(c, c)));
  const LongVectorType center = Scale(sum, 1 / (2 * determinant));
  return { center, Norm(center) };
}

/** The point of a triangle that is closest to p. */
inline PointType
ComputeClosestPointOfTriangle(const PointType & p, const PointType & a, const PointType & b, const PointType & c)
{
  const PointType ab = Subtract(b, a);
  const PointType ac = Subtract(c, a);
  const PointType normal = Cross(ab, ac);
  const double    squaredArea = Dot(normal, normal);
  if (squaredArea > 0.0)
  {
    const PointType ap = Subtract(p, a);
    const double    u = Dot(Cross(ap, ac), normal) / squaredArea;
    const double    v = Dot(Cross(ab, ap), normal) / squaredArea;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0)
    {
      return Add(a, Add(Scale(ab, u), Scale(ac, v)));
    }
  }
  // The projection is outside: an edge is closest.
  PointType closest = a;
  for (const auto & [from, to] : { std::make_pair(a, b), std::make_pair(b, c), std::make_pair(c, a) })
  {
    const PointType edge = Subtract(to, from);
    const double    squaredLength = Dot(edge, edge);
    const double    t = squaredLength > 0.0 ? Dot(Subtract(p, from), edge) / squaredLength : 0.0;
    const PointType candidate = Add(from, Scale(edge, std::min(1.0, std::max(0.0, t))));
    if (Distance(p, candidate) < Distance(p, closest))
    {
      closest = candidate;
    }
  }
  return closest;
}
} // end namespace itk::DelaunayRefinementTest

#endif
