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
#include "MeshImageQuality.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meshimage
{
namespace
{
using PointType = MeshType::PointType;
using VectorType = PointType::VectorType;

/** The points of a cell. */
template <std::size_t VCount>
std::array<PointType, VCount>
GetCorners(const MeshType & mesh, const MeshType::CellType & cell)
{
  std::array<PointType, VCount> corners;
  auto                          id = cell.PointIdsBegin();
  for (PointType & corner : corners)
  {
    corner = mesh.GetPoints()->ElementAt(*id);
    ++id;
  }
  return corners;
}

/** In degrees; exact also near 0 and 180, where the cosine is not. */
double
AngleBetween(const VectorType & a, const VectorType & b)
{
  return std::atan2(itk::CrossProduct(a, b).GetNorm(), a * b) * 180.0 / itk::Math::pi;
}

/** Radius of the sphere through the corners of a tetrahedron, one of which is the origin. */
double
Circumradius(const VectorType & a, const VectorType & b, const VectorType & c)
{
  const VectorType bc = itk::CrossProduct(b, c);
  const VectorType numerator = bc * a.GetSquaredNorm() + itk::CrossProduct(c, a) * b.GetSquaredNorm() +
                               itk::CrossProduct(a, b) * c.GetSquaredNorm();
  return numerator.GetNorm() / std::abs(2.0 * (a * bc));
}

void
MeasureTetrahedron(const std::array<PointType, 4> & corners, Quality & quality)
{
  // Each edge with the two corners opposite to it, whose faces meet there.
  constexpr unsigned int edges[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 1, 3 }, { 0, 3, 1, 2 },
                                         { 1, 2, 0, 3 }, { 1, 3, 0, 2 }, { 2, 3, 0, 1 } };

  double shortest = std::numeric_limits<double>::infinity();
  for (const auto & edge : edges)
  {
    const VectorType along = corners[edge[1]] - corners[edge[0]];
    const double     length = along.GetNorm();
    shortest = std::min(shortest, length);
    quality.edgeMaximum = std::max(quality.edgeMaximum, length);

    const double angle = AngleBetween(itk::CrossProduct(along, corners[edge[2]] - corners[edge[0]]),
                                      itk::CrossProduct(along, corners[edge[3]] - corners[edge[0]]));
    quality.dihedralAngleMinimum = std::min(quality.dihedralAngleMinimum, angle);
    quality.dihedralAngleMaximum = std::max(quality.dihedralAngleMaximum, angle);
    const auto bin = static_cast<std::size_t>(angle / Quality::binWidth);
    ++quality.dihedralAngleHistogram[std::min(bin, Quality::numberOfBins - 1)];
  }
  quality.edgeMinimum = std::min(quality.edgeMinimum, shortest);

  const double radius = Circumradius(corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0]);
  quality.radiusEdgeRatioMaximum = std::max(quality.radiusEdgeRatioMaximum, radius / shortest);
}

void
MeasureTriangle(const std::array<PointType, 3> & corners, Quality & quality)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    const PointType & corner = corners[i];
    quality.boundaryAngleMinimum = std::min(quality.boundaryAngleMinimum,
                                            AngleBetween(corners[(i + 1) % 3] - corner, corners[(i + 2) % 3] - corner));
  }
}
} // namespace

Quality
MeasureQuality(const MeshType & mesh, const MeshType & boundary)
{
  Quality quality;
  quality.edgeMinimum = std::numeric_limits<double>::infinity();
  for (auto cell = mesh.GetCells()->Begin(); cell != mesh.GetCells()->End(); ++cell)
  {
    MeasureTetrahedron(GetCorners<4>(mesh, *cell.Value()), quality);
  }
  for (auto cell = boundary.GetCells()->Begin(); cell != boundary.GetCells()->End(); ++cell)
  {
    MeasureTriangle(GetCorners<3>(boundary, *cell.Value()), quality);
  }
  return quality;
}
} // namespace meshimage
