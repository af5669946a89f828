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
#include "itkBinaryThresholdImageFilter.h"
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkMesh.h"
#include "itkTetrahedralMeshWriter.h"

#include <cstdlib>
#include <iostream>

// A user's program: a segmentation filter, then the mesh, then a file.
int
main()
{
  using GreyImageType = itk::Image<float, 3>;
  using LabelImageType = itk::Image<unsigned char, 3>;
  using MeshType = itk::Mesh<double, 3>;

  // The values grow towards the middle of the image.
  auto image = GreyImageType::New();
  image->SetRegions(GreyImageType::SizeType{ { 20, 20, 20 } });
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<GreyImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    double squaredDistance = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double offset = static_cast<double>(it.GetIndex()[i]) - 9.5;
      squaredDistance += offset * offset;
    }
    it.Set(static_cast<float>(100.0 - squaredDistance));
  }

  auto threshold = itk::BinaryThresholdImageFilter<GreyImageType, LabelImageType>::New();
  threshold->SetInput(image);
  threshold->SetLowerThreshold(51.0F); // a ball of radius 7
  threshold->SetInsideValue(1);

  auto mesher = itk::DelaunayRefinementMeshFilter<LabelImageType, MeshType>::New();
  mesher->SetInput(threshold->GetOutput());
  mesher->SetDelta(2.0);

  auto writer = itk::TetrahedralMeshWriter<MeshType>::New();
  writer->SetInput(mesher->GetOutput());
  writer->SetFileName("ball.vtu");
  try
  {
    writer->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error << '\n';
    return EXIT_FAILURE;
  }
  const auto tetrahedra = mesher->GetOutput()->GetNumberOfCells();
  const auto triangles = mesher->GetBoundaryOutput()->GetNumberOfCells();
  std::cout << tetrahedra << " tetrahedra, " << triangles << " boundary triangles\n";
  // A ball of radius 7 at delta 2 has some hundreds of each.
  return tetrahedra > 200 && triangles > 100 ? EXIT_SUCCESS : EXIT_FAILURE;
}
