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
#ifndef MeshImageTypes_h
#define MeshImageTypes_h

#include "itkDefaultStaticMeshTraits.h"
#include "itkMesh.h"

#include <cstdint>
#include <stdexcept>

namespace meshimage
{
/** Coordinates in double precision; cell data that hold any label. */
using MeshType = itk::Mesh<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double, double, std::uint64_t>>;

/** \class RunError
 * \brief Something is wrong with the image, the disk or the run; the sentence says what to change. */
class RunError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace meshimage

#endif
