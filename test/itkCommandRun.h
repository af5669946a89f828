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
#ifndef itkCommandRun_h
#define itkCommandRun_h

#include "itkTemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace itk::DelaunayRefinementTest
{
/** \class CommandRun
 * \brief How a run of mesh-image ended.
 */
struct CommandRun
{
  /** Exit code; -1 if a signal ended it. */
  int         code{ -1 };
  std::string output;
  std::string messages;
  double      secondsAfterSignal{ 0.0 };
};

/** \class CommandCircumstances
 * \brief What happens to a run from outside.
 */
struct CommandCircumstances
{
  /** This signal, if any, is sent after so many milliseconds. */
  int signal{ 0 };
  int milliseconds{ 0 };

  /** Standard error is a terminal. */
  bool terminal{ false };

  /** No file may become larger, as on a full disk. 0: no limit. */
  rlim_t largestFile{ 0 };
};

/** \class PseudoTerminal
 * \brief A terminal without a screen.
 */
class PseudoTerminal
{
public:
  PseudoTerminal()
    : m_Master(posix_openpt(O_RDWR | O_NOCTTY))
  {
    grantpt(m_Master);
    unlockpt(m_Master);
    m_Slave = open(ptsname(m_Master), O_RDWR | O_NOCTTY);
  }

  PseudoTerminal(const PseudoTerminal &) = delete;
  PseudoTerminal &
  operator=(const PseudoTerminal &) = delete;

  ~PseudoTerminal()
  {
    close(m_Master);
    close(m_Slave);
  }

  int
  GetSlave() const
  {
    return m_Slave;
  }

  /** All that was written to it; it keeps a few thousand bytes. */
  std::string
  Read() const
  {
    std::string text(65536, '\0');
    fcntl(m_Master, F_SETFL, O_NONBLOCK);
    const auto count = read(m_Master, text.data(), text.size());
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
  }

private:
  int m_Master;
  int m_Slave;
};

/** Runs mesh-image to its end. */
inline CommandRun
RunCommand(const std::vector<std::string> & arguments, const CommandCircumstances & circumstances = {})
{
  const TemporaryFolder folder;
  const std::string     outputFile = folder / "output";
  const std::string     messageFile = folder / "messages";

  std::vector<char *> argv{ const_cast<char *>(MESH_IMAGE_COMMAND) };
  for (const std::string & argument : arguments)
  {
    argv.push_back(const_cast<char *>(argument.c_str()));
  }
  argv.push_back(nullptr);

  const PseudoTerminal terminal;
  const pid_t          child = fork();
  if (child == 0)
  {
    constexpr int notStarted = 127;
    constexpr int mode = 0600;
    dup2(open(outputFile.c_str(), O_WRONLY | O_CREAT, mode), STDOUT_FILENO);
    dup2(circumstances.terminal ? terminal.GetSlave() : open(messageFile.c_str(), O_WRONLY | O_CREAT, mode),
         STDERR_FILENO);
    if (circumstances.largestFile > 0)
    {
      const rlimit limit{ circumstances.largestFile, circumstances.largestFile };
      std::signal(SIGXFSZ, SIG_IGN);
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    execv(argv[0], argv.data());
    _exit(notStarted);
  }

  auto start = std::chrono::steady_clock::now();
  if (circumstances.signal != 0)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(circumstances.milliseconds));
    start = std::chrono::steady_clock::now();
    kill(child, circumstances.signal);
  }
  int status = 0;
  waitpid(child, &status, 0);

  CommandRun run;
  run.secondsAfterSignal = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.output = ReadBytes(outputFile);
  run.messages = circumstances.terminal ? terminal.Read() : ReadBytes(messageFile);
  return run;
}

/** The run must have refused with this code and one sentence that has all these words. */
inline void
ExpectRefusal(const CommandRun & run, int code, const std::vector<std::string> & words)
{
  EXPECT_EQ(run.code, code) << run.messages;
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(run.messages.rfind("mesh-image: ", 0), 0U) << run.messages;
  EXPECT_EQ(std::count(run.messages.begin(), run.messages.end(), '\n'), 1) << run.messages;
  for (const std::string & word : words)
  {
    EXPECT_NE(run.messages.find(word), std::string::npos) << word << " is not in: " << run.messages;
  }
}

inline void
ExpectSuccess(const CommandRun & run)
{
  EXPECT_EQ(run.code, 0) << run.messages;
}
} // namespace itk::DelaunayRefinementTest

#endif
