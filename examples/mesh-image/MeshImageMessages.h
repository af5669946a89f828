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
#ifndef MeshImageMessages_h
#define MeshImageMessages_h

#include "itkMacro.h"

#include <string>

namespace meshimage
{
/** What an exception of ITK says, without the place in the source and without line breaks. */
std::string
PlainMessage(const itk::ExceptionObject & error);

/** The filter's words for its parameters turned into the options of the command: "Delta" into "--delta". */
std::string
InWordsOfOptions(const std::string & message);
} // namespace meshimage

#endif
