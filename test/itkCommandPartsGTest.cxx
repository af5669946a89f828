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
#include "MeshImageMessages.h"
#include "MeshImageQuality.h"

#include "itkWriterTestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace itk::DelaunayRefinementTest;
using meshimage::InWordsOfOptions;
using meshimage::MeasureQuality;
using meshimage::MeshType;
using meshimage::Quality;

/** A mesh of one tetrahedron or triangle. */
template <typename TCell>
MeshType::Pointer
MakeCell(const std::vector<std::array<double, 3>> & corners)
{
  const auto                       mesh = MeshType::New();
  std::vector<itk::IdentifierType> ids;
  for (const auto & corner : corners)
  {
    mesh->SetPoint(ids.size(), MeshType::PointType(corner.data()));
    ids.push_back(ids.size());
  }
  AddCell<TCell>(mesh.GetPointer(), 0, ids);
  return mesh;
}

Quality
MeasureCells(const std::vector<std::array<double, 3>> & tetrahedron,
             const std::vector<std::array<double, 3>> & triangle)
{
  const auto mesh = MakeCell<itk::TetrahedronCell<MeshType::CellType>>(tetrahedron);
  const auto boundary = MakeCell<itk::TriangleCell<MeshType::CellType>>(triangle);
  return MeasureQuality(*mesh, *boundary);
}

TEST(MeshImageQuality, RegularTetrahedron)
{
  // Every other corner of a cube with edges of length 2.
  const Quality quality =
    MeasureCells({ { 0, 0, 0 }, { 2, 2, 0 }, { 2, 0, 2 }, { 0, 2, 2 } }, { { 0, 0, 0 }, { 2, 2, 0 }, { 2, 0, 2 } });
  EXPECT_NEAR(quality.radiusEdgeRatioMaximum, std::sqrt(3.0 / 8.0), 1e-12);
  EXPECT_NEAR(quality.dihedralAngleMinimum, 70.528779365509308, 1e-10);
  EXPECT_NEAR(quality.dihedralAngleMaximum, 70.528779365509308, 1e-10);
  EXPECT_NEAR(quality.boundaryAngleMinimum, 60.0, 1e-10);
  EXPECT_NEAR(quality.edgeMinimum, std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(quality.edgeMaximum, std::sqrt(8.0), 1e-12);
  EXPECT_EQ(quality.dihedralAngleHistogram[7], 6U);
}

TEST(MeshImageQuality, CornerOfABox)
{
  const Quality quality =
    MeasureCells({ { 5, 5, 5 }, { 8, 5, 5 }, { 5, 9, 5 }, { 5, 5, 17 } }, { { 5, 5, 5 }, { 8, 5, 5 }, { 5, 9, 5 } });
  EXPECT_NEAR(quality.radiusEdgeRatioMaximum, 6.5 / 3.0, 1e-12);
  EXPECT_NEAR(quality.dihedralAngleMaximum, 90.0, 1e-10);
  // The slanted face has the normal (1/3, 1/4, 1/12).
  const double length = std::sqrt(1.0 / 9.0 + 1.0 / 16.0 + 1.0 / 144.0);
  EXPECT_NEAR(quality.dihedralAngleMinimum, std::acos(1.0 / 3.0 / length) * 180.0 / std::acos(-1.0), 1e-10);
  EXPECT_NEAR(quality.boundaryAngleMinimum, std::atan(0.75) * 180.0 / std::acos(-1.0), 1e-10);
  EXPECT_EQ(quality.edgeMinimum, 3.0);
  EXPECT_NEAR(quality.edgeMaximum, std::sqrt(160.0), 1e-12);
}

TEST(MeshImageQuality, NearlyFlatTetrahedron)
{
  const double  height = 1e-9;
  const Quality quality = MeasureCells({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, height }, { 0, 1, height } },
                                       { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } });
  // Opposite edges lie 1e-9 apart: the angle at the other four is about that over half the length of an edge.
  EXPECT_GT(quality.dihedralAngleMinimum, 0.0);
  EXPECT_LT(quality.dihedralAngleMinimum, 2e-7);
  EXPECT_LT(quality.dihedralAngleMaximum, 180.0);
  EXPECT_GT(quality.dihedralAngleMaximum, 180.0 - 1e-6);
  EXPECT_EQ(quality.dihedralAngleHistogram[0] + quality.dihedralAngleHistogram[17], 6U);
}

TEST(MeshImageMessages, LoseTheirOrigin)
{
  itk::ExceptionObject error("file.cxx", 12);
  for (const char * prefix :
       { "", "itk::ERROR: ", "ITK ERROR: ", "itk::ERROR: Filter(0x55d0c8): ", "ITK ERROR: Filter(0x55d0c8): " })
  {
    error.SetDescription(std::string(prefix) + "The image\n  has no voxels.\n");
    EXPECT_EQ(meshimage::PlainMessage(error), "The image has no voxels") << prefix;
  }
}

TEST(MeshImageMessages, SpeakOfOptions)
{
  EXPECT_EQ(InWordsOfOptions("Set IsoValue, LowerThreshold or UpperThreshold"), "Set --iso-value, --threshold");
  EXPECT_EQ(InWordsOfOptions("UpperThreshold 3 is below LowerThreshold 4"), "--threshold 3 is below --threshold 4");
  EXPECT_EQ(InWordsOfOptions("choose Labels, or MergeLabels"), "choose --labels, or --merge-labels");
  EXPECT_EQ(InWordsOfOptions("Delta (0.1)"), "--delta (0.1)");
  EXPECT_EQ(InWordsOfOptions("MaximumNumberOfVertices, which is 7"), "--max-vertices, which is 7");
  EXPECT_EQ(InWordsOfOptions("MinimumComponentSize, CellSize, RadiusEdgeRatioBound, MinimumDihedralAngle"),
            "--min-component, --cell-size, --radius-edge-bound, --min-dihedral");
  EXPECT_EQ(InWordsOfOptions("EffectiveDelta and DeltaX stay"), "EffectiveDelta and DeltaX stay");
}
} // namespace
