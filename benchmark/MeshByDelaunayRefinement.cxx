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
#include "BenchmarkTypes.h"

#include "itkDelaunayRefinementMeshFilter.h"
#include "itkMesh.h"

#include <chrono>

BenchmarkRunType
MeshByDelaunayRefinement(const BenchmarkImageType *           image,
                         double                               delta,
                         unsigned int                         numberOfThreads,
                         std::vector<std::array<double, 3>> & points)
{
  using MeshTraits = itk::DefaultStaticMeshTraits<double, 3, 3, double>;
  using MeshType = itk::Mesh<double, 3, MeshTraits>;
  auto filter = itk::DelaunayRefinementMeshFilter<BenchmarkImageType, MeshType>::New();
  filter->SetInput(image);
  filter->SetLowerThreshold(1.0);
  filter->SetDelta(delta);
  filter->SetNumberOfWorkUnits(numberOfThreads);

  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  const MeshType * mesh = filter->GetOutput();
  points.resize(mesh->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto point = mesh->GetPoint(i);
    points[i] = { point[0], point[1], point[2] };
  }
  return { seconds.count(), mesh->GetNumberOfCells(), filter->GetBoundaryOutput()->GetNumberOfCells() };
}
