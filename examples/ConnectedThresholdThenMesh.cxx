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
// Grows a region from a seed through all pixels within a range, and meshes it:
//
//   ConnectedThresholdThenMesh IMAGE X Y Z LOWER UPPER DELTA OUTPUT.vtu
//
// X Y Z is the seed in physical space (mm). What the filter warns of, such as components that are too small for DELTA,
// is shown.

#include "itkConnectedThresholdImageFilter.h"
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkImageFileReader.h"
#include "itkMesh.h"
#include "itkTetrahedralMeshWriter.h"

#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 9)
  {
    std::cerr << "Usage: " << argv[0] << " IMAGE X Y Z LOWER UPPER DELTA OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }

  using ImageType = itk::Image<float, 3>;
  using LabelImageType = itk::Image<unsigned char, 3>;
  using MeshType = itk::Mesh<double, 3>;
  try
  {
    const ImageType::Pointer image = itk::ReadImage<ImageType>(argv[1]);

    ImageType::PointType position;
    for (unsigned int i = 0; i < 3; ++i)
    {
      position[i] = std::stod(argv[2 + i]);
    }
    ImageType::IndexType seed;
    if (!image->TransformPhysicalPointToIndex(position, seed))
    {
      std::cerr << "The seed is not in the image\n";
      return EXIT_FAILURE;
    }

    auto region = itk::ConnectedThresholdImageFilter<ImageType, LabelImageType>::New();
    region->SetInput(image);
    region->AddSeed(seed);
    region->SetLower(std::stof(argv[5]));
    region->SetUpper(std::stof(argv[6]));
    region->SetReplaceValue(1);

    auto mesher = itk::DelaunayRefinementMeshFilter<LabelImageType, MeshType>::New();
    mesher->SetInput(region->GetOutput());
    mesher->SetDelta(std::stod(argv[7])); // mm

    auto writer = itk::TetrahedralMeshWriter<MeshType>::New();
    writer->SetInput(mesher->GetOutput());
    writer->SetFileName(argv[8]);
    writer->Update();
    for (const std::string & warning : mesher->GetWarnings())
    {
      std::cout << warning << '\n';
    }
    std::cout << mesher->GetOutput()->GetNumberOfCells() << " tetrahedra\n";
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
