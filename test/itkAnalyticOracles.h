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
#ifndef itkAnalyticOracles_h
#define itkAnalyticOracles_h

#include "itkAnalyticOracle.h"

namespace itk::DelaunayRefinementTest
{
/** \class BallOracle
 * \brief A ball.
 */
class BallOracle : public AnalyticOracle
{
public:
  BallOracle(const PointType & center, double radius)
    : AnalyticOracle(center, 1.01 * radius)
    , m_Radius(radius)
  {}

  bool
  FindFirstCrossing(const PointType & from, const PointType & to, PointType & crossing) const override
  {
    return FindFirstRoot({ MakeSpherePolynomial(m_Center, m_Radius, from, to) }, from, to, crossing);
  }

  double
  ComputeSignedDistance(const PointType & point) const override
  {
    return Distance(point, m_Center) - m_Radius;
  }

  double
  ComputeVolume() const override
  {
    return 4.0 / 3.0 * Pi * m_Radius * m_Radius * m_Radius;
  }

protected:
  PointType
  ComputeClosestPoint(const PointType & point) const override
  {
    return ProjectOntoSphere(point, m_Center, m_Radius);
  }

private:
  double m_Radius;
};

/** \class HollowBallOracle
 * \brief A ball with a concentric cavity.
 */
class HollowBallOracle : public AnalyticOracle
{
public:
  HollowBallOracle(const PointType & center, double innerRadius, double outerRadius)
    : AnalyticOracle(center, 1.01 * outerRadius)
    , m_InnerRadius(innerRadius)
    , m_OuterRadius(outerRadius)
  {}

  bool
  FindFirstCrossing(const PointType & from, const PointType & to, PointType & crossing) const override
  {
    return FindFirstRoot({ MakeSpherePolynomial(m_Center, m_InnerRadius, from, to),
                           MakeSpherePolynomial(m_Center, m_OuterRadius, from, to) },
                         from,
                         to,
                         crossing);
  }

  double
  ComputeSignedDistance(const PointType & point) const override
  {
    const double distance = Distance(point, m_Center);
    return std::max(m_InnerRadius - distance, distance - m_OuterRadius);
  }

  double
  ComputeVolume() const override
  {
    return 4.0 / 3.0 * Pi * (std::pow(m_OuterRadius, 3) - std::pow(m_InnerRadius, 3));
  }

protected:
  PointType
  ComputeClosestPoint(const PointType & point) const override
  {
    const bool isNearCavity = 2.0 * Distance(point, m_Center) < m_InnerRadius + m_OuterRadius;
    return ProjectOntoSphere(point, m_Center, isNearCavity ? m_InnerRadius : m_OuterRadius);
  }

private:
  double m_InnerRadius;
  double m_OuterRadius;
};

/** \class TorusOracle
 * \brief A torus around an axis in the z direction.
 */
class TorusOracle : public AnalyticOracle
{
public:
  TorusOracle(const PointType & center, double ringRadius, double tubeRadius)
    : AnalyticOracle(center, 1.01 * (ringRadius + tubeRadius))
    , m_RingRadius(ringRadius)
    , m_TubeRadius(tubeRadius)
  {}

  bool
  FindFirstCrossing(const PointType & from, const PointType & to, PointType & crossing) const override
  {
    // (|x|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2)
    const PolynomialType square = MakeSpherePolynomial(m_Center, m_TubeRadius, from, to);
    const double         ringSquare = m_RingRadius * m_RingRadius;
    const PolynomialType a{ square[0] + ringSquare, square[1], square[2] };
    const PointType      axial{ m_Center[0], m_Center[1], 0.0 };
    const PolynomialType b = MakeSpherePolynomial(axial, 0.0, { from[0], from[1], 0.0 }, { to[0], to[1], 0.0 });
    const PolynomialType quartic{ a[0] * a[0] - 4.0 * ringSquare * b[0],
                                  2.0 * a[0] * a[1] - 4.0 * ringSquare * b[1],
                                  2.0 * a[0] * a[2] + a[1] * a[1] - 4.0 * ringSquare * b[2],
                                  2.0 * a[1] * a[2],
                                  a[2] * a[2] };
    return FindFirstRoot({ quartic }, from, to, crossing);
  }

  double
  ComputeSignedDistance(const PointType & point) const override
  {
    const PointType offset = Subtract(point, m_Center);
    return std::hypot(std::hypot(offset[0], offset[1]) - m_RingRadius, offset[2]) - m_TubeRadius;
  }

  double
  ComputeVolume() const override
  {
    return 2.0 * Pi * Pi * m_RingRadius * m_TubeRadius * m_TubeRadius;
  }

protected:
  PointType
  ComputeClosestPoint(const PointType & point) const override
  {
    const PointType axial{ m_Center[0], m_Center[1], point[2] };
    const PointType ringPoint = ProjectOntoSphere(point, axial, m_RingRadius);
    return ProjectOntoSphere(point, { ringPoint[0], ringPoint[1], m_Center[2] }, m_TubeRadius);
  }

private:
  double m_RingRadius;
  double m_TubeRadius;
};

/** \class TwoBallsOracle
 * \brief Two balls side by side in the x direction. With no gap they touch in a point and are one component.
 */
class TwoBallsOracle : public AnalyticOracle
{
public:
  /** The center is where they touch, or the middle of the gap. */
  TwoBallsOracle(const PointType & center, double leftRadius, double rightRadius, double gap)
    : AnalyticOracle(center, 1.01 * (2.0 * std::max(leftRadius, rightRadius) + 0.5 * gap))
    , m_Centers{ Add(center, PointType{ -leftRadius - 0.5 * gap, 0.0, 0.0 }),
                 Add(center, PointType{ rightRadius + 0.5 * gap, 0.0, 0.0 }) }
    , m_Radii{ leftRadius, rightRadius }
    , m_Gap(gap)
  {}

