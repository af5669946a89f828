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
#include "itkTetrahedralMeshFile.h"

#include "itkMacro.h"
#include "itkTetrahedralMeshWriterVTK.h"
#include "itkTriangleFormats.h"
#include "itkWriteFileBeside.h"

#include <cctype>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>

namespace itk
{
namespace
{
std::string
LowerCaseExtension(const std::string & fileName)
{
  std::string extension = std::filesystem::path(fileName).extension().string();
  for (char & letter : extension)
  {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return extension;
}

/** Nothing if \c progress returned false. */
std::optional<std::string>
Compose(const std::string &                       fileName,
        const TetrahedralMeshFileContent &        content,
        const TetrahedralMeshFile::ProgressType & progress)
{
  const std::string extension = LowerCaseExtension(fileName);
  const bool        tetrahedra = content.pointsPerCell == 4;
  if (extension == ".vtk")
  {
    return ComposeVTKFile(TetrahedralMeshVTKFormat::LEGACY, content, progress);
  }
  if (extension == (tetrahedra ? ".vtu" : ".vtp"))
  {
    return ComposeVTKFile(TetrahedralMeshVTKFormat::XML, content, progress);
  }
  if (!tetrahedra && extension == ".ply")
  {
    return ComposePLY(content);
  }
  if (!tetrahedra && extension == ".stl")
  {
    return ComposeSTL(content);
  }
  throw std::runtime_error(
    "The file name " + fileName + " must end in " +
    (tetrahedra ? ".vtu or .vtk to hold tetrahedra" : ".vtp, .vtk, .stl or .ply to hold triangles"));
}
} // namespace

bool
TetrahedralMeshFile::Write(const std::string &                fileName,
                           const TetrahedralMeshFileContent & content,
                           const ProgressType &               progress)
{
  try
  {
    const std::optional<std::string> bytes = Compose(fileName, content, progress);
    const auto secondHalf = [&progress](double share) { return !progress || progress(0.5 + 0.5 * share); };
    return bytes && WriteFileBeside(fileName, *bytes, secondHalf);
  }
  catch (const std::bad_alloc &)
  {
    itkGenericExceptionMacro("The file " << fileName << " cannot be written: there is not enough memory to compose it");
  }
  catch (const std::runtime_error & error)
  {
    itkGenericExceptionMacro(<< error.what());
  }
}
} // end namespace itk
