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
#include "itkWriteFileBeside.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace itk
{
namespace
{
void
AppendLittleEndian(std::string & bytes, std::uint32_t value, unsigned int count)
{
  for (unsigned int i = 0; i < count; ++i)
  {
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
  }
}

void
AppendFloat(std::string & bytes, double value)
{
  const auto    single = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &single, sizeof(bits));
  AppendLittleEndian(bytes, bits, 4);
}

/** Binary STL: 80 bytes of any text, the number of triangles, and for each its normal, its corners and a 16-bit 0. */
std::string
ComposeSTL(const TetrahedralMeshFileContent & content)
{
  const std::size_t numberOfTriangles = content.cells.size() / 3;
  std::string       bytes("Boundary of a mesh of itk::DelaunayRefinementMeshFilter");
  bytes.resize(80, ' ');
  bytes.reserve(84 + 50 * numberOfTriangles);
  AppendLittleEndian(bytes, static_cast<std::uint32_t>(numberOfTriangles), 4);
  for (std::size_t triangle = 0; triangle < numberOfTriangles; ++triangle)
  {
    std::array<const double *, 3> corner;
    for (unsigned int i = 0; i < 3; ++i)
    {
      corner[i] = content.points.data() + 3 * content.cells[3 * triangle + i];
    }
    std::array<double, 3> normal;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3;
      const unsigned int k = (i + 2) % 3;
      normal[i] = (corner[1][j] - corner[0][j]) * (corner[2][k] - corner[0][k]) -
                  (corner[1][k] - corner[0][k]) * (corner[2][j] - corner[0][j]);
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (const double value : normal)
    {
      AppendFloat(bytes, length > 0.0 ? value / length : 0.0);
    }
    for (const double * point : corner)
    {
      for (unsigned int i = 0; i < 3; ++i)
      {
        AppendFloat(bytes, point[i]);
      }
    }
    AppendLittleEndian(bytes, 0, 2);
  }
  return bytes;
}

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

std::string
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
  if (tetrahedra && extension == ".vtu")
  {
    return ComposeVTKFile(TetrahedralMeshVTKFormat::VTU, content, progress);
  }
  if (!tetrahedra && extension == ".vtp")
  {
    return ComposeVTKFile(TetrahedralMeshVTKFormat::VTP, content, progress);
  }
  if (!tetrahedra && extension == ".ply")
  {
    return ComposeVTKFile(TetrahedralMeshVTKFormat::PLY, content, progress);
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
    const std::string bytes = Compose(fileName, content, progress);
    const auto        secondHalf = [&progress](double share) { return !progress || progress(0.5 + 0.5 * share); };
    return !bytes.empty() && WriteFileBeside(fileName, bytes, secondHalf);
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
