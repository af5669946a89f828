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
#ifndef MeshImageProgressBar_h
#define MeshImageProgressBar_h

#include <chrono>
#include <mutex>

namespace meshimage
{
/** \class ProgressBar
 * \brief A line on standard error, redrawn a few times a second. */
class ProgressBar
{
public:
  /** Until then nothing is shown, and never if standard error is no terminal. */
  void
  EnableOnTerminal();

  void
  Show(const char * what, double share);

  /** Removes the line, also from another thread. */
  void
  Clear();

private:
  std::mutex                            m_Mutex;
  bool                                  m_Enabled{ false };
  bool                                  m_Shown{ false };
  const char *                          m_What{ nullptr };
  std::chrono::steady_clock::time_point m_LastTime{};
};
} // namespace meshimage

#endif