  bool
  FindFirstCrossing(const PointType & from, const PointType & to, PointType & crossing) const override
  {
    return FindFirstRoot({ MakeSpherePolynomial(m_Centers[0], m_Radii[0], from, to),
                           MakeSpherePolynomial(m_Centers[1], m_Radii[1], from, to) },
                         from,
                         to,
                         crossing);
  }

  ComponentType
  GetNumberOfComponents() const override
  {
    return m_Gap > 0.0 ? 2 : 1;
  }

  ComponentType
  FindComponent(const PointType & point) const override
  {
    return m_Gap > 0.0 ? this->FindNearerBall(point) : 0;
  }

  BoundsType
  GetComponentBounds(ComponentType component) const override
  {
    if (m_Gap <= 0.0)
    {
      return this->GetSurfaceBounds();
    }
    const PointType offset{ m_Radii[component], m_Radii[component], m_Radii[component] };
    return { Subtract(m_Centers[component], offset), Add(m_Centers[component], offset) };
  }

  double
  ComputeSignedDistance(const PointType & point) const override
  {
    const unsigned int ball = this->FindNearerBall(point);
    return Distance(point, m_Centers[ball]) - m_Radii[ball];
  }

  double
  ComputeVolume() const override
  {
    return 4.0 / 3.0 * Pi * (std::pow(m_Radii[0], 3) + std::pow(m_Radii[1], 3));
  }

protected:
  PointType
  ComputeClosestPoint(const PointType & point) const override
  {
    const unsigned int ball = this->FindNearerBall(point);
    return ProjectOntoSphere(point, m_Centers[ball], m_Radii[ball]);
  }

private:
  unsigned int
  FindNearerBall(const PointType & point) const
  {
    return Distance(point, m_Centers[0]) - m_Radii[0] <= Distance(point, m_Centers[1]) - m_Radii[1] ? 0 : 1;
  }

  std::array<PointType, 2> m_Centers;
  std::array<double, 2>    m_Radii;
  double                   m_Gap;
};

/** \class PlateOracle
 * \brief A box with axis-aligned faces; thin if one of its half widths is small.
 */
class PlateOracle : public AnalyticOracle
{
public:
  PlateOracle(const PointType & center, const PointType & halfWidths)
    : AnalyticOracle(center, 1.01 * *std::max_element(halfWidths.begin(), halfWidths.end()))
    , m_HalfWidths(halfWidths)
  {}

  bool
  FindFirstCrossing(const PointType & from, const PointType & to, PointType & crossing) const override
  {
    // The segment is in the box between its last entry into a slab and its first exit from one.
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double offset = from[i] - m_Center[i];
      const double direction = to[i] - from[i];
      if (direction == 0.0)
      {
        if (std::abs(offset) > m_HalfWidths[i])
        {
          return false;
        }
        continue;
      }
      const double t0 = (-m_HalfWidths[i] - offset) / direction;
      const double t1 = (m_HalfWidths[i] - offset) / direction;
      entry = std::max(entry, std::min(t0, t1));
      exit = std::min(exit, std::max(t0, t1));
    }
    const double first = entry >= 0.0 ? entry : exit;
    crossing = Add(from, Scale(Subtract(to, from), first));
    return entry <= exit && first >= 0.0 && first <= 1.0;
  }

  double
  ComputeSignedDistance(const PointType & point) const override
  {
    const PointType excess = this->ComputeExcess(point);
    const PointType outside{ std::max(excess[0], 0.0), std::max(excess[1], 0.0), std::max(excess[2], 0.0) };
    return Norm(outside) + std::min(0.0, *std::max_element(excess.begin(), excess.end()));
  }

  double
  ComputeVolume() const override
  {
    return 8.0 * m_HalfWidths[0] * m_HalfWidths[1] * m_HalfWidths[2];
  }

protected:
  PointType
  ComputeClosestPoint(const PointType & point) const override
  {
    const PointType    excess = this->ComputeExcess(point);
    const auto         nearest = std::max_element(excess.begin(), excess.end());
    const unsigned int nearestAxis = static_cast<unsigned int>(nearest - excess.begin());
    PointType          closest = point;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const bool moves = excess[i] > 0.0 || (*nearest <= 0.0 && i == nearestAxis);
      if (moves)
      {
        closest[i] = m_Center[i] + std::copysign(m_HalfWidths[i], point[i] - m_Center[i]);
      }
    }
    return closest;
  }

private:
  /** How far the point is beyond the faces of each axis. */
  PointType
  ComputeExcess(const PointType & point) const
  {
    PointType excess;
    for (unsigned int i = 0; i < 3; ++i)
    {
      excess[i] = std::abs(point[i] - m_Center[i]) - m_HalfWidths[i];
    }
    return excess;
  }

  PointType m_HalfWidths;
};
} // end namespace itk::DelaunayRefinementTest

#endif
