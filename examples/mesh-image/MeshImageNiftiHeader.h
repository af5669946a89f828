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
#ifndef MeshImageNiftiHeader_h
#define MeshImageNiftiHeader_h

#include <cstdint>
#include <string>

namespace meshimage
{
/** Where the voxels of a NIfTI or Analyze image are. */
struct NiftiHeader
{
  bool          valid{ false };
  std::string   dataFile;
  std::uint64_t dataOffset{ 0 };
  std::uint64_t dataSize{ 0 };
};

NiftiHeader
ReadNiftiHeader(const std::string & fileName);
} // namespace meshimage

#endif
