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

/** From what is proportional to its sine and its cosine: exact also near 0 and 180, where the cosine alone is not. */
double
AngleInDegrees(double sine, double cosine)
{
  return std::atan2(sine, cosine) * 180.0 / itk::Math::pi;
}

void
MeasureTetrahedron(const std::array<PointType, 4> & corners, Quality & quality)
{
  // Each edge, with the corners opposite to the two faces that meet there.
  constexpr unsigned int edges[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 1, 3 }, { 0, 3, 1, 2 },
                                         { 1, 2, 0, 3 }, { 1, 3, 0, 2 }, { 2, 3, 0, 1 } };

  const VectorType a = corners[1] - corners[0];
  const VectorType b = corners[2] - corners[0];
  const VectorType c = corners[3] - corners[0];
  // Normals of the faces opposite to the corners, twice as long as the face is large, all outward or all inward.
  const std::array<VectorType, 4> normals{ { itk::CrossProduct(corners[2] - corners[1], corners[3] - corners[1]),
                                             itk::CrossProduct(c, b),
                                             itk::CrossProduct(a, c),
                                             itk::CrossProduct(b, a) } };
  const double                    sixVolumes = std::abs(a * normals[1]);

  double shortest = std::numeric_limits<double>::infinity();
  for (const auto & [from, to, left, right] : edges)
  {
    const double length = (corners[to] - corners[from]).GetNorm();
    shortest = std::min(shortest, length);
    quality.edgeMaximum = std::max(quality.edgeMaximum, length);

    // The cross product of the two normals is the edge times sixVolumes.
    const double angle = AngleInDegrees(sixVolumes * length, -(normals[left] * normals[right]));
    quality.dihedralAngleMinimum = std::min(quality.dihedralAngleMinimum, angle);
    quality.dihedralAngleMaximum = std::max(quality.dihedralAngleMaximum, angle);
    const auto bin = static_cast<std::size_t>(angle / Quality::binWidth);
    ++quality.dihedralAngleHistogram[std::min(bin, Quality::numberOfBins - 1)];
  }
  quality.edgeMinimum = std::min(quality.edgeMinimum, shortest);

  const VectorType toCenter =
    normals[1] * a.GetSquaredNorm() + normals[2] * b.GetSquaredNorm() + normals[3] * c.GetSquaredNorm();
  const double radius = toCenter.GetNorm() / (2.0 * sixVolumes);
  quality.radiusEdgeRatioMaximum = std::max(quality.radiusEdgeRatioMaximum, radius / shortest);
}

void
MeasureTriangle(const std::array<PointType, 3> & corners, Quality & quality)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    const VectorType a = corners[(i + 1) % 3] - corners[i];
    const VectorType b = corners[(i + 2) % 3] - corners[i];
    quality.boundaryAngleMinimum =
      std::min(quality.boundaryAngleMinimum, AngleInDegrees(itk::CrossProduct(a, b).GetNorm(), a * b));
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
