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
#include "itkTetrahedralMeshWriter.h"

#include "itkTemporaryFolder.h"
#include "itkWriterTestMeshes.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt64Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cstring>
#include <limits>

namespace
{
using namespace itk;
using namespace itk::DelaunayRefinementTest;

using LabelMesh = WriterTestMesh<double, std::uint64_t>;
using FloatMesh = WriterTestMesh<float, double>;

template <typename TReader>
vtkSmartPointer<vtkDataSet>
Read(const std::string & fileName)
{
  vtkNew<TReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return vtkSmartPointer<vtkDataSet>(reader->GetOutput());
}

vtkSmartPointer<vtkDataSet>
ReadTetrahedra(const std::string & fileName)
{
  return fileName.back() == 'u' ? Read<vtkXMLUnstructuredGridReader>(fileName)
                                : Read<vtkUnstructuredGridReader>(fileName);
}

void
ExpectPoints(vtkDataSet * data, IdentifierType count)
{
  ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(count));
  for (IdentifierType id = 0; id < count; ++id)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(data->GetPoint(static_cast<vtkIdType>(id))[axis], WriterTestCoordinate(id, axis));
    }
  }
}

void
ExpectCell(vtkDataSet * data, vtkIdType cell, const std::vector<vtkIdType> & pointIds)
{
  vtkNew<vtkIdList> found;
  data->GetCellPoints(cell, found);
  EXPECT_EQ(std::vector<vtkIdType>(found->begin(), found->end()), pointIds);
}

/** The labels as text, which is exact for any integer type. */
std::vector<std::string>
LabelsOf(vtkDataSet * data)
{
  vtkDataArray *           array = data->GetCellData()->GetArray("label");
  std::vector<std::string> labels;
  for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfTuples(); ++i)
  {
    labels.push_back(array->GetVariantValue(i).ToString());
  }
  return labels;
}

