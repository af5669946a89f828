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
#include "MeshImageInterrupt.h"

#ifdef _WIN32

namespace meshimage
{
void
EndOnInterrupt(std::function<bool()>)
{
  // The system ends the program by itself.
}

void
WaitForInterrupt()
{}
} // namespace meshimage

#else

#  include "MeshImageStandardError.h"

#  include <atomic>
#  include <chrono>
#  include <csignal>
#  include <cstdlib>
#  include <thread>
#  include <unistd.h>

namespace meshimage
{
namespace
{
std::atomic<bool> underWay{ false };
}

void
EndOnInterrupt(std::function<bool()> prepare)
{
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : { SIGINT, SIGTERM })
  {
    // Shells let programs in the background ignore SIGINT, and ignored signals reach no one.
    std::signal(number, SIG_DFL);
    sigaddset(&signals, number);
  }
  // All threads inherit this, so that the signals come to the one that waits for them.
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, prepare = std::move(prepare)] {
    do
    {
      underWay = false;
      int number = 0;
      sigwait(&signals, &number);
      underWay = true;
    } while (!prepare());
    PrintMessage("mesh-image: interrupted, nothing was written\n");
    _exit(EXIT_FAILURE);
  }).detach();
}

void
WaitForInterrupt()
{
  while (underWay)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}
} // namespace meshimage

#endif
