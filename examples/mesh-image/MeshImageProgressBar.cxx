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
#include "MeshImageProgressBar.h"

#include <algorithm>
#include <cstdio>
#include <string>

#ifdef _WIN32
#  include <io.h>
#else
#  include <unistd.h>
#endif

namespace meshimage
{
namespace
{
bool
StandardErrorIsTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}
} // namespace

ProgressBar::ProgressBar(bool quiet)
  : m_Enabled(!quiet && StandardErrorIsTerminal())
{}

void
ProgressBar::Show(const char * what, double share)
{
  constexpr auto pause = std::chrono::milliseconds(100);
  constexpr int  width = 40;

  const std::lock_guard<std::mutex> lock(m_Mutex);
  const auto                        now = std::chrono::steady_clock::now();
  if (!m_Enabled || (what == m_What && now - m_LastTime < pause))
  {
    return;
  }
  m_What = what;
  m_LastTime = now;
  m_Shown = true;
  const double      clamped = std::clamp(share, 0.0, 1.0);
  const std::string done(static_cast<std::size_t>(clamped * width), '#');
  std::fprintf(stderr, "\r\033[K%-8s [%-*s] %3.0f %%", what, width, done.c_str(), 100.0 * clamped);
  std::fflush(stderr);
}

void
ProgressBar::Clear()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  if (m_Shown)
  {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    m_Shown = false;
  }
}
} // namespace meshimage
