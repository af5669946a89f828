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

// MeshForPython float|double IMAGE PREFIX: meshes the voxels from 1 on at delta 3, and writes PREFIX.points (float) and
// PREFIX.cells (64 bits) for a test in Python.

#include "itkDelaunayRefinementMeshFilter.h"
#include "itkImageFileReader.h"
#include "itkMesh.h"

#include <cstdint>
#include <fstream>
#include <iostream>
#include <string>

template <typename TPixel>
void
MakeMesh(const std::string & imageName, const std::string & prefix)
{
  using ImageType = itk::Image<unsigned char, 3>;
  using MeshType = itk::Mesh<TPixel, 3>;

  auto filter = itk::DelaunayRefinementMeshFilter<ImageType, MeshType>::New();
  filter->SetInput(itk::ReadImage<ImageType>(imageName));
  filter->SetLowerThreshold(1.0);
  filter->SetDelta(3.0);
  filter->Update();

  std::ofstream points(prefix + ".points", std::ios::binary);
  for (const auto & point : filter->GetOutput()->GetPoints()->CastToSTLConstContainer())
  {
    points.write(reinterpret_cast<const char *>(point.GetDataPointer()), 3 * sizeof(float));
  }
  std::ofstream cells(prefix + ".cells", std::ios::binary);
  for (const auto * cell : filter->GetOutput()->GetCells()->CastToSTLConstContainer())
  {
    for (const auto * id = cell->PointIdsBegin(); id != cell->PointIdsEnd(); ++id)
    {
      const std::uint64_t index = *id;
      cells.write(reinterpret_cast<const char *>(&index), sizeof(index));
    }
  }
}

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " float|double IMAGE PREFIX\n";
    return EXIT_FAILURE;
  }
  const std::string type = argv[1];
  type == "float" ? MakeMesh<float>(argv[2], argv[3]) : MakeMesh<double>(argv[2], argv[3]);
  return EXIT_SUCCESS;
}
