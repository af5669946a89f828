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
#include "MeshImageStandardError.h"

#include <cstdio>

#ifdef _WIN32
#  include <io.h>
#else
#  include <fcntl.h>
#  include <unistd.h>
#endif

namespace meshimage
{
#ifdef _WIN32

void
KeepStandardError()
{}

void
PrintMessage(const std::string & text)
{
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

bool
MessagesGoToTerminal()
{
  return _isatty(_fileno(stderr)) != 0;
}

SilencedLibraries::SilencedLibraries() = default;
SilencedLibraries::~SilencedLibraries() = default;

#else

namespace
{
int kept = STDERR_FILENO;
}

void
KeepStandardError()
{
  const int copy = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
  if (copy >= 0)
  {
    kept = copy;
  }
}

void
PrintMessage(const std::string & text)
{
  for (std::size_t done = 0; done < text.size();)
  {
    const auto count = write(kept, text.data() + done, text.size() - done);
    if (count < 0)
    {
      return;
    }
    done += static_cast<std::size_t>(count);
  }
}

bool
MessagesGoToTerminal()
{
  return isatty(kept) != 0;
}

SilencedLibraries::SilencedLibraries()
{
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0)
  {
    std::fflush(stderr);
    dup2(nothing, STDERR_FILENO);
    close(nothing);
  }
}

SilencedLibraries::~SilencedLibraries()
{
  std::fflush(stderr);
  if (kept != STDERR_FILENO)
  {
    dup2(kept, STDERR_FILENO);
  }
}

#endif
} // namespace meshimage
