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
#include "MeshImageRun.h"

#include <map>

namespace meshimage
{
Run
RunFilter(const Options & options, itk::ImageIOBase * io, const ProgressFunction & progress)
{
  using RunType = Run (*)(const Options &, itk::ImageIOBase *, const ProgressFunction &);
  static const std::map<itk::IOComponentEnum, RunType> runs{
    { itk::IOComponentEnum::UCHAR, RunFilterOnPixels<unsigned char> },
    { itk::IOComponentEnum::CHAR, RunFilterOnPixels<signed char> },
    { itk::IOComponentEnum::USHORT, RunFilterOnPixels<unsigned short> },
    { itk::IOComponentEnum::SHORT, RunFilterOnPixels<short> },
    { itk::IOComponentEnum::UINT, RunFilterOnPixels<unsigned int> },
    { itk::IOComponentEnum::INT, RunFilterOnPixels<int> },
    // No narrower on any platform; the reader converts.
    { itk::IOComponentEnum::ULONG, RunFilterOnPixels<unsigned long long> },
    { itk::IOComponentEnum::LONG, RunFilterOnPixels<long long> },
    { itk::IOComponentEnum::ULONGLONG, RunFilterOnPixels<unsigned long long> },
    { itk::IOComponentEnum::LONGLONG, RunFilterOnPixels<long long> },
    { itk::IOComponentEnum::FLOAT, RunFilterOnPixels<float> },
    { itk::IOComponentEnum::DOUBLE, RunFilterOnPixels<double> }
  };
  const auto found = runs.find(io->GetComponentType());
  if (found == runs.end())
  {
    throw RunError(options.image + " has voxels of type " +
                   itk::ImageIOBase::GetComponentTypeAsString(io->GetComponentType()) +
                   ", which this program does not read: convert them to another type");
  }
  return found->second(options, io, progress);
}
} // namespace meshimage
