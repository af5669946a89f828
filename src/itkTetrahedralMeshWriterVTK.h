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
#ifndef itkTetrahedralMeshWriterVTK_h
#define itkTetrahedralMeshWriterVTK_h

#include "itkTetrahedralMeshFile.h"

#include <optional>

namespace itk
{
/** \class TetrahedralMeshVTKFormat
 * \brief The formats that VTK writes for us: XML is .vtu for tetrahedra and .vtp for triangles; LEGACY is .vtk. */
enum class TetrahedralMeshVTKFormat
{
  XML,
  LEGACY
};

/** The bytes of a file of this format: in memory, as not all of VTK's writers notice that a disk is full.
 * Throws std::runtime_error with VTK's own words; nothing if \c progress returned false. */
std::optional<std::string>
ComposeVTKFile(TetrahedralMeshVTKFormat                  format,
               const TetrahedralMeshFileContent &        content,
               const TetrahedralMeshFile::ProgressType & progress);
} // end namespace itk

#endif
