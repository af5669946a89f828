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

#include "itkCheckedFilterOutput.h"

#include "itkMeshExpectations.h"

#include "itkMesh.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"

using namespace itk::DelaunayRefinementTest;

namespace
{
using MeshType = itk::Mesh<float, 3>;

template <typename TCell>
void
AddCell(MeshType * mesh, const std::vector<itk::IdentifierType> & points, float label)
{
  MeshType::CellAutoPointer cell;
  cell.TakeOwnership(new TCell);
  cell->SetPointIds(points.data(), points.data() + points.size());
  const auto id = mesh->GetNumberOfCells();
  mesh->SetCell(id, cell);
  mesh->SetCellData(id, label);
}

/** \class CheckedFilterOutput
 * \brief One tetrahedron, and its boundary with an order of points of its own. */
class CheckedFilterOutput : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    const float corners[4][3] = {
      { 0.0f, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }
    };
    for (unsigned int i = 0; i < 4; ++i)
    {
      m_Volume->SetPoint(i, corners[i]);
      m_Boundary->SetPoint(3 - i, corners[i]);
    }
    AddCell<itk::TetrahedronCell<MeshType::CellType>>(m_Volume, { 0, 1, 2, 3 }, 4.0f);
    using TriangleType = itk::TriangleCell<MeshType::CellType>;
    AddCell<TriangleType>(m_Boundary, { 2, 1, 0 }, 5.0f);
    AddCell<TriangleType>(m_Boundary, { 3, 0, 1 }, 5.0f);
    AddCell<TriangleType>(m_Boundary, { 3, 2, 0 }, 5.0f);
    AddCell<TriangleType>(m_Boundary, { 3, 1, 2 }, 5.0f);
  }

  MeshType::Pointer m_Volume = MeshType::New();
  MeshType::Pointer m_Boundary = MeshType::New();
};
} // namespace

TEST_F(CheckedFilterOutput, IsTakenFromTwoMeshes)
{
  const CheckedMesh mesh = MakeCheckedMesh(*m_Volume, *m_Boundary);
  ExpectValidMesh(mesh);
  EXPECT_NEAR(ComputeVolume(mesh), 1.0 / 6.0, 1e-12);
  EXPECT_EQ(mesh.tetrahedronLabels, std::vector<double>({ 4.0 }));
  EXPECT_EQ(mesh.triangleLabels, std::vector<double>(4, 5.0));
}

TEST_F(CheckedFilterOutput, ShowsForeignPoints)
{
  m_Boundary->SetPoint(3, MeshType::PointType(0.25f));
  EXPECT_EQ(CountBadIndices(MakeCheckedMesh(*m_Volume, *m_Boundary)), 3u);
}

TEST_F(CheckedFilterOutput, ShowsCellsOfAnotherKind)
{
  AddCell<itk::TriangleCell<MeshType::CellType>>(m_Volume, { 0, 1, 2 }, 1.0f);
  EXPECT_EQ(CountBadIndices(MakeCheckedMesh(*m_Volume, *m_Boundary)), 1u);
}

TEST_F(CheckedFilterOutput, ShowsMissingPoints)
{
  AddCell<itk::TetrahedronCell<MeshType::CellType>>(m_Volume, { 0, 1, 2, 4 }, 1.0f);
  EXPECT_EQ(CountBadIndices(MakeCheckedMesh(*m_Volume, *m_Boundary)), 1u);
}
