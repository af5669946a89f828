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
#ifndef itkWriterTestMeshes_h
#define itkWriterTestMeshes_h

#include "itkDefaultDynamicMeshTraits.h"
#include "itkMesh.h"
#include "itkTetrahedralMeshWriter.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"


#include <string>
#include <vector>

namespace itk::DelaunayRefinementTest
{
template <typename TCoordinate, typename TLabel>
using WriterTestMesh = Mesh<double, 3, DefaultStaticMeshTraits<double, 3, 3, TCoordinate, TCoordinate, TLabel>>;

/** Coordinates that single precision cannot hold. */
inline double
WriterTestCoordinate(IdentifierType id, unsigned int axis)
{
  return 1e5 + static_cast<double>(id * (axis + 1)) / 3.0;
}

template <typename TMesh>
void
AddPoints(TMesh * mesh, const std::vector<IdentifierType> & ids)
{
  for (const IdentifierType id : ids)
  {
    typename TMesh::PointType point;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      point[axis] = static_cast<typename TMesh::CoordRepType>(WriterTestCoordinate(id, axis));
    }
    mesh->SetPoint(id, point);
  }
}

template <typename TCell, typename TMesh>
void
AddCell(TMesh * mesh, IdentifierType id, const std::vector<IdentifierType> & pointIds)
{
  typename TMesh::CellAutoPointer cell;
  cell.TakeOwnership(new TCell);
  cell->SetPointIds(pointIds.data(), pointIds.data() + pointIds.size());
  mesh->SetCell(id, cell);
}

/** One tetrahedron a label, in a row of points. */
template <typename TMesh>
typename TMesh::Pointer
MakeTetrahedra(const std::vector<typename TMesh::CellPixelType> & labels)
{
  auto                        mesh = TMesh::New();
  std::vector<IdentifierType> pointIds;
  for (IdentifierType id = 0; id < labels.size() + 3; ++id)
  {
    pointIds.push_back(id);
  }
  AddPoints(mesh.GetPointer(), pointIds);
  for (IdentifierType id = 0; id < labels.size(); ++id)
  {
    AddCell<TetrahedronCell<typename TMesh::CellType>>(mesh.GetPointer(), id, { id, id + 2, id + 1, id + 3 });
    mesh->SetCellData(id, labels[id]);
  }
  return mesh;
}

/** One triangle a label. */
template <typename TMesh>
typename TMesh::Pointer
MakeTriangles(const std::vector<typename TMesh::CellPixelType> & labels)
{
  auto                        mesh = TMesh::New();
  std::vector<IdentifierType> pointIds;
  for (IdentifierType id = 0; id < labels.size() + 2; ++id)
  {
    pointIds.push_back(id);
  }
  AddPoints(mesh.GetPointer(), pointIds);
  for (IdentifierType id = 0; id < labels.size(); ++id)
  {
    AddCell<TriangleCell<typename TMesh::CellType>>(mesh.GetPointer(), id, { id + 2, id, id + 1 });
    mesh->SetCellData(id, labels[id]);
  }
  return mesh;
}

template <typename TMesh>
void
WriteTestMesh(const TMesh * mesh, const std::string & fileName)
{
  const auto writer = TetrahedralMeshWriter<TMesh>::New();
  writer->SetInput(mesh);
  writer->SetFileName(fileName);
  writer->Update();
}
} // end namespace itk::DelaunayRefinementTest

#endif
