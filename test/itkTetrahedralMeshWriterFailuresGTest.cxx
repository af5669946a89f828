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

#include "itkLineCell.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>

namespace
{
using namespace itk;
using namespace itk::DelaunayRefinementTest;

using MeshType = WriterTestMesh<double, std::uint64_t>;
using WriterType = TetrahedralMeshWriter<MeshType>;

/** What the writer says, or nothing if it wrote the file. */
template <typename TMesh>
std::string
Refusal(const TMesh * mesh, const std::string & fileName)
{
  try
  {
    WriteTestMesh(mesh, fileName);
  }
  catch (const ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "";
}

void
ExpectMention(const std::string & message, const std::string & word)
{
  EXPECT_NE(message.find(word), std::string::npos) << "The message was: " << message;
}

class TetrahedralMeshWriterFailures : public testing::Test
{
protected:
  TemporaryFolder   m_Folder;
  MeshType::Pointer m_Mesh = MakeTetrahedra<MeshType>({ 1, 2, 3 });
};

TEST_F(TetrahedralMeshWriterFailures, NoMesh)
{
  const auto writer = WriterType::New();
  writer->SetFileName(m_Folder / "mesh.vtu");
  EXPECT_THROW(writer->Update(), ExceptionObject);
}

TEST_F(TetrahedralMeshWriterFailures, NoFileName)
{
  const auto writer = WriterType::New();
  writer->SetInput(m_Mesh);
  EXPECT_THROW(writer->Update(), ExceptionObject);
}

TEST_F(TetrahedralMeshWriterFailures, NoCells)
{
  ExpectMention(Refusal(MeshType::New().GetPointer(), m_Folder / "mesh.vtu"), "no cells");
}

TEST_F(TetrahedralMeshWriterFailures, OtherCells)
{
  const auto lines = MeshType::New();
  AddPoints(lines.GetPointer(), { 0, 1 });
  AddCell<LineCell<MeshType::CellType>>(lines.GetPointer(), 0, { 0, 1 });
  ExpectMention(Refusal(lines.GetPointer(), m_Folder / "mesh.vtu"), "tetrahedra or of triangles");

  AddCell<TriangleCell<MeshType::CellType>>(m_Mesh.GetPointer(), 3, { 0, 1, 2 });
  ExpectMention(Refusal(m_Mesh.GetPointer(), m_Folder / "mesh.vtu"), "several kinds");
}

TEST_F(TetrahedralMeshWriterFailures, PointsThatAreNotThere)
{
  AddCell<TetrahedronCell<MeshType::CellType>>(m_Mesh.GetPointer(), 2, { 0, 1, 2, 600 });
  ExpectMention(Refusal(m_Mesh.GetPointer(), m_Folder / "mesh.vtu"), "point 600");
}

TEST_F(TetrahedralMeshWriterFailures, LabelsForSomeCellsOnly)
{
  const auto cellData = MeshType::CellDataContainer::New();
  cellData->InsertElement(0, 1);
  m_Mesh->SetCellData(cellData);
  ExpectMention(Refusal(m_Mesh.GetPointer(), m_Folder / "mesh.vtu"), "some cells only");
}

TEST_F(TetrahedralMeshWriterFailures, LabelsThatAreNoWholeNumbers)
{
  using FloatMesh = WriterTestMesh<float, float>;
  for (const float label : { 0.5F, 1e20F, std::numeric_limits<float>::quiet_NaN() })
  {
    ExpectMention(Refusal(MakeTetrahedra<FloatMesh>({ label }).GetPointer(), m_Folder / "mesh.vtu"), "whole numbers");
  }
}

TEST_F(TetrahedralMeshWriterFailures, ExtensionsOfOtherKinds)
{
  for (const char * name : { "mesh.docx", "mesh", "mesh.stl", "mesh.ply", "mesh.vtp" })
  {
    const std::string message = Refusal(m_Mesh.GetPointer(), m_Folder / name);
    ExpectMention(message, name);
    ExpectMention(message, ".vtu or .vtk");
  }
  ExpectMention(Refusal(MakeTriangles<MeshType>({ 1 }).GetPointer(), m_Folder / "mesh.vtu"), ".stl or .ply");
}

TEST_F(TetrahedralMeshWriterFailures, MissingFolder)
{
  ExpectMention(Refusal(m_Mesh.GetPointer(), m_Folder / "nowhere/mesh.vtu"), m_Folder / "nowhere");
}

TEST_F(TetrahedralMeshWriterFailures, FolderOfThatName)
{
  std::filesystem::create_directory(m_Folder / "mesh.vtu");
  ExpectMention(Refusal(m_Mesh.GetPointer(), m_Folder / "mesh.vtu"), "something else of that name");
  EXPECT_TRUE(std::filesystem::is_directory(m_Folder / "mesh.vtu"));
}

/** Nothing can be written beyond the limit: to the writer the same as a full disk. */
TEST_F(TetrahedralMeshWriterFailures, FullDisk)
{
  for (const char * name : { "mesh.vtu", "mesh.vtk" })
  {
    WriteBytes(m_Folder / name, "before");

    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit     limit = before;
    limit.rlim_cur = 100;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    const std::string message = Refusal(m_Mesh.GetPointer(), m_Folder / name);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, oldHandler);

    ExpectMention(message, "cannot be written");
    ExpectMention(message, m_Folder / name);
    EXPECT_EQ(ReadBytes(m_Folder / name), "before");
  }
  EXPECT_EQ(m_Folder.List(), (std::set<std::string>{ "mesh.vtu", "mesh.vtk" }));
}

TEST_F(TetrahedralMeshWriterFailures, AnAbortLeavesTheOldFile)
{
  const std::string fileName = m_Folder / "mesh.vtu";
  WriteBytes(fileName, "before");
  const auto writer = WriterType::New();
  writer->SetInput(m_Mesh);
  writer->SetFileName(fileName);
  const auto observer = writer->AddObserver(ProgressEvent(), [&writer](const EventObject &) {
    if (writer->GetProgress() > 0.0F)
    {
      writer->SetAbortGenerateData(true);
    }
  });
  EXPECT_THROW(writer->Update(), ProcessAborted);
  EXPECT_EQ(ReadBytes(fileName), "before");

  writer->RemoveObserver(observer);
  writer->Update();
  EXPECT_NE(ReadBytes(fileName), "before");
  EXPECT_EQ(m_Folder.List(), std::set<std::string>{ "mesh.vtu" });
}

TEST_F(TetrahedralMeshWriterFailures, ProgressGrows)
{
  const auto         writer = WriterType::New();
  std::vector<float> shares;
  writer->SetInput(m_Mesh);
  writer->SetFileName(m_Folder / "mesh.vtu");
  writer->AddObserver(ProgressEvent(), [&](const EventObject &) { shares.push_back(writer->GetProgress()); });
  writer->Update();
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.size(), 3U);
  EXPECT_EQ(shares.back(), 1.0F);
}

TEST_F(TetrahedralMeshWriterFailures, ALinkStaysALink)
{
  std::filesystem::create_directory(m_Folder / "elsewhere");
  WriteBytes(m_Folder / "elsewhere/mesh.vtu", "before");
  std::filesystem::create_symlink(m_Folder / "elsewhere/mesh.vtu", m_Folder / "link.vtu");
  WriteTestMesh(m_Mesh.GetPointer(), m_Folder / "link.vtu");
  EXPECT_TRUE(std::filesystem::is_symlink(m_Folder / "link.vtu"));
  EXPECT_NE(ReadBytes(m_Folder / "elsewhere/mesh.vtu"), "before");
}
} // namespace
