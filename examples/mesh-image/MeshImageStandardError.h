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
#ifndef MeshImageStandardError_h
#define MeshImageStandardError_h

#include <string>

namespace meshimage
{
/** Standard error as it was when the program started. To be called once before any message. */
void
KeepStandardError();

/** Prints to it, from any thread. */
void
PrintMessage(const std::string & text);

bool
MessagesGoToTerminal();

/** \class SilencedLibraries
 * \brief While one of these lives, what libraries print to standard error is lost. Readers of images print what they
 * throw as well, in words for programmers. */
class SilencedLibraries
{
public:
  SilencedLibraries();
  SilencedLibraries(const SilencedLibraries &) = delete;
  SilencedLibraries &
  operator=(const SilencedLibraries &) = delete;
  ~SilencedLibraries();
};
} // namespace meshimage

#endif
