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
#include "MeshImageInput.h"

#include "MeshImageCompleteness.h"
#include "MeshImageMessages.h"
#include "MeshImageStandardError.h"
#include "MeshImageTypes.h"

#include "itkImageIOFactory.h"
#include "itkMatrix.h"
#include "vnl/vnl_det.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace meshimage
{
namespace
{
void
RequireReadableFile(const std::string & fileName)
{
  std::error_code ignored;
  if (!std::filesystem::exists(fileName, ignored))
  {
    throw RunError("There is no file " + fileName);
  }
  if (std::filesystem::is_directory(fileName, ignored))
  {
    throw RunError(fileName + " is a folder: name an image file");
  }
  if (!std::ifstream(fileName, std::ios::binary))
  {
    throw RunError("The file " + fileName + " cannot be opened: check its permissions");
  }
}

void
RequireThreeDimensionsOfScalars(const itk::ImageIOBase & io, const std::string & fileName)
{
  unsigned int dimensions = io.GetNumberOfDimensions();
  while (dimensions > 3 && io.GetDimensions(dimensions - 1) == 1)
  {
    --dimensions;
  }
  if (dimensions != 3)
  {
    throw RunError(fileName + " has " + std::to_string(dimensions) + " dimensions: an image of 3 dimensions is needed");
  }
  if (io.GetNumberOfComponents() != 1 || io.GetPixelType() != itk::IOPixelEnum::SCALAR)
  {
    throw RunError(fileName + " has voxels of type " + itk::ImageIOBase::GetPixelTypeAsString(io.GetPixelType()) +
                   ": an image of one number a voxel (scalars) is needed");
  }
}

void
RequireUsableGrid(const itk::ImageIOBase & io, const std::string & fileName)
{
  itk::Matrix<double, 3, 3> direction;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    if (io.GetDimensions(axis) == 0)
    {
      throw RunError(fileName + " has no voxels");
    }
    const double spacing = io.GetSpacing(axis);
    if (!std::isfinite(spacing) || spacing == 0.0 || !std::isfinite(io.GetOrigin(axis)))
    {
      throw RunError(fileName +
                     " has an axis whose spacing, direction or origin is zero or no number: repair its header");
    }
    const std::vector<double> column = io.GetDirection(axis);
    for (unsigned int row = 0; row < 3; ++row)
    {
      direction[row][axis] = column[row];
    }
  }
  // A matrix of unit columns with a determinant this small has axes that nearly coincide.
  constexpr double smallestDeterminant = 1e-6;
  if (!(std::abs(vnl_det(direction.GetVnlMatrix())) > smallestDeterminant))
  {
    throw RunError(fileName + " has a direction matrix that is singular: repair the directions of its axes");
  }
}
} // namespace

itk::ImageIOBase::Pointer
OpenImage(const std::string & fileName)
{
  RequireReadableFile(fileName);
  const SilencedLibraries         silence;
  const itk::ImageIOBase::Pointer io =
    itk::ImageIOFactory::CreateImageIO(fileName.c_str(), itk::IOFileModeEnum::ReadMode);
  if (io == nullptr)
  {
    throw RunError(fileName + " is no image in a format that ITK reads");
  }
  io->SetFileName(fileName);
  try
  {
    io->ReadImageInformation();
  }
  catch (const itk::ExceptionObject & error)
  {
    throw RunError(fileName + " cannot be read as an image; it may be damaged, copy or export it again (" +
                   PlainMessage(error) + ")");
  }
  RequireThreeDimensionsOfScalars(*io, fileName);
  RequireUsableGrid(*io, fileName);
  RequireCompleteFile(*io, fileName);
  return io;
}
} // namespace meshimage
