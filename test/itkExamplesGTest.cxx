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
#include "itkCommandTestImages.h"
#include "itkMeshExpectations.h"

#include "itkImageFileReader.h"
#include "itkPNGImageIO.h"
#include "itkRGBPixel.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <cstdlib>
#include <functional>

namespace
{
using namespace itk::DelaunayRefinementTest;

constexpr double pi = 3.14159265358979323846;

/** Runs a program to its end; what it says goes to files in the folder. True if it ends well. */
bool
RunProgram(const std::string & program, const std::vector<std::string> & arguments, const TemporaryFolder & folder)
{
  std::string line = program;
  for (const std::string & argument : arguments)
  {
    line += " '" + argument + "'";
  }
  line += " > '" + (folder / "output") + "' 2> '" + (folder / "messages") + "'";
  return std::system(line.c_str()) == 0;
}

bool
RunExample(const std::string & name, const std::vector<std::string> & arguments, const TemporaryFolder & folder)
{
  return RunProgram(std::string("'") + EXAMPLES_FOLDER + "/" + name + "'", arguments, folder);
}

/** A cube of 24 voxels of 1 mm each, the first of them at the physical origin. */
std::string
WriteImage(const TemporaryFolder & folder, const std::function<double(const PointType &)> & valueAt)
{
  TestVolume<float> volume;
  for (int z = 0; z < volume.size[2]; ++z)
  {
    for (int y = 0; y < volume.size[1]; ++y)
    {
      for (int x = 0; x < volume.size[0]; ++x)
      {
        volume.At(x, y, z) =
          static_cast<float>(valueAt({ static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) }));
      }
    }
  }
  return WriteMetaImage(folder / "image.mha", volume);
}

/** Depth below the surface of a ball in the middle of the image. */
double
DepthInBall(const PointType & point, double radius)
{
  return radius - Distance(point, { 11.5, 11.5, 11.5 });
}

CheckedMesh
ReadMesh(const std::string & fileName)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkUnstructuredGrid * grid = reader->GetOutput();
  CheckedMesh           mesh;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double * point = grid->GetPoint(i);
    mesh.points.push_back({ point[0], point[1], point[2] });
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellPoints(i, ids);
    EXPECT_EQ(grid->GetCellType(i), VTK_TETRA);
    mesh.tetrahedra.push_back({ static_cast<std::uint32_t>(ids->GetId(0)),
                                static_cast<std::uint32_t>(ids->GetId(1)),
                                static_cast<std::uint32_t>(ids->GetId(2)),
                                static_cast<std::uint32_t>(ids->GetId(3)) });
  }
  mesh.triangles = ComputeBoundaryTriangles(mesh);
  return mesh;
}

/** The file has a mesh with all guarantees and about this volume. */
CheckedMesh
ExpectMesh(const std::string & fileName, double volume, double tolerance)
{
  CheckedMesh mesh = ReadMesh(fileName);
  ExpectGuarantees(mesh);
  EXPECT_NEAR(ComputeVolume(mesh) / volume, 1.0, tolerance);
  return mesh;
}

double
BallVolume(double radius)
{
  return 4.0 / 3.0 * pi * radius * radius * radius;
}
} // namespace

TEST(DelaunayRefinementExamples, ThresholdThenMesh)
{
  // The smaller ball is not the largest component.
  const TemporaryFolder folder;
  const std::string     image = WriteImage(folder, [](const PointType & point) {
    return std::max(DepthInBall(point, 8.0), 2.0 - Distance(point, { 2.0, 2.0, 2.0 }));
  });
  ASSERT_TRUE(RunExample("ThresholdThenMesh", { image, "0", "100", "1.5", folder / "mesh.vtu" }, folder))
    << ReadBytes(folder / "messages");
  ExpectMesh(folder / "mesh.vtu", BallVolume(8.0), 0.05);
}

TEST(DelaunayRefinementExamples, ConnectedThresholdThenMesh)
{
  const TemporaryFolder folder;
  const std::string     image = WriteImage(folder, [](const PointType & point) {
    return std::max(7.0 - Distance(point, { 8.0, 8.0, 8.0 }), 4.0 - Distance(point, { 18.0, 18.0, 18.0 }));
  });
  ASSERT_TRUE(
    RunExample("ConnectedThresholdThenMesh", { image, "18", "18", "18", "0", "100", "1", folder / "mesh.vtu" }, folder))
    << ReadBytes(folder / "messages");
  const CheckedMesh mesh = ExpectMesh(folder / "mesh.vtu", BallVolume(4.0), 0.12);
  EXPECT_LT(Distance(ComputeCentroid(mesh), { 18.0, 18.0, 18.0 }), 0.1);

  EXPECT_FALSE(RunExample(
    "ConnectedThresholdThenMesh", { image, "99", "18", "18", "0", "100", "1", folder / "none.vtu" }, folder));
  EXPECT_NE(ReadBytes(folder / "messages").find("seed"), std::string::npos);
}

