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
#ifndef MeshImageReading_h
#define MeshImageReading_h

#include "MeshImageMessages.h"
#include "MeshImageStandardError.h"
#include "MeshImageTypes.h"

#include "itkImage.h"
#include "itkImageFileReader.h"

namespace meshimage
{
/** Reads the image that \c io has opened. Throws a RunError if it can't. */
template <typename TImage>
typename TImage::Pointer
ReadImage(const std::string & fileName, itk::ImageIOBase * io)
{
  const auto reader = itk::ImageFileReader<TImage>::New();
  reader->SetFileName(fileName);
  reader->SetImageIO(io);
  const SilencedLibraries silence;
  try
  {
    reader->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    throw RunError(fileName + " cannot be read; it may be truncated or damaged, copy or export it again (" +
                   PlainMessage(error) + ")");
  }
  const typename TImage::Pointer image = reader->GetOutput();
  image->DisconnectPipeline();
  return image;
}

/** Reads an image of lengths. Throws a RunError unless it is a complete 3D image of scalars. */
itk::Image<float, 3>::Pointer
ReadSizeField(const std::string & fileName);
} // namespace meshimage

#endif
