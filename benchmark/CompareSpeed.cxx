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

#include "itkBinaryThresholdImageFilter.h"
#include "itkImageFileReader.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

// Runs this project, CGAL Mesh_3 and the bare triangulation of this project's points in turn, and prints a table with
// the least seconds of each, this project's on two threads too: CompareSpeed RUNS IMAGE DELTA [IMAGE DELTA]...

namespace
{
BenchmarkImageType::Pointer
ReadMask(const std::string & fileName)
{
  using InputImageType = itk::Image<float, 3>;
  const auto image = itk::ReadImage<InputImageType>(fileName);
  auto       threshold = itk::BinaryThresholdImageFilter<InputImageType, BenchmarkImageType>::New();
  threshold->SetInput(image);
  threshold->SetLowerThreshold(1.0f);
  threshold->SetInsideValue(1);
  threshold->Update();
  return threshold->GetOutput();
}

void
KeepFastest(BenchmarkRunType & best, const BenchmarkRunType & run)
{
  if (best.numberOfTetrahedra == 0 || run.seconds < best.seconds)
  {
    best = run;
  }
}

void
Compare(unsigned int numberOfRuns, const std::string & fileName, double delta)
{
  const auto       mask = ReadMask(fileName);
  BenchmarkRunType ours{};
  BenchmarkRunType shared{};
  BenchmarkRunType mesh3{};
  BenchmarkRunType bare{};
  for (unsigned int i = 0; i < numberOfRuns; ++i)
  {
    std::vector<std::array<double, 3>> points;
    KeepFastest(ours, MeshByDelaunayRefinement(mask, delta, 1, points));
    KeepFastest(shared, MeshByDelaunayRefinement(mask, delta, 2, points));
    KeepFastest(mesh3, MeshByMesh3(mask, delta));
    KeepFastest(bare, TriangulatePoints(points));
  }
  const double ratio = mesh3.seconds / ours.seconds;
  const auto   share = [](std::size_t a, std::size_t b) { return static_cast<double>(a) / static_cast<double>(b); };
  std::cout << "| " << fileName.substr(fileName.find_last_of('/') + 1) << ", " << delta << " | " << std::fixed
            << std::setprecision(3) << ours.seconds << ", " << ours.numberOfTetrahedra << ", " << ours.numberOfTriangles
            << " | " << mesh3.seconds << ", " << mesh3.numberOfTetrahedra << ", " << mesh3.numberOfTriangles << " | "
            << std::setprecision(2) << ratio << " | "
            << ratio * share(ours.numberOfTetrahedra, mesh3.numberOfTetrahedra) << " | "
            << ratio * share(ours.numberOfTriangles, mesh3.numberOfTriangles) << " | " << ours.seconds / bare.seconds
            << " | " << ours.seconds / shared.seconds << " |\n"
            << std::defaultfloat;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc < 4 || argc % 2 != 0)
  {
    std::cerr << "Usage: " << argv[0] << " RUNS IMAGE DELTA [IMAGE DELTA]...\n";
    return EXIT_FAILURE;
  }
  try
  {
    std::cout
      << "| image, delta (mm) | ours: s, tetrahedra, triangles | Mesh_3: the same | Mesh_3's time over ours"
         " | tetrahedra per second | time per triangle | our time over a bare triangulation | two threads over one |\n"
         "|---|---|---|---|---|---|---|---|\n";
    for (int i = 2; i < argc; i += 2)
    {
      Compare(static_cast<unsigned int>(std::atoi(argv[1])), argv[i], std::atof(argv[i + 1]));
    }
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
