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

#include "MeshImageStandardError.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace meshimage
{
void
ProgressBar::EnableOnTerminal()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  m_Enabled = MessagesGoToTerminal();
}

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
  const double       clamped = std::clamp(share, 0.0, 1.0);
  const std::string  done(static_cast<std::size_t>(clamped * width), '#');
  std::ostringstream line;
  line << "\r\033[K" << std::left << std::setw(10) << what << "[" << std::setw(width) << done << "] " << std::right
       << std::setw(3) << std::lround(100.0 * clamped) << " %";
  PrintMessage(line.str());
}

void
ProgressBar::Clear()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  if (m_Shown)
  {
    PrintMessage("\r\033[K");
    m_Shown = false;
  }
}
} // namespace meshimage