TEST(DelaunayRefinementExamples, WatershedThenMesh)
{
  const TemporaryFolder folder;
  const std::string     image = WriteImage(
    folder, [](const PointType & point) { return 100.0 / (1.0 + std::exp(-3.0 * DepthInBall(point, 7.0))); });
  ASSERT_TRUE(
    RunExample("WatershedThenMesh", { image, "11.5", "11.5", "11.5", "0.2", "1.5", folder / "mesh.vtu" }, folder))
    << ReadBytes(folder / "messages");
  // The basin ends at the steepest voxels.
  const CheckedMesh mesh = ExpectMesh(folder / "mesh.vtu", BallVolume(7.0), 0.2);
  EXPECT_LT(Distance(ComputeCentroid(mesh), { 11.5, 11.5, 11.5 }), 0.5);
}

TEST(DelaunayRefinementExamples, MeshGreyImage)
{
  const TemporaryFolder folder;
  const std::string     image = WriteImage(folder, [](const PointType & point) { return DepthInBall(point, 10.0); });
  ASSERT_TRUE(RunExample("MeshGreyImage", { image, "2", "1.2", folder / "mesh.vtu", folder / "boundary.stl" }, folder))
    << ReadBytes(folder / "messages");
  const CheckedMesh mesh = ExpectMesh(folder / "mesh.vtu", BallVolume(8.0), 0.02);
  const double      farthest = ComputeMaximumDistance(
    SampleBoundary(mesh, 0.3), [](const PointType & point) { return std::abs(DepthInBall(point, 8.0)); });
  EXPECT_LT(farthest, 0.15);
  EXPECT_EQ(ReadBytes(folder / "boundary.stl").size(), 84 + 50 * mesh.triangles.size());
}

TEST(DelaunayRefinementExamples, MeshRegionOfInterest)
{
  const TemporaryFolder folder;
  const std::string     image = WriteImage(folder, [](const PointType & point) { return DepthInBall(point, 8.0); });
  ASSERT_TRUE(RunExample("MeshRegionOfInterest",
                         { image, "0", "0", "12", "24", "24", "12", "0", "1.2", "600", folder / "mesh.vtu" },
                         folder))
    << ReadBytes(folder / "messages");
  // The upper half, in its place.
  const CheckedMesh mesh = ExpectMesh(folder / "mesh.vtu", 0.5 * BallVolume(8.0), 0.06);
  const BoxType     bounds = ComputeBoundingBox(mesh.points);
  EXPECT_NEAR(bounds.minimum[2], 11.5, 0.1);
  EXPECT_NEAR(bounds.maximum[2], 19.5, 0.3);
  EXPECT_NE(ReadBytes(folder / "output").find(" %\n"), std::string::npos);

  EXPECT_FALSE(RunExample(
    "MeshRegionOfInterest", { image, "0", "0", "12", "24", "24", "12", "0", "1.2", "0", folder / "late.vtu" }, folder));
  EXPECT_NE(ReadBytes(folder / "messages").find("time is up"), std::string::npos);
  EXPECT_EQ(folder.List().count("late.vtu"), 0U);
}

#ifdef DRAW_MESH_COMMAND
TEST(DelaunayRefinementExamples, DrawMesh)
{
  const TemporaryFolder folder;
  const std::string     image = WriteImage(folder, [](const PointType & point) { return DepthInBall(point, 8.0); });
  ASSERT_TRUE(RunExample("ThresholdThenMesh", { image, "0", "100", "1.5", folder / "mesh.vtu" }, folder));
  ASSERT_TRUE(RunProgram(DRAW_MESH_COMMAND, { folder / "mesh.vtu", folder / "mesh.png" }, folder))
    << ReadBytes(folder / "messages");

  using PixelType = itk::RGBPixel<unsigned char>;
  auto reader = itk::ImageFileReader<itk::Image<PixelType, 2>>::New();
  reader->SetImageIO(itk::PNGImageIO::New());
  reader->SetFileName(folder / "mesh.png");
  reader->Update();
  std::size_t  numberOfFaces = 0;
  std::size_t  numberOfEdges = 0;
  const auto & pixels = *reader->GetOutput()->GetPixelContainer();
  for (std::size_t i = 0; i < pixels.Size(); ++i)
  {
    const PixelType & pixel = pixels[i];
    numberOfFaces += pixel.GetRed() > pixel.GetBlue() + 10 ? 1 : 0;
    numberOfEdges += pixel.GetRed() < 20 ? 1 : 0;
  }
  EXPECT_GT(numberOfFaces, pixels.Size() / 10);
  EXPECT_LT(numberOfFaces, pixels.Size() / 2);
  EXPECT_GT(numberOfEdges, pixels.Size() / 200);
}
#endif
