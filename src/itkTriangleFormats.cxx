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
#include "itkTriangleFormats.h"

#include <array>
#include <cmath>
#include <cstring>

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
  AppendLittleEndian(bytes, bits, sizeof(bits));
}
} // namespace

std::string
ComposeSTL(const TetrahedralMeshFileContent & content)
{
  constexpr std::size_t headerSize = 80;
  constexpr std::size_t triangleSize = 50;

  const std::size_t numberOfTriangles = content.cells.size() / 3;
  std::string       bytes("Surface of a mesh of itk::DelaunayRefinementMeshFilter");
  bytes.resize(headerSize, ' ');
  bytes.reserve(headerSize + 4 + triangleSize * numberOfTriangles);
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
    // The attributes, of which there are none.
    AppendLittleEndian(bytes, 0, 2);
  }
  return bytes;
}

std::string
ComposePLY(const TetrahedralMeshFileContent & content)
{
  const std::size_t numberOfTriangles = content.cells.size() / 3;
  std::string       bytes = "ply\n"
                            "format binary_little_endian 1.0\n"
                            "comment Surface of a mesh of itk::DelaunayRefinementMeshFilter\n"
                            "element vertex " +
                      std::to_string(content.points.size() / 3) +
                      "\n"
                      "property float x\n"
                      "property float y\n"
                      "property float z\n"
                      "element face " +
                      std::to_string(numberOfTriangles) +
                      "\n"
                      "property list uchar int vertex_indices\n"
                      "end_header\n";
  bytes.reserve(bytes.size() + 4 * content.points.size() + 13 * numberOfTriangles);
  for (const double value : content.points)
  {
    AppendFloat(bytes, value);
  }
  for (std::size_t i = 0; i < content.cells.size(); ++i)
  {
    if (i % 3 == 0)
    {
      AppendLittleEndian(bytes, 3, 1);
    }
    AppendLittleEndian(bytes, static_cast<std::uint32_t>(content.cells[i]), 4);
  }
  return bytes;
}
} // end namespace itk
