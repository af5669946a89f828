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
// Meshes a part of an image, shows how far it is, and gives up after a time:
//
//   MeshRegionOfInterest IMAGE X Y Z SIZE_X SIZE_Y SIZE_Z LOWER DELTA SECONDS OUTPUT.vtu
//
// X Y Z is the first pixel of the region, SIZE_X SIZE_Y SIZE_Z its size in pixels. The object is all that is at or
// above LOWER. The mesh lies where the region lies in the image.

#include "itkCommand.h"
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkImageFileReader.h"
#include "itkMesh.h"
#include "itkRegionOfInterestImageFilter.h"
#include "itkTetrahedralMeshWriter.h"

#include <chrono>
#include <cstdlib>
#include <iostream>

namespace
{
using ImageType = itk::Image<float, 3>;
using MeshType = itk::Mesh<double, 3>;

/** \class Observer
 * \brief Shows each tenth of the work, and aborts when the time is up.
 */
class Observer : public itk::Command
{
public:
  using Self = Observer;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);

  void
  SetSeconds(double seconds)
  {
    m_End = ClockType::now() + std::chrono::duration_cast<ClockType::duration>(std::chrono::duration<double>(seconds));
  }

  void
  Execute(itk::Object * caller, const itk::EventObject &) override
  {
    auto *    process = dynamic_cast<itk::ProcessObject *>(caller);
    const int tenths = static_cast<int>(10.0F * process->GetProgress());
    if (tenths > m_Tenths)
    {
      m_Tenths = tenths;
      std::cout << 10 * tenths << " %\n";
    }
    if (ClockType::now() > m_End)
    {
      process->AbortGenerateDataOn();
    }
  }

  void
  Execute(const itk::Object *, const itk::EventObject &) override
  {}

private:
  using ClockType = std::chrono::steady_clock;
  ClockType::time_point m_End{};
  int                   m_Tenths{ 0 };
};
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 12)
  {
    std::cerr << "Usage: " << argv[0] << " IMAGE X Y Z SIZE_X SIZE_Y SIZE_Z LOWER DELTA SECONDS OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }
  try
  {
    ImageType::RegionType region;
    for (unsigned int i = 0; i < 3; ++i)
    {
      region.SetIndex(i, std::stol(argv[2 + i]));
      region.SetSize(i, std::stoul(argv[5 + i]));
    }
    auto part = itk::RegionOfInterestImageFilter<ImageType, ImageType>::New();
    part->SetInput(itk::ReadImage<ImageType>(argv[1]));
    part->SetRegionOfInterest(region);

    auto observer = Observer::New();
    observer->SetSeconds(std::stod(argv[10]));

    auto mesher = itk::DelaunayRefinementMeshFilter<ImageType, MeshType>::New();
    mesher->SetInput(part->GetOutput());
    mesher->SetLowerThreshold(std::stod(argv[8]));
    mesher->SetDelta(std::stod(argv[9])); // mm
    mesher->AddObserver(itk::ProgressEvent(), observer);

    auto writer = itk::TetrahedralMeshWriter<MeshType>::New();
    writer->SetInput(mesher->GetOutput());
    writer->SetFileName(argv[11]);
    writer->Update();
    std::cout << mesher->GetOutput()->GetNumberOfCells() << " tetrahedra\n";
  }
  catch (const itk::ProcessAborted &)
  {
    std::cerr << "The time is up; choose a larger DELTA or a smaller region\n";
    return EXIT_FAILURE;
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
