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
#ifndef itkTetrahedralMeshFile_h
#define itkTetrahedralMeshFile_h

#include "DelaunayRefinementExport.h"

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace itk
{
/** \class TetrahedralMeshFileContent
 * \brief A mesh of tetrahedra or of triangles in flat arrays.
 *
 * \ingroup DelaunayRefinement
 */
struct TetrahedralMeshFileContent
{
  /** One integer a cell, or nothing. */
  using LabelsType =
    std::variant<std::monostate, std::vector<std::int32_t>, std::vector<std::int64_t>, std::vector<std::uint64_t>>;

  /** x, y, z of each point. */
  std::vector<double> points{};

  /** 4: tetrahedra, 3: triangles. */
  unsigned int pointsPerCell{ 4 };

  /** Indices of the points of each cell. */
  std::vector<std::int64_t> cells{};

  /** Written as the cell array \c label. */
  LabelsType labels{};
};

/** \class TetrahedralMeshFile
 * \brief The compiled part of TetrahedralMeshWriter: writes flat arrays to a file.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT TetrahedralMeshFile
{
public:
  /** Takes a growing share of the work done, in [0, 1]; the writing stops when it returns false. */
  using ProgressType = std::function<bool(double)>;

  /** Writes the mesh beside the file and renames it in the end. The extension chooses the format: .vtu or .vtk for
   * tetrahedra; .vtp, .vtk, .stl or .ply for triangles. Throws an ExceptionObject if the file cannot be written.
   * \retval false if \c progress returned false; the file is then as it was before. */
  static bool
  Write(const std::string & fileName, const TetrahedralMeshFileContent & content, const ProgressType & progress);
};
} // end namespace itk

#endif
