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
#ifndef itkAnalyticOracle_h
#define itkAnalyticOracle_h

#include "itkDelaunayRefinementOracle.h"
#include "itkTestGeometry.h"

namespace itk::DelaunayRefinementTest
{
/** The polynomial sum of c[i] t^i. */
using PolynomialType = std::vector<double>;

inline double
EvaluatePolynomial(const PolynomialType & polynomial, double t)
{
  double value = 0.0;
  for (auto it = polynomial.rbegin(); it != polynomial.rend(); ++it)
  {
    value = value * t + *it;
  }
  return value;
}

/** The roots in [0, 1] with a change of sign, in growing order: between two roots of the derivative is at most one. */
inline std::vector<double>
FindRoots(const PolynomialType & polynomial)
{
  if (polynomial.size() < 2)
  {
    return {};
  }
  PolynomialType derivative;
  for (std::size_t i = 1; i < polynomial.size(); ++i)
  {
    derivative.push_back(static_cast<double>(i) * polynomial[i]);
  }
  std::vector<double> ends = FindRoots(derivative);
  ends.insert(ends.begin(), 0.0);
  ends.push_back(1.0);

  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    double     low = ends[i];
    double     high = ends[i + 1];
    const bool isPositiveAtLow = EvaluatePolynomial(polynomial, low) > 0.0;
    if (isPositiveAtLow == (EvaluatePolynomial(polynomial, high) > 0.0))
    {
      continue;
    }
    for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
    {
      ((EvaluatePolynomial(polynomial, middle) > 0.0) == isPositiveAtLow ? low : high) = middle;
    }
    roots.push_back(high);
  }
  return roots;
}

/** \class AnalyticOracle
 * \brief An object with a closed form, one component and one region unless a subclass says otherwise.
 *
 * The patches are the boxes of an octree over a cube around the object that the surface may pass.
 */
class AnalyticOracle : public DelaunayRefinementOracle
{
public:
  RegionType
  Classify(const PointType & point) const override
  {
    return this->ComputeSignedDistance(point) <= 0.0 ? 1 : 0;
  }

  bool
  FindClosestSurfacePoint(const PointType & point, double maximumDistance, PointType & closest) const override
  {
    closest = this->ComputeClosestPoint(point);
    return Distance(point, closest) <= maximumDistance;
  }

  bool
  MayIntersectBox(const BoundsType & box) const override
  {
    const PointType center = Scale(Add(box.minimum, box.maximum), 0.5);
    return std::abs(this->ComputeSignedDistance(center)) <= (1.0 + 1e-12) * Distance(center, box.maximum);
  }

  BoundsType
  GetSurfaceBounds() const override
  {
    const PointType offset{ m_HalfWidth, m_HalfWidth, m_HalfWidth };
    return { Subtract(m_Center, offset), Add(m_Center, offset) };
  }

  SurfacePatches
  GetSurfacePatches() const override
  {
    constexpr std::int32_t size = 1 << InitialLevel;
    SurfacePatches         patches(m_Center);
    for (std::int32_t z = 0; z < size; ++z)
    {
      for (std::int32_t y = 0; y < size; ++y)
      {
        for (std::int32_t x = 0; x < size; ++x)
        {
          this->AppendPatch({ x, y, z }, InitialLevel, patches);
        }
      }
    }
    return patches;
  }

  void
  SplitSurfacePatch(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const override
  {
    for (std::int32_t child = 0; child < 8; ++child)
    {
      this->AppendPatch({ 2 * patch.index[0] + (child & 1),
                          2 * patch.index[1] + ((child >> 1) & 1),
                          2 * patch.index[2] + (child >> 2) },
                        patch.level + 1,
                        parts);
    }
  }

  bool
  FindPointOfPatch(const SurfacePatchIdentifier & patch, PointType & point) const override
  {
    point = this->ComputeClosestPoint(this->GetBoxCenter(patch));
    return true;
  }

  ComponentType
  GetNumberOfComponents() const override
  {
    return 1;
  }

  ComponentType
  FindComponent(const PointType &) const override
  {
    return 0;
  }

  /** Negative inside; its amount is the distance to the surface. */
  virtual double
  ComputeSignedDistance(const PointType & point) const = 0;

  virtual double
  ComputeVolume() const = 0;

protected:
  /** The object lies within a cube. */
  AnalyticOracle(const PointType & center, double halfWidth)
    : m_Center(center)
    , m_HalfWidth(halfWidth)
  {}

  virtual PointType
  ComputeClosestPoint(const PointType & point) const = 0;

  /** The first root in [0, 1] of any of the polynomials along the segment from \c from to \c to. */
  static bool
  FindFirstRoot(const std::vector<PolynomialType> & polynomials,
                const PointType &                   from,
                const PointType &                   to,
                PointType &                         crossing)
  {
    double first = 2.0;
    for (const PolynomialType & polynomial : polynomials)
    {
      for (const double root : FindRoots(polynomial))
      {
        first = std::min(first, root);
      }
    }
    crossing = Add(from, Scale(Subtract(to, from), first));
    return first <= 1.0;
  }

  /** Of a sphere, along the segment. */
  static PolynomialType
  MakeSpherePolynomial(const PointType & center, double radius, const PointType & from, const PointType & to)
  {
    const PointType offset = Subtract(from, center);
    const PointType direction = Subtract(to, from);
    return { Dot(offset, offset) - radius * radius, 2.0 * Dot(offset, direction), Dot(direction, direction) };
  }

  /** The point at a distance from center in the direction of point. */
  static PointType
  ProjectOntoSphere(const PointType & point, const PointType & center, double radius)
  {
    const PointType offset = Subtract(point, center);
    const double    norm = Norm(offset);
    return norm > 0.0 ? Add(center, Scale(offset, radius / norm)) : Add(center, PointType{ radius, 0.0, 0.0 });
  }

  PointType m_Center;

private:
  static constexpr std::uint8_t InitialLevel = 4;

  PointType
  GetBoxCenter(const SurfacePatchIdentifier & patch) const
  {
    const double halfWidth = std::ldexp(m_HalfWidth, -patch.level);
    PointType    boxCenter;
    for (unsigned int i = 0; i < 3; ++i)
    {
      boxCenter[i] = m_Center[i] - m_HalfWidth + (2 * patch.index[i] + 1) * halfWidth;
    }
    return boxCenter;
  }

  void
  AppendPatch(const std::array<std::int32_t, 3> & index, std::uint8_t level, SurfacePatches & patches) const
  {
    const SurfacePatchIdentifier identifier{ index, level };
    const PointType              boxCenter = this->GetBoxCenter(identifier);
    const double                 halfWidth = std::ldexp(m_HalfWidth, -level);
    const PointType              corner{ halfWidth, halfWidth, halfWidth };
    if (!this->MayIntersectBox({ Subtract(boxCenter, corner), Add(boxCenter, corner) }))
    {
      return;
    }
    patches.Add(boxCenter, corner, Norm(corner), identifier);
  }

  double m_HalfWidth;
};
} // end namespace itk::DelaunayRefinementTest

#endif
