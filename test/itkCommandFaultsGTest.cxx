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

#include <map>

namespace
{
using namespace itk::DelaunayRefinementTest;

class CommandFaults : public testing::Test
{
protected:
  /** All outputs at once. */
  std::vector<std::string>
  Arguments(const std::string & delta) const
  {
    return { "--quiet",
             "--delta",
             delta,
             "--surface",
             m_Folder / "surface.vtk",
             "--report",
             m_Folder / "report.json",
             m_Image,
             m_Folder / "mesh.vtu" };
  }

  const std::set<std::string> m_Inputs{ "ball.mha" };
  const std::set<std::string> m_All{ "ball.mha", "mesh.vtu", "report.json", "surface.vtk" };

  TemporaryFolder m_Folder;
  std::string     m_Image = WriteMetaImage(m_Folder / "ball.mha", MakeBall());
};

TEST_F(CommandFaults, MissingFolders)
{
  const std::string mesh = m_Folder / "mesh.vtu";
  ExpectRefusal(RunCommand({ m_Image, m_Folder / "nowhere/mesh.vtu" }), 1, { m_Folder / "nowhere" });
  ExpectRefusal(RunCommand({ "--report", m_Folder / "none/r.json", m_Image, mesh }), 1, { m_Folder / "none" });
  ExpectRefusal(RunCommand({ "--surface", m_Folder / "not/s.stl", m_Image, mesh }), 1, { m_Folder / "not" });
  EXPECT_EQ(m_Folder.List(), m_Inputs);
}

TEST_F(CommandFaults, MissingFoldersAreSeenBeforeMeshing)
{
  // Otherwise this would run into the bound on memory.
  ExpectRefusal(RunCommand({ "--delta", "0.0001", m_Image, m_Folder / "nowhere/mesh.vtu" }), 1, { "nowhere" });
}

TEST_F(CommandFaults, FoldersInPlaceOfFiles)
{
  std::filesystem::create_directory(m_Folder / "mesh.vtu");
  ExpectRefusal(RunCommand({ m_Image, m_Folder / "mesh.vtu" }), 1, { m_Folder / "mesh.vtu" });
  ExpectRefusal(RunCommand({ "--report", "/dev/null", m_Image, m_Folder / "mesh.vtk" }), 1, { "/dev/null" });
  EXPECT_TRUE(std::filesystem::is_directory(m_Folder / "mesh.vtu"));
}

TEST_F(CommandFaults, ADiskThatIsFull)
{
  ASSERT_EQ(RunCommand(this->Arguments("2")).code, 0);
  EXPECT_EQ(m_Folder.List(), m_All);
  std::map<std::string, std::string> before;
  std::set<std::size_t>              sizes;
  for (const char * name : { "mesh.vtu", "surface.vtk", "report.json" })
  {
    before[name] = ReadBytes(m_Folder / name);
    sizes.insert(before[name].size());
  }
  // A limit between two sizes stops another file than one below them all.
  for (const std::size_t size : sizes)
  {
    CommandCircumstances fullDisk;
    fullDisk.largestFile = size - 100;
    ExpectRefusal(RunCommand(this->Arguments("2"), fullDisk), 1, { "cannot be written", m_Folder / "" });
    EXPECT_EQ(m_Folder.List(), m_All);
    for (const auto & [name, bytes] : before)
    {
      EXPECT_EQ(ReadBytes(m_Folder / name), bytes) << name << " was changed";
      std::filesystem::remove(m_Folder / name);
    }
    ExpectRefusal(RunCommand(this->Arguments("2"), fullDisk), 1, { "cannot be written" });
    EXPECT_EQ(m_Folder.List(), m_Inputs);
    for (const auto & [name, bytes] : before)
    {
      WriteBytes(m_Folder / name, bytes);
    }
  }
}

TEST_F(CommandFaults, InterruptsEndARunWithinASecond)
{
  for (const int signal : { SIGINT, SIGTERM })
  {
    CommandCircumstances interrupt;
    interrupt.signal = signal;
    interrupt.milliseconds = 1000;
    const CommandRun run = RunCommand(this->Arguments("0.05"), interrupt);
    ExpectRefusal(run, 1, { "interrupted" });
    EXPECT_LT(run.secondsAfterSignal, 1.0);
    EXPECT_EQ(m_Folder.List(), m_Inputs);
  }
}

TEST_F(CommandFaults, InterruptsLeaveAllOrNothing)
{
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(RunCommand(this->Arguments("0.5")).code, 0);
  const auto whole = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  for (int percent = 40; percent <= 110; percent += 2)
  {
    for (const char * name : { "mesh.vtu", "surface.vtk", "report.json" })
    {
      std::filesystem::remove(m_Folder / name);
    }
    CommandCircumstances interrupt;
    interrupt.signal = SIGINT;
    interrupt.milliseconds = static_cast<int>(whole * percent / 100);
    const CommandRun run = RunCommand(this->Arguments("0.5"), interrupt);
    EXPECT_EQ(m_Folder.List(), run.code == 0 ? m_All : m_Inputs) << run.messages;
    // On a busy machine the signal may come while the program is still being loaded, and end it.
    constexpr int endedBySignal = -1;
    EXPECT_TRUE(run.code == 0 || run.code == 1 || (run.code == endedBySignal && run.messages.empty())) << run.code;
    EXPECT_LT(run.secondsAfterSignal, 1.0);
  }
}
} // namespace
