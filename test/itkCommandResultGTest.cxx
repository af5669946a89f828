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
#include "itkCommandRun.h"
#include "itkCommandTestImages.h"

#include <nlohmann/json.hpp>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace
{
using namespace itk::DelaunayRefinementTest;
using Json = nlohmann::json;

class CommandResult : public testing::Test
{
protected:
  /** Runs the command and returns its report. */
  template <typename TPixel>
  Json
  Run(const TestVolume<TPixel> & volume, std::vector<std::string> arguments)
  {
    const std::string image = WriteMetaImage(m_Folder / "image.mha", volume);
    arguments.insert(arguments.end(), { "--report", m_Report, image, m_Output });
    m_Run = RunCommand(arguments);
    ExpectSuccess(m_Run);
    const Json report = Json::parse(ReadBytes(m_Report), nullptr, false);
    EXPECT_FALSE(report.is_discarded());
    return report;
  }

  vtkUnstructuredGrid *
  ReadMesh()
  {
    m_Reader->SetFileName(m_Output.c_str());
    m_Reader->Modified();
    m_Reader->Update();
    return m_Reader->GetOutput();
  }

  /** Lowest and highest label of all tetrahedra. */
  std::array<double, 2>
  LabelRange()
  {
    std::array<double, 2> range{ { -1.0, -1.0 } };
    vtkDataArray *        labels = this->ReadMesh()->GetCellData()->GetArray("label");
    if (labels != nullptr)
    {
      labels->GetRange(range.data());
    }
    return range;
  }

  TemporaryFolder                      m_Folder;
  std::string                          m_Output = m_Folder / "mesh.vtu";
  std::string                          m_Report = m_Folder / "report.json";
  CommandRun                           m_Run;
  vtkNew<vtkXMLUnstructuredGridReader> m_Reader;
};

TEST_F(CommandResult, ReportAgreesWithTheFile)
{
  const Json report = this->Run(MakeBall(), { "--delta", "2", "--surface", m_Folder / "surface.stl" });
  const auto mesh = this->ReadMesh();
  EXPECT_EQ(report.at("points"), mesh->GetNumberOfPoints());
  EXPECT_EQ(report.at("tetrahedra"), mesh->GetNumberOfCells());
  EXPECT_GT(mesh->GetNumberOfCells(), 100);
  const std::size_t triangles = report.at("boundary_triangles");
  EXPECT_EQ(ReadBytes(m_Folder / "surface.stl").size(), 84 + 50 * triangles);
  EXPECT_EQ(report.at("delta"), 2.0);
  EXPECT_EQ(report.at("parameters").at("delta"), 2.0);
  EXPECT_EQ(report.at("output"), m_Output);
  EXPECT_EQ(report.at("version"), DelaunayRefinement_VERSION);
  EXPECT_EQ(report.at("termination"), "COMPLETED");
  EXPECT_EQ(report.at("components"), 1);
  EXPECT_EQ(report.at("missing_components"), Json::array());
  EXPECT_EQ(report.at("missing_labels"), Json::array());
  EXPECT_EQ(this->LabelRange(), (std::array<double, 2>{ { 1.0, 1.0 } }));
}

TEST_F(CommandResult, ReportHasTimesRulesAndQuality)
{
  const Json report = this->Run(MakeBall(), { "--delta", "2" });
  double     filterSeconds = 0.0;
  for (const char * phase : { "preparation", "sampling", "insertion", "refinement", "extraction", "copy" })
  {
    filterSeconds += report.at("seconds").at(phase).get<double>();
  }
  EXPECT_GT(filterSeconds, 0.0);
  EXPECT_LE(filterSeconds, report.at("filter_seconds"));
  for (const char * phase : { "reading", "measuring", "writing" })
  {
    EXPECT_GT(report.at("seconds").at(phase), 0.0) << phase;
  }

  for (const char * rule : { "R1", "R2", "R3", "R4", "R4'", "cell_size", "E1", "E2", "E3", "seeds", "removals" })
  {
    EXPECT_TRUE(report.at("rules").at(rule).is_number_unsigned()) << rule;
  }
  EXPECT_GT(report.at("rules").at("R1"), 0);

  const Json & quality = report.at("quality");
  EXPECT_LT(quality.at("radius_edge_ratio_max"), 2.0);
  EXPECT_GT(quality.at("boundary_angle_min"), 30.0);
  EXPECT_LT(quality.at("dihedral_angle_min"), 70.6);
  EXPECT_GT(quality.at("dihedral_angle_max"), 70.5);
  EXPECT_LT(quality.at("edge_min"), quality.at("edge_max"));
  std::size_t angles = 0;
  for (const std::size_t count : quality.at("dihedral_angle_histogram").at("counts"))
  {
    angles += count;
  }
  EXPECT_EQ(angles, 6 * report.at("tetrahedra").get<std::size_t>());
}

TEST_F(CommandResult, PeopleReadTheDeltaThatWasChosen)
{
  const Json report = this->Run(MakeBall(), {});
  EXPECT_GT(report.at("delta"), 0.0);
  EXPECT_TRUE(report.at("parameters").at("delta").is_null());
  EXPECT_NE(m_Run.output.find("(chosen from the image)"), std::string::npos) << m_Run.output;
  EXPECT_NE(m_Run.output.find(report.at("tetrahedra").dump() + " tetrahedra"), std::string::npos) << m_Run.output;
  EXPECT_NE(m_Run.output.find("170 to 180"), std::string::npos) << m_Run.output;
  EXPECT_EQ(m_Run.messages, "");
}

TEST_F(CommandResult, QuietSaysNothing)
{
  this->Run(MakeBall(), { "--delta", "4", "--quiet" });
  EXPECT_EQ(m_Run.output, "");
  EXPECT_EQ(m_Run.messages, "");
}

TEST_F(CommandResult, ProgressIsShownOnATerminal)
{
  const std::string    image = WriteMetaImage(m_Folder / "ball.mha", MakeBall());
  CommandCircumstances circumstances;
  circumstances.terminal = true;
  const CommandRun run = RunCommand({ "--delta", "1", image, m_Output }, circumstances);
  ExpectSuccess(run);
  for (const char * word : { "Reading", "Meshing", "Writing", " %" })
  {
    EXPECT_NE(run.messages.find(word), std::string::npos) << word << " is not in: " << run.messages;
  }
  // In the end the line is cleared.
  EXPECT_EQ(run.messages.substr(run.messages.size() - 4), "\r\033[K");
  EXPECT_EQ(RunCommand({ "--quiet", "--delta", "1", image, m_Output }, circumstances).messages, "");
}

TEST_F(CommandResult, LoweredDeltasAreReported)
{
  const Json   report = this->Run(MakeThreeBalls(), { "--delta", "6" });
  const Json & lowered = report.at("lowered_deltas");
  ASSERT_GE(lowered.size(), 2U);
  for (const Json & component : lowered)
  {
    EXPECT_GT(component.at("delta"), 0.0);
    EXPECT_LT(component.at("delta"), 6.0);
    EXPECT_EQ(component.at("volume"), component.at("voxels").get<double>());
    EXPECT_EQ(component.at("place").size(), 3U);
  }
  EXPECT_EQ(m_Run.messages.rfind("mesh-image: ", 0), 0U) << m_Run.messages;
  EXPECT_NE(m_Run.messages.find("--delta"), std::string::npos) << m_Run.messages;
  ASSERT_EQ(report.at("warnings").size(), 1U);
  EXPECT_EQ("mesh-image: " + report.at("warnings")[0].get<std::string>() + "\n", m_Run.messages);
}

TEST_F(CommandResult, Labels)
{
  const Json inner = this->Run(MakeNestedBalls(), { "--labels", "200", "--delta", "2" });
  EXPECT_EQ(this->LabelRange(), (std::array<double, 2>{ { 200.0, 200.0 } }));
  const Json merged = this->Run(MakeNestedBalls(), { "--merge-labels", "--delta", "2" });
  EXPECT_EQ(this->LabelRange(), (std::array<double, 2>{ { 1.0, 1.0 } }));
  const Json both = this->Run(MakeNestedBalls(), { "--labels", "3,200", "--merge-labels", "--delta", "2" });
  EXPECT_GT(merged.at("tetrahedra"), inner.at("tetrahedra"));
  EXPECT_EQ(merged.at("tetrahedra"), both.at("tetrahedra"));
}

TEST_F(CommandResult, TissuesShareTheirInterfaces)
{
  const Json report = this->Run(MakeNestedBalls(), { "--delta", "2", "--strict" });
  EXPECT_EQ(this->LabelRange(), (std::array<double, 2>{ { 3.0, 200.0 } }));
  EXPECT_EQ(report.at("labels"), Json({ 3, 200 }));
  EXPECT_EQ(report.at("missing_labels"), Json::array());
  const Json finer = this->Run(MakeNestedBalls(), { "--delta", "2", "--delta-for", "200=1" });
  EXPECT_GT(finer.at("tetrahedra"), report.at("tetrahedra"));
  EXPECT_EQ(finer.at("parameters").at("delta_for"), Json({ { 200, 1.0 } }));
  const Json smooth = this->Run(MakeNestedBalls(), { "--delta", "2", "--smoothing", "0.8" });
  EXPECT_EQ(smooth.at("parameters").at("smoothing"), 0.8);
  EXPECT_EQ(smooth.at("lowered_smoothings"), Json::array());
}

TEST_F(CommandResult, MissingLabelsAreNamed)
{
  // One voxel within the ball.
  TestVolume<std::uint8_t> volume;
  volume.AddBall({ { 11.5, 11.5, 11.5 } }, 9.0, 3);
  volume.AddBall({ { 11.0, 11.0, 11.0 } }, 0.5, 7);
  const Json report = this->Run(volume, { "--delta", "6" });
  ASSERT_EQ(this->LabelRange(), (std::array<double, 2>{ { 3.0, 3.0 } }));
  EXPECT_EQ(report.at("missing_labels"), Json({ 7 }));
  ASSERT_EQ(report.at("missing_components").size(), 1u);
  EXPECT_EQ(report.at("missing_components")[0].at("label"), 7);
  EXPECT_EQ(report.at("missing_components")[0].at("voxels"), 1);
}

TEST_F(CommandResult, FilledCavitiesAreNamed)
{
  TestVolume<std::uint8_t> volume;
  volume.AddBall({ { 11.5, 11.5, 11.5 } }, 9.0, 3);
  volume.AddBall({ { 11.0, 11.0, 11.0 } }, 0.5, 0);
  const Json report = this->Run(volume, { "--delta", "6" });
  EXPECT_EQ(report.at("cavities"), 1);
  ASSERT_EQ(report.at("missing_cavities").size(), 1u);
  EXPECT_EQ(report.at("missing_cavities")[0].at("voxels"), 1);
  EXPECT_EQ(report.at("missing_cavities")[0].at("place"), Json({ 11.0, 11.0, 11.0 }));
}

TEST_F(CommandResult, ThresholdsMayBeNegative)
{
  const Json ball = this->Run(MakeDistances(), { "--threshold", "-8", "--delta", "2" });
  EXPECT_EQ(this->LabelRange(), (std::array<double, 2>{ { 1.0, 1.0 } }));
  const Json shell = this->Run(MakeDistances(), { "--threshold", "-8,-4.5", "--delta", "2" });
  EXPECT_GT(shell.at("boundary_triangles"), ball.at("boundary_triangles"));
}

TEST_F(CommandResult, IsoValuesMayBeNegative)
{
  this->Run(MakeDistances(), { "--iso-value", "-8.25", "--delta", "1.5" });
  double bounds[6];
  this->ReadMesh()->GetBounds(bounds);
  EXPECT_NEAR(bounds[1] - bounds[0], 16.5, 0.5);
}

TEST_F(CommandResult, SizeOptions)
{
  const Json coarse = this->Run(MakeBall(), { "--delta", "4" });
  const Json fine = this->Run(MakeBall(), { "--delta", "1.5" });
  EXPECT_GT(fine.at("boundary_triangles"), 2 * coarse.at("boundary_triangles").get<int>());

  const Json dense = this->Run(MakeBall(), { "--delta", "4", "--cell-size", "1.5" });
  EXPECT_GT(dense.at("rules").at("cell_size"), 0);
  EXPECT_LE(dense.at("quality").at("edge_max"), 3.0);

  const Json round = this->Run(MakeBall(), { "--delta", "2", "--radius-edge-bound", "1.4" });
  EXPECT_LT(round.at("quality").at("radius_edge_ratio_max"), 1.4);
}

TEST_F(CommandResult, Slivers)
{
  EXPECT_LT(this->Run(MakeBall(), { "--delta", "2" }).at("quality").at("dihedral_angle_min"), 12.0);
  const Json mended = this->Run(MakeBall(), { "--delta", "2", "--min-dihedral", "12" });
  EXPECT_GE(mended.at("quality").at("dihedral_angle_min"), 12.0);
  EXPECT_EQ(mended.at("slivers"), Json::array());
  EXPECT_EQ(mended.at("rules").at("R4'"), 0);
  EXPECT_GT(mended.at("rules").at("sliver").get<int>() + mended.at("rules").at("moves").get<int>(), 0);
  EXPECT_GT(mended.at("seconds").at("slivers"), 0.0);

  const Json split = this->Run(MakeBall(), { "--delta", "2", "--min-dihedral", "12", "--paper-slivers" });
  EXPECT_GT(split.at("rules").at("R4'"), 0);
  EXPECT_EQ(split.at("rules").at("sliver"), 0);
  EXPECT_EQ(split.at("parameters").at("paper_slivers"), true);

  const Json left = this->Run(MakeBall(), { "--delta", "4", "--min-dihedral", "50" });
  ASSERT_FALSE(left.at("slivers").empty());
  EXPECT_NEAR(left.at("slivers").front().at("dihedral_angle").get<double>(),
              left.at("quality").at("dihedral_angle_min").get<double>(),
              1e-6);
  EXPECT_EQ(left.at("slivers").front().at("place").size(), 3u);
  EXPECT_NE(left.at("warnings").dump().find("--min-dihedral 50 degrees"), std::string::npos);
}

TEST_F(CommandResult, Components)
{
  EXPECT_EQ(this->Run(MakeThreeBalls(), { "--delta", "2" }).at("components"), 3);
  EXPECT_EQ(this->Run(MakeThreeBalls(), { "--delta", "2", "--min-component", "100" }).at("components"), 1);
  this->Run(MakeThreeBalls(), { "--delta", "2", "--largest-component" });
  double bounds[6];
  this->ReadMesh()->GetBounds(bounds);
  EXPECT_LT(bounds[1], 16.0);
}

TEST_F(CommandResult, Interpolators)
{
  const double linear = this->Run(MakeBall(), { "--delta", "1.5" }).at("points");
  const Json   nearest = this->Run(MakeBall(), { "--delta", "1.5", "--interpolator", "nearest" });
  EXPECT_EQ(nearest.at("parameters").at("interpolator"), "nearest");
  EXPECT_NE(nearest.at("points"), linear);
  const Json spline = this->Run(MakeDistances(), { "--iso-value", "-8", "--delta", "2", "--interpolator", "bspline" });
  EXPECT_EQ(spline.at("parameters").at("interpolator"), "bspline");
}

TEST_F(CommandResult, PixelTypes)
{
  const Json bytes = this->Run(MakeBall(), { "--delta", "2" });
  for (const int value : { 1, 1000 })
  {
    TestVolume<std::int16_t> shorts;
    shorts.AddBall({ { 11.5, 11.5, 11.5 } }, 8.0, static_cast<std::int16_t>(value));
    EXPECT_EQ(this->Run(shorts, { "--delta", "2" }).at("points"), bytes.at("points"));
  }
  TestVolume<std::int64_t> longs;
  longs.AddBall({ { 11.5, 11.5, 11.5 } }, 8.0, std::int64_t{ 1 } << 50);
  EXPECT_EQ(this->Run(longs, { "--labels", "1125899906842624", "--delta", "2" }).at("points"), bytes.at("points"));
  EXPECT_EQ(this->LabelRange()[0], 1125899906842624.0);
}

TEST_F(CommandResult, SurfaceFormats)
{
  for (const char * name : { "surface.vtp", "surface.vtk", "surface.stl", "surface.PLY" })
  {
    this->Run(MakeBall(), { "--delta", "2", "--surface", m_Folder / name });
    EXPECT_GT(std::filesystem::file_size(m_Folder / name), 1000U) << name;
  }
}

TEST_F(CommandResult, ReportHasDistancesAndTopology)
{
  const Json plain = this->Run(MakeBall(), { "--delta", "4" });
  EXPECT_TRUE(plain.at("mesh_topology").is_null());
  EXPECT_TRUE(plain.at("mesh_to_surface").is_null());
  TestVolume<std::uint8_t> hollow = MakeBall();
  hollow.At(11, 11, 11) = 0;
  const Json report = this->Run(hollow, { "--delta", "4", "--topology", "--hausdorff-bound", "1" });
  for (const char * const of : { "mesh_topology", "image_topology" })
  {
    EXPECT_EQ(report.at(of).at("components"), 1) << of;
    EXPECT_EQ(report.at(of).at("cavities"), 1) << of;
    EXPECT_EQ(report.at(of).at("genus"), 0) << of;
    EXPECT_EQ(report.at(of).at("euler_characteristic"), 4) << of;
  }
  EXPECT_LT(report.at("mesh_to_surface").at("distance"), 1.0);
  EXPECT_LT(report.at("surface_to_mesh").at("distance"), 1.0);
  EXPECT_NE(m_Run.output.find("1 cavities, genus 0"), std::string::npos) << m_Run.output;
}

TEST_F(CommandResult, SizesVary)
{
  const std::size_t coarse = this->Run(MakeBall(), { "--delta", "5" }).at("tetrahedra");
  const std::size_t bent = this->Run(MakeBall(), { "--delta-max", "5", "--delta-min", "1" }).at("tetrahedra");
  EXPECT_GT(bent, 2 * coarse);
  TestVolume<float> sizes;
  sizes.voxels.assign(sizes.voxels.size(), 5.0f);
  sizes.AddBall({ { 11.5, 11.5, 3.0 } }, 5.0, 1.0f);
  const std::string field = WriteMetaImage(m_Folder / "sizes.mha", sizes);
  const Json        report = this->Run(MakeBall(), { "--delta", "5", "--size-field", field });
  EXPECT_GT(report.at("tetrahedra"), 2 * coarse);
  EXPECT_EQ(report.at("parameters").at("size_field"), field);
}

TEST_F(CommandResult, TheSameBytesTwice)
{
  this->Run(MakeBall(), { "--delta", "2" });
  const std::string first = ReadBytes(m_Output);
  for (const char * const threads : { "1", "2", "5" })
  {
    this->Run(MakeBall(), { "--delta", "2", "--threads", threads });
    EXPECT_EQ(ReadBytes(m_Output), first) << threads;
  }
}
} // namespace
