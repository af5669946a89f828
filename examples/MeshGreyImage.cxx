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
// Meshes what lies at or above an iso value of a grey image, without a segmentation:
//
//   MeshGreyImage IMAGE ISO_VALUE DELTA OUTPUT.vtu BOUNDARY.stl
//
// A cubic B-spline through the pixels makes the surface smooth between them; any itk::InterpolateImageFunction may
// stand in its place. The boundary is written as well.

#include "itkBSplineInterpolateImageFunction.h"
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
    std::cerr << "Usage: " << argv[0] << " IMAGE ISO_VALUE DELTA OUTPUT.vtu BOUNDARY.stl\n";
    return EXIT_FAILURE;
  }

  using ImageType = itk::Image<float, 3>;
  using MeshType = itk::Mesh<double, 3>;
  try
  {
    auto interpolator = itk::BSplineInterpolateImageFunction<ImageType, double>::New();
    interpolator->SetSplineOrder(3);

    auto mesher = itk::DelaunayRefinementMeshFilter<ImageType, MeshType>::New();
    mesher->SetInput(itk::ReadImage<ImageType>(argv[1]));
    mesher->SetIsoValue(std::stod(argv[2]));
    mesher->SetInterpolator(interpolator);
    mesher->SetDelta(std::stod(argv[3])); // mm

    auto writer = itk::TetrahedralMeshWriter<MeshType>::New();
    writer->SetInput(mesher->GetOutput());
    writer->SetFileName(argv[4]);
    writer->Update();

    auto boundaryWriter = itk::TetrahedralMeshWriter<MeshType>::New();
    boundaryWriter->SetInput(mesher->GetBoundaryOutput());
    boundaryWriter->SetFileName(argv[5]);
    boundaryWriter->Update();
    std::cout << mesher->GetOutput()->GetNumberOfCells() << " tetrahedra, "
              << mesher->GetBoundaryOutput()->GetNumberOfCells() << " boundary triangles\n";
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
