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
#include "itkDelaunayRefinementGeometry.h"

#include <algorithm>

namespace itk
{
namespace
{
/** A determinant below this many rounding errors is computed again, exactly. */
constexpr double ReliableRoundings = 1e6;

double
LargestCoordinate(const DelaunayRefinementPoint & p)
{
  return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
}
} // namespace

DelaunayRefinementGeometry::SphereType
DelaunayRefinementGeometry::ComputeCircumsphere(const PointType & a,
                                                const PointType & b,
                                                const PointType & c,
                                                const PointType & d)
{
  const RoundedSphereType rounded = ComputeRoundedCircumsphere(a, b, c, d);
  const double            square = rounded.greatestSquare;
  const double rounding = std::numeric_limits<double>::epsilon() * square * (std::sqrt(square) + LargestCoordinate(a));
  if (std::abs(rounded.determinant) < ReliableRoundings * rounding)
  {
    return ComputeExactCircumsphere(a, b, c, d);
  }
  return rounded.ball;
}

DelaunayRefinementGeometry::SphereType
DelaunayRefinementGeometry::ComputeCircumsphere(const PointType & a, const PointType & b, const PointType & c)
{
  const PointType u = Subtract(b, a);
  const PointType v = Subtract(c, a);
  const PointType normal = Cross(u, v);
  const double    factor = 0.5 / Dot(normal, normal);
  const PointType uPart = Cross(v, normal);
  const PointType vPart = Cross(normal, u);
  const double    uu = Dot(u, u);
  const double    vv = Dot(v, v);
  const PointType offset{ factor * (uu * uPart[0] + vv * vPart[0]),
                          factor * (uu * uPart[1] + vv * vPart[1]),
                          factor * (uu * uPart[2] + vv * vPart[2]) };
  return { AddScaled(a, 1.0, offset), Dot(offset, offset) };
}

double
DelaunayRefinementGeometry::ComputeSquaredShortestEdge(const PointType & a,
                                                       const PointType & b,
                                                       const PointType & c,
                                                       const PointType & d)
{
  return std::min({ SquaredDistance(a, b),
                    SquaredDistance(a, c),
                    SquaredDistance(a, d),
                    SquaredDistance(b, c),
                    SquaredDistance(b, d),
                    SquaredDistance(c, d) });
}

double
DelaunayRefinementGeometry::ComputeSquaredLongestEdge(const PointType & a,
                                                      const PointType & b,
                                                      const PointType & c,
                                                      const PointType & d)
{
  return std::max({ SquaredDistance(a, b),
                    SquaredDistance(a, c),
                    SquaredDistance(a, d),
                    SquaredDistance(b, c),
                    SquaredDistance(b, d),
                    SquaredDistance(c, d) });
}

double
DelaunayRefinementGeometry::ComputeLargestDihedralCosine(const PointType & a,
                                                         const PointType & b,
                                                         const PointType & c,
                                                         const PointType & d)
{
  // The dihedral angle at an edge is pi minus the angle between the outward normals of its two faces.
  const PointType normals[4] = { Cross(Subtract(d, b), Subtract(c, b)),
                                 Cross(Subtract(c, a), Subtract(d, a)),
                                 Cross(Subtract(d, a), Subtract(b, a)),
                                 Cross(Subtract(b, a), Subtract(c, a)) };
  double          largest = -1.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      const double lengths = std::sqrt(Dot(normals[i], normals[i]) * Dot(normals[j], normals[j]));
      largest = std::max(largest, -Dot(normals[i], normals[j]) / lengths);
    }
  }
  return largest;
}

double
DelaunayRefinementGeometry::ComputeLargestCosine(const PointType & a, const PointType & b, const PointType & c)
{
  const PointType u = Subtract(b, a);
  const PointType v = Subtract(c, b);
  const PointType w = Subtract(a, c);
  const double    uu = Dot(u, u);
  const double    vv = Dot(v, v);
  const double    ww = Dot(w, w);
  return std::max(
    { -Dot(w, u) / std::sqrt(ww * uu), -Dot(u, v) / std::sqrt(uu * vv), -Dot(v, w) / std::sqrt(vv * ww) });
}
} // end namespace itk
