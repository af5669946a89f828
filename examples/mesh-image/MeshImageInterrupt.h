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
#ifndef MeshImageInterrupt_h
#define MeshImageInterrupt_h

#include <functional>

namespace meshimage
{
/** From now on SIGINT and SIGTERM end the program with exit code 1 and a sentence, whatever it is doing: a thread of
 * its own waits for them. \c prepare is called first, in that thread; it cleans up, or returns false if the work is
 * done and the signal came too late. To be called once, before any other thread is started. */
void
EndOnInterrupt(std::function<bool()> prepare);

/** Does not return while an interrupt is being handled, as the program then ends there. To be called before anything is
 * said about a failure, which may come of the cleaning up. */
void
WaitForInterrupt();
} // namespace meshimage

#endif
