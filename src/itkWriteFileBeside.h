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
#ifndef itkWriteFileBeside_h
#define itkWriteFileBeside_h

#include <functional>
#include <string>

namespace itk
{
/** Writes the bytes to another name in the same folder and renames that when all is on the disk, so that the file is
 * never there half-written. \c progress as in TetrahedralMeshFile, from 0 to 1. Throws std::runtime_error with a
 * sentence that names the file; neither that nor a stop leaves anything behind.
 * \retval false if \c progress returned false. */
bool
WriteFileBeside(const std::string & fileName, const std::string & bytes, const std::function<bool(double)> & progress);
} // end namespace itk

#endif
