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

namespace
{
using namespace itk::DelaunayRefinementTest;

/** Arguments before IMAGE and OUTPUT, and words that the refusal must have. */
struct BadUsage
{
  std::vector<std::string> arguments;
  std::vector<std::string> words;
};

class CommandUsage : public testing::TestWithParam<BadUsage>
{
protected:
  TemporaryFolder m_Folder;
  std::string     m_Image = WriteMetaImage(m_Folder / "ball.mha", MakeBall());
  std::string     m_Output = m_Folder / "mesh.vtu";
};

TEST_P(CommandUsage, IsRefused)
{
  std::vector<std::string> arguments = GetParam().arguments;
  arguments.push_back(m_Image);
  arguments.push_back(m_Output);
  ExpectRefusal(RunCommand(arguments), 2, GetParam().words);
  EXPECT_EQ(m_Folder.List(), std::set<std::string>{ "ball.mha" });
}

INSTANTIATE_TEST_SUITE_P(Delta,
                         CommandUsage,
                         testing::Values(BadUsage{ { "--delta", "0" }, { "--delta", "positive" } },
                                         BadUsage{ { "--delta", "-1" }, { "--delta", "'-1'" } },
                                         BadUsage{ { "--delta", "nan" }, { "--delta" } },
                                         BadUsage{ { "--delta", "inf" }, { "--delta" } },
                                         BadUsage{ { "--delta", "1e999" }, { "--delta" } },
                                         BadUsage{ { "--delta", "fine" }, { "--delta", "number", "'fine'" } },
                                         BadUsage{ { "--delta", "2mm" }, { "--delta", "'2mm'" } },
                                         BadUsage{ { "--delta", "" }, { "--delta" } },
                                         BadUsage{ { "--delta", "1", "--delta", "2" }, { "--delta" } }));

INSTANTIATE_TEST_SUITE_P(Sizes,
                         CommandUsage,
                         testing::Values(BadUsage{ { "--cell-size", "0" }, { "--cell-size" } },
                                         BadUsage{ { "--cell-size", "nan" }, { "--cell-size" } },
                                         BadUsage{ { "--radius-edge-bound", "0.99" }, { "--radius-edge-bound", "1" } },
                                         BadUsage{ { "--radius-edge-bound", "inf" }, { "--radius-edge-bound" } },
                                         BadUsage{ { "--radius-edge-bound", "nan" }, { "--radius-edge-bound" } },
                                         BadUsage{ { "--min-dihedral", "60" }, { "--min-dihedral" } },
                                         BadUsage{ { "--min-dihedral", "-1" }, { "--min-dihedral" } },
                                         BadUsage{ { "--min-dihedral", "nan" }, { "--min-dihedral" } },
                                         BadUsage{ { "--max-vertices", "0" }, { "--max-vertices" } },
                                         BadUsage{ { "--max-vertices", "1.5" }, { "--max-vertices" } },
                                         BadUsage{ { "--max-vertices", "-4" }, { "--max-vertices" } }));

INSTANTIATE_TEST_SUITE_P(
  Object,
  CommandUsage,
  testing::Values(BadUsage{ { "--iso-value", "high" }, { "--iso-value" } },
                  BadUsage{ { "--iso-value", "-inf" }, { "--iso-value", "finite" } },
                  BadUsage{ { "--threshold", "5,-1" }, { "--threshold", "LOWER" } },
                  BadUsage{ { "--threshold", "nan" }, { "--threshold" } },
                  BadUsage{ { "--threshold", "1,2,3" }, { "--threshold" } },
                  BadUsage{ { "--threshold", "1," }, { "--threshold" } },
                  BadUsage{ { "--threshold", "-inf,inf" }, { "--threshold", "finite" } },
                  BadUsage{ { "--labels", "-1" }, { "--labels", "positive", "'-1'" } },
                  BadUsage{ { "--labels", "0" }, { "--labels", "background" } },
                  BadUsage{ { "--labels", "1,,2" }, { "--labels" } },
                  BadUsage{ { "--labels", "1.5" }, { "--labels" } },
                  BadUsage{ { "--labels", "one" }, { "--labels" } },
                  BadUsage{ { "--labels", "18446744073709551616" }, { "--labels" } },
                  BadUsage{ { "--iso-value", "1", "--labels", "1" }, { "--iso-value", "--labels" } },
                  BadUsage{ { "--delta", "1", "--delta-max", "1" }, { "--delta", "--delta-max" } },
                  BadUsage{ { "--delta-min", "0" }, { "--delta-min" } },
                  BadUsage{ { "--iso-value", "1", "--threshold", "1" }, { "--iso-value", "--threshold" } },
                  BadUsage{ { "--iso-value", "1", "--merge-labels" }, { "--iso-value", "--merge-labels" } },
                  BadUsage{ { "--threshold", "1", "--labels", "1" }, { "--threshold", "--labels" } },
                  BadUsage{ { "--threshold", "1", "--merge-labels" }, { "--threshold", "--merge-labels" } }));

INSTANTIATE_TEST_SUITE_P(TheRest,
                         CommandUsage,
                         testing::Values(BadUsage{ { "--min-component", "0" }, { "--min-component" } },
                                         BadUsage{ { "--interpolator", "cubic" }, { "--interpolator", "bspline" } },
                                         BadUsage{ { "--surface", "s.obj" }, { "--surface", ".vtp", ".stl", ".ply" } },
                                         BadUsage{ { "--threads", "0" }, { "--threads" } },
                                         BadUsage{ { "--threads", "many" }, { "--threads" } },
                                         BadUsage{ { "--frobnicate" }, { "--frobnicate" } },
                                         BadUsage{ { "second-image.mha" }, { "OUTPUT" } }));

TEST_F(CommandUsage, NeedsTwoNames)
{
  ExpectRefusal(RunCommand({}), 2, { "IMAGE", "required" });
  ExpectRefusal(RunCommand({ m_Image }), 2, { "OUTPUT", "required" });
  ExpectRefusal(RunCommand({ m_Image, m_Output, "more" }), 2, { "more" });
}

TEST_F(CommandUsage, NeedsAKnownKindOfOutput)
{
  for (const char * name : { "mesh.docx", "mesh", ".vtu", "mesh.vtu.gz", "mesh.stl" })
  {
    ExpectRefusal(RunCommand({ m_Image, m_Folder / name }), 2, { ".vtk", ".vtu", name });
  }
}

TEST_F(CommandUsage, NeedsDifferentNames)
{
  const std::string same = m_Folder / "./mesh.vtk";
  ExpectRefusal(RunCommand({ "--surface", same, m_Image, m_Folder / "mesh.vtk" }), 2, { "OUTPUT", "--surface" });
  ExpectRefusal(RunCommand({ "--report", m_Output, m_Image, m_Output }), 2, { "OUTPUT", "--report" });
  ExpectRefusal(RunCommand({ "--report", m_Image, m_Image, m_Output }), 2, { "IMAGE", "--report" });
  EXPECT_EQ(ReadBytes(m_Image), MetaHeader(MakeBall(), "LOCAL") + MakeBall().Bytes());
}

TEST_F(CommandUsage, ShowsHelpAndVersion)
{
  const CommandRun help = RunCommand({ "--help" });
  ExpectSuccess(help);
  EXPECT_EQ(help.messages, "");
  for (const char * option : { "--iso-value",
                               "--threshold",
                               "--labels",
                               "--merge-labels",
                               "--delta",
                               "--cell-size",
                               "--min-dihedral",
                               "--paper-slivers",
                               "--radius-edge-bound",
                               "--max-vertices",
                               "--interpolator",
                               "--min-component",
                               "--largest-component",
                               "--surface",
                               "--report",
                               "--threads",
                               "--quiet",
                               "--version",
                               "--help",
                               "IMAGE",
                               "OUTPUT",
                               "--refine-outside",
                               "--hausdorff-bound",
                               "--topology",
                               "--size-field",
                               "--delta-min",
                               "--delta-max",
                               "--allow-non-manifold" })
  {
    EXPECT_NE(help.output.find(option), std::string::npos) << option;
  }
  const CommandRun version = RunCommand({ "--version" });
  ExpectSuccess(version);
  EXPECT_EQ(version.output, "mesh-image " DelaunayRefinement_VERSION "\n");
}
} // namespace
