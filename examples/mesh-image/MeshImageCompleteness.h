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
#ifndef MeshImageCompleteness_h
#define MeshImageCompleteness_h

#include "itkImageIOBase.h"

#include <string>

namespace meshimage
{
/** Throws a RunError if the file, or the data file that it names, holds fewer bytes than its header promises, in the
 * formats where ITK would fill the rest with whatever is in memory: MetaImage, NIfTI and Analyze, VTK, GIPL, MRC, TIFF.
 * Readers of the other formats find that out themselves. */
void
RequireCompleteFile(const itk::ImageIOBase & io, const std::string & fileName);
} // namespace meshimage

#endif
