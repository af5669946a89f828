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
// Divides an image into catchment basins and meshes the one that holds a seed:
//
//   WatershedThenMesh IMAGE X Y Z LEVEL DELTA OUTPUT.vtu
//
// X Y Z is the seed in physical space (mm). LEVEL, from 0 to 1, is the depth of floods: the larger it is, the fewer
// basins there are. The watershed's labels are unsigned integers of 64 bits, which the mesh filter takes as they are;
// the label of the basin comes back as the cell array "label".

#include "itkDelaunayRefinementMeshFilter.h"
#include "itkGradientMagnitudeRecursiveGaussianImageFilter.h"
#include "itkImageFileReader.h"
#include "itkMesh.h"
#include "itkTetrahedralMeshWriter.h"
#include "itkWatershedImageFilter.h"

#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 8)
  {
    std::cerr << "Usage: " << argv[0] << " IMAGE X Y Z LEVEL DELTA OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }

  using ImageType = itk::Image<float, 3>;
  using WatershedType = itk::WatershedImageFilter<ImageType>;
  using LabelImageType = WatershedType::OutputImageType;
  using MeshType = itk::Mesh<double, 3>;
  try
  {
    const ImageType::Pointer image = itk::ReadImage<ImageType>(argv[1]);
    ImageType::PointType     position;
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

    auto gradient = itk::GradientMagnitudeRecursiveGaussianImageFilter<ImageType>::New();
    gradient->SetInput(image);
    gradient->SetSigma(image->GetSpacing()[0]);

    auto watershed = WatershedType::New();
    watershed->SetInput(gradient->GetOutput());
    watershed->SetThreshold(0.01);
    watershed->SetLevel(std::stod(argv[5]));
    watershed->Update();

    auto mesher = itk::DelaunayRefinementMeshFilter<LabelImageType, MeshType>::New();
    mesher->SetInput(watershed->GetOutput());
    mesher->SetLabels({ watershed->GetOutput()->GetPixel(seed) });
    mesher->SetDelta(std::stod(argv[6])); // mm

    auto writer = itk::TetrahedralMeshWriter<MeshType>::New();
    writer->SetInput(mesher->GetOutput());
    writer->SetFileName(argv[7]);
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
