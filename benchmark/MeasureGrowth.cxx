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

#include "itkImageRegionIteratorWithIndex.h"

#include <cstdlib>
#include <iomanip>
#include <iostream>

#ifdef __unix__
#  include <sys/resource.h>
#endif

// How time and memory for a tetrahedron grow with the mesh, on a ball with a wavy surface, and what threads save:
// MeasureGrowth [LARGEST [THREADS]], the largest number of tetrahedra to try (default 1000000), and threads (2).

namespace
{
/** A cube of voxels of 1 mm. */
BenchmarkImageType::Pointer
MakeWavyBall(unsigned int width)
{
  auto                         image = BenchmarkImageType::New();
  BenchmarkImageType::SizeType size;
  size.Fill(width);
  image->SetRegions(size);
  image->Allocate();
  const double center = 0.5 * (width - 1.0);
  for (itk::ImageRegionIteratorWithIndex<BenchmarkImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    const auto   index = it.GetIndex();
    const double x = static_cast<double>(index[0]) - center;
    const double y = static_cast<double>(index[1]) - center;
    const double z = static_cast<double>(index[2]) - center;
    const double wave = 3.0 * std::sin(0.35 * x) * std::sin(0.35 * y) * std::sin(0.35 * z);
    it.Set(std::sqrt(x * x + y * y + z * z) + wave < 0.45 * width ? 1 : 0);
  }
  return image;
}

/** The most memory this process has had so far (bytes), 0 if the system does not tell. */
double
GetPeakMemory()
{
#ifdef __unix__
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
#else
  return 0.0;
#endif
}
} // namespace

int
main(int argc, char * argv[])
{
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  const auto   numberOfThreads = static_cast<unsigned int>(argc > 2 ? std::atoi(argv[2]) : 2);
  try
  {
    const auto   image = MakeWavyBall(320);
    const double before = GetPeakMemory();
    std::cout << "| delta (mm) | tetrahedra | s | microseconds a tetrahedron | bytes a tetrahedron at the peak | s, "
              << numberOfThreads << " threads |\n|---|---|---|---|---|---|\n";
    std::size_t numberOfTetrahedra = 0;
    // A step makes the mesh some three times as large.
    for (double delta = 4.0; static_cast<double>(numberOfTetrahedra) < largest / 3.0; delta /= std::sqrt(3.0))
    {
      std::vector<std::array<double, 3>> points;
      const BenchmarkRunType             run = MeshByDelaunayRefinement(image, delta, 1, points);
      numberOfTetrahedra = run.numberOfTetrahedra;
      const auto number = static_cast<double>(numberOfTetrahedra);
      std::cout << "| " << std::setprecision(3) << delta << " | " << numberOfTetrahedra << " | " << run.seconds << " | "
                << 1e6 * run.seconds / number << " | " << std::setprecision(4) << (GetPeakMemory() - before) / number
                << " | " << std::flush << std::setprecision(3)
                << MeshByDelaunayRefinement(image, delta, numberOfThreads, points).seconds << " |" << std::endl;
    }
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
