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
#ifndef itkCheckedFilterOutput_h
#define itkCheckedFilterOutput_h

#include "itkCheckedMesh.h"

#include "itkCommonEnums.h"

#include <map>

namespace itk::DelaunayRefinementTest
{
/** Takes the cells of one kind from an itk::Mesh. An index out of range stands for a point that \c indices lacks and
 * for a cell of another kind. */
template <std::size_t NumberOfPoints, typename TMesh, typename TIndices>
void
AppendCells(const TMesh &                                            source,
            CellGeometryEnum                                         geometry,
            const TIndices &                                         indices,
            std::vector<std::array<std::uint32_t, NumberOfPoints>> & cells,
            std::vector<double> &                                    labels)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  if (source.GetCells() == nullptr)
  {
    return;
  }
  for (auto it = source.GetCells()->Begin(); it != source.GetCells()->End(); ++it)
  {
    std::array<std::uint32_t, NumberOfPoints> cell;
    cell.fill(none);
    if (it.Value()->GetType() == geometry)
    {
      auto pointId = it.Value()->PointIdsBegin();
      for (std::uint32_t & index : cell)
      {
        const auto found = indices.find(*pointId++);
        index = found == indices.end() ? none : found->second;
      }
    }
    cells.push_back(cell);
    typename TMesh::CellPixelType label{};
    if (source.GetCellData() != nullptr && source.GetCellData()->GetElementIfIndexExists(it.Index(), &label))
    {
      labels.push_back(static_cast<double>(label));
    }
  }
}

/** From the filter's two outputs; a point of the boundary is the volume's point with the same coordinates. */
template <typename TMesh>
CheckedMesh
MakeCheckedMesh(const TMesh & volume, const TMesh & boundary)
{
  using IndexMapType = std::map<typename TMesh::PointIdentifier, std::uint32_t>;
  const auto toPoint = [](const typename TMesh::PointType & point) {
    return PointType{ point[0], point[1], point[2] };
  };

  CheckedMesh                        mesh;
  IndexMapType                       volumeIndices;
  std::map<PointType, std::uint32_t> coordinateIndices;
  for (auto it = volume.GetPoints()->Begin(); it != volume.GetPoints()->End(); ++it)
  {
    const auto index = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(toPoint(it.Value()));
    volumeIndices[it.Index()] = index;
    coordinateIndices[mesh.points.back()] = index;
  }
  IndexMapType boundaryIndices;
  for (auto it = boundary.GetPoints()->Begin(); it != boundary.GetPoints()->End(); ++it)
  {
    const auto found = coordinateIndices.find(toPoint(it.Value()));
    if (found != coordinateIndices.end())
    {
      boundaryIndices[it.Index()] = found->second;
    }
  }
  AppendCells(volume, CellGeometryEnum::TETRAHEDRON_CELL, volumeIndices, mesh.tetrahedra, mesh.tetrahedronLabels);
  AppendCells(boundary, CellGeometryEnum::TRIANGLE_CELL, boundaryIndices, mesh.triangles, mesh.triangleLabels);
  return mesh;
}
} // end namespace itk::DelaunayRefinementTest

#endif