float
FloatAt(const std::string & bytes, std::size_t offset)
{
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

std::int32_t
IntegerAt(const std::string & bytes, std::size_t offset)
{
  std::int32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

class TetrahedraIn : public testing::TestWithParam<const char *>
{
protected:
  TemporaryFolder m_Folder;
  std::string     m_FileName = m_Folder / GetParam();
};

TEST_P(TetrahedraIn, KeepPointsCellsAndLabels)
{
  WriteTestMesh(MakeTetrahedra<LabelMesh>({ 7, 1, 4711 }).GetPointer(), m_FileName);
  const auto data = ReadTetrahedra(m_FileName);
  ExpectPoints(data, 6);
  ASSERT_EQ(data->GetNumberOfCells(), 3);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(data->GetCellType(i), VTK_TETRA);
    ExpectCell(data, i, { i, i + 2, i + 1, i + 3 });
  }
  EXPECT_EQ(LabelsOf(data), (std::vector<std::string>{ "7", "1", "4711" }));
  EXPECT_EQ(data->GetCellData()->GetArray("label")->GetDataType(), VTK_INT);
}

TEST_P(TetrahedraIn, KeepLabelsOf64Bits)
{
  const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  WriteTestMesh(MakeTetrahedra<LabelMesh>({ 1, largest }).GetPointer(), m_FileName);
  EXPECT_EQ(LabelsOf(ReadTetrahedra(m_FileName)), (std::vector<std::string>{ "1", std::to_string(largest) }));

  using SignedMesh = WriterTestMesh<double, std::int64_t>;
  WriteTestMesh(MakeTetrahedra<SignedMesh>({ -1, std::int64_t{ 1 } << 40 }).GetPointer(), m_FileName);
  EXPECT_EQ(LabelsOf(ReadTetrahedra(m_FileName)), (std::vector<std::string>{ "-1", "1099511627776" }));
}

TEST_P(TetrahedraIn, KeepLabelsOfFloatingPointMeshes)
{
  WriteTestMesh(MakeTetrahedra<FloatMesh>({ 1.0, 16777217.0 }).GetPointer(), m_FileName);
  const auto data = ReadTetrahedra(m_FileName);
  EXPECT_EQ(LabelsOf(data), (std::vector<std::string>{ "1", "16777217" }));
  EXPECT_EQ(data->GetPoint(1)[0], static_cast<double>(static_cast<float>(WriterTestCoordinate(1, 0))));
}

TEST_P(TetrahedraIn, MayHaveNoLabels)
{
  const auto mesh = MakeTetrahedra<LabelMesh>({ 1 });
  mesh->SetCellData(LabelMesh::CellDataContainer::New());
  WriteTestMesh(mesh.GetPointer(), m_FileName);
  const auto data = ReadTetrahedra(m_FileName);
  EXPECT_EQ(data->GetNumberOfCells(), 1);
  EXPECT_EQ(data->GetCellData()->GetNumberOfArrays(), 0);
}

TEST_P(TetrahedraIn, GiveTheSameBytesTwice)
{
  const std::string again = m_Folder / (std::string("again-") + GetParam());
  WriteTestMesh(MakeTetrahedra<LabelMesh>({ 1, 2 }).GetPointer(), m_FileName);
  WriteTestMesh(MakeTetrahedra<LabelMesh>({ 1, 2 }).GetPointer(), again);
  EXPECT_EQ(ReadBytes(m_FileName), ReadBytes(again));
  EXPECT_EQ(m_Folder.List().size(), 2U);
}

TEST_P(TetrahedraIn, MayHaveGapsInTheirNumbers)
{
  using MapMesh = Mesh<double, 3, DefaultDynamicMeshTraits<double, 3, 3, double, double, std::uint64_t>>;
  const auto mesh = MapMesh::New();
  AddPoints(mesh.GetPointer(), { 2, 3, 5, 11 });
  AddCell<TetrahedronCell<MapMesh::CellType>>(mesh.GetPointer(), 40, { 3, 2, 5, 11 });
  mesh->SetCellData(40, 9);
  WriteTestMesh(mesh.GetPointer(), m_FileName);
  const auto data = ReadTetrahedra(m_FileName);
  EXPECT_EQ(data->GetPoint(3)[0], WriterTestCoordinate(11, 0));
  ExpectCell(data, 0, { 1, 0, 2, 3 });
  EXPECT_EQ(LabelsOf(data), std::vector<std::string>{ "9" });
}

INSTANTIATE_TEST_SUITE_P(TetrahedralMeshWriter,
                         TetrahedraIn,
                         testing::Values("mesh.vtu", "mesh.vtk"),
                         [](const auto & test) { return std::string(test.param).substr(5); });

TEST(TetrahedralMeshWriter, KnowsExtensionsInCapitals)
{
  const TemporaryFolder folder;
  const auto            mesh = MakeTetrahedra<LabelMesh>({ 1 });
  WriteTestMesh(mesh.GetPointer(), folder / "mesh.VTU");
  WriteTestMesh(mesh.GetPointer(), folder / "mesh.vtu");
  EXPECT_EQ(ReadBytes(folder / "mesh.VTU"), ReadBytes(folder / "mesh.vtu"));
}

TEST(TetrahedralMeshWriter, CompressesXML)
{
  const TemporaryFolder folder;
  WriteTestMesh(MakeTetrahedra<LabelMesh>(std::vector<std::uint64_t>(10000, 1)).GetPointer(), folder / "mesh.vtu");
  const std::string bytes = ReadBytes(folder / "mesh.vtu");
  EXPECT_NE(bytes.find("vtkZLibDataCompressor"), std::string::npos);
  // 10000 cells alone take 410000 bytes uncompressed.
  EXPECT_LT(bytes.size(), 200000U);
}

TEST(TetrahedralMeshWriter, WritesTrianglesForVTK)
{
  const TemporaryFolder folder;
  const auto            mesh = MakeTriangles<LabelMesh>({ 5, 6 });
  WriteTestMesh(mesh.GetPointer(), folder / "surface.vtp");
  WriteTestMesh(mesh.GetPointer(), folder / "surface.vtk");
  for (const auto & data :
       { Read<vtkXMLPolyDataReader>(folder / "surface.vtp"), Read<vtkPolyDataReader>(folder / "surface.vtk") })
  {
    ExpectPoints(data, 4);
    ASSERT_EQ(data->GetNumberOfCells(), 2);
    EXPECT_EQ(data->GetCellType(0), VTK_TRIANGLE);
    ExpectCell(data, 1, { 3, 1, 2 });
    EXPECT_EQ(LabelsOf(data), (std::vector<std::string>{ "5", "6" }));
  }
}

TEST(TetrahedralMeshWriter, WritesSTL)
{
  const TemporaryFolder folder;
  const auto            mesh = LabelMesh::New();
  mesh->SetPoint(0, std::array<double, 3>{ { 0.0, 0.0, 2.0 } }.data());
  mesh->SetPoint(1, std::array<double, 3>{ { 3.0, 0.0, 2.0 } }.data());
  mesh->SetPoint(2, std::array<double, 3>{ { 0.0, 1.5, 2.0 } }.data());
  AddCell<TriangleCell<LabelMesh::CellType>>(mesh.GetPointer(), 0, { 1, 2, 0 });
  WriteTestMesh(mesh.GetPointer(), folder / "surface.stl");
  const std::string bytes = ReadBytes(folder / "surface.stl");
  ASSERT_EQ(bytes.size(), 134U);
  // Readers take files that begin with this word for text.
  EXPECT_NE(bytes.substr(0, 5), "solid");
  EXPECT_EQ(IntegerAt(bytes, 80), 1);
  const float expected[12] = { 0.0F, 0.0F, 1.0F, 3.0F, 0.0F, 2.0F, 0.0F, 1.5F, 2.0F, 0.0F, 0.0F, 2.0F };
  for (std::size_t i = 0; i < 12; ++i)
  {
    EXPECT_EQ(FloatAt(bytes, 84 + 4 * i), expected[i]) << i;
  }
}

TEST(TetrahedralMeshWriter, WritesPLY)
{
  const TemporaryFolder folder;
  WriteTestMesh(MakeTriangles<LabelMesh>({ 5, 6 }).GetPointer(), folder / "surface.ply");
  const std::string bytes = ReadBytes(folder / "surface.ply");
  EXPECT_EQ(bytes.substr(0, 4), "ply\n");
  EXPECT_NE(bytes.find("element vertex 4\n"), std::string::npos);
  EXPECT_NE(bytes.find("element face 2\n"), std::string::npos);
  const std::size_t body = bytes.find("end_header\n") + 11;
  ASSERT_EQ(bytes.size(), body + 4 * 12 + 2 * 13);
  EXPECT_EQ(FloatAt(bytes, body + 3 * 12 + 4), static_cast<float>(WriterTestCoordinate(3, 1)));
  EXPECT_EQ(bytes[body + 48 + 13], 3);
  EXPECT_EQ(IntegerAt(bytes, body + 48 + 14), 3);
  EXPECT_EQ(IntegerAt(bytes, body + 48 + 18), 1);
  EXPECT_EQ(IntegerAt(bytes, body + 48 + 22), 2);
}

TEST(TetrahedralMeshWriter, PrintsItsFileName)
{
  const auto writer = TetrahedralMeshWriter<LabelMesh>::New();
  writer->SetFileName("somewhere/mesh.vtu");
  std::ostringstream text;
  writer->Print(text);
  EXPECT_NE(text.str().find("FileName: somewhere/mesh.vtu"), std::string::npos);
}
} // namespace
