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
// Segments an image by a threshold and meshes the largest component:
//
//   ThresholdThenMesh IMAGE LOWER UPPER DELTA OUTPUT.vtu
//
// All runs as one pipeline: Update() on the writer runs the reader, the threshold and the mesh filter.

#include "itkBinaryThresholdImageFilter.h"
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkImageFileReader.h"
#include "itkMesh.h"
#include "itkTetrahedralMeshWriter.h"

#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 6)
  {
    std::cerr << "Usage: " << argv[0] << " IMAGE LOWER UPPER DELTA OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }

  using ImageType = itk::Image<float, 3>;
  using LabelImageType = itk::Image<unsigned char, 3>;
  using MeshType = itk::Mesh<double, 3>;
  try
  {
    auto reader = itk::ImageFileReader<ImageType>::New();
    reader->SetFileName(argv[1]);

    auto threshold = itk::BinaryThresholdImageFilter<ImageType, LabelImageType>::New();
    threshold->SetInput(reader->GetOutput());
    threshold->SetLowerThreshold(std::stof(argv[2]));
    threshold->SetUpperThreshold(std::stof(argv[3]));
    threshold->SetInsideValue(1);

    auto mesher = itk::DelaunayRefinementMeshFilter<LabelImageType, MeshType>::New();
    mesher->SetInput(threshold->GetOutput());
    mesher->SetDelta(std::stod(argv[4])); // mm
    mesher->LargestComponentOnlyOn();

    auto writer = itk::TetrahedralMeshWriter<MeshType>::New();
    writer->SetInput(mesher->GetOutput());
    writer->SetFileName(argv[5]);
    writer->Update();
    std::cout << mesher->GetOutput()->GetNumberOfCells() << " tetrahedra\n";
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
