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
#include "MeshImageCompleteness.h"

#include "MeshImageFileBytes.h"
#include "MeshImageMetaImageHeader.h"
#include "MeshImageNiftiHeader.h"
#include "MeshImageTiffHeader.h"
#include "MeshImageTypes.h"

#include <cstring>
#include <filesystem>
#include <fstream>

namespace meshimage
{
namespace
{
std::uint64_t
NumberOfBytes(const itk::ImageIOBase & io)
{
  return static_cast<std::uint64_t>(io.GetImageSizeInBytes());
}

std::uint64_t
NumberOfVoxels(const itk::ImageIOBase & io)
{
  return static_cast<std::uint64_t>(io.GetImageSizeInPixels());
}

bool
IsCompleteMetaImage(const itk::ImageIOBase & io, const std::string & fileName)
{
  const MetaImageHeader header = ReadMetaImageHeader(fileName);
  if (!header.hasOneDataFile)
  {
    // A list of slices: MetaImage complains of missing ones itself.
    return true;
  }
  if (!header.binary)
  {
    return HoldsWords(header.dataFile, header.dataOffset, NumberOfVoxels(io));
  }
  if (!header.compressed)
  {
    return HoldsBytes(header.dataFile, header.dataOffset, NumberOfBytes(io));
  }
  if (header.compressedSize > 0)
  {
    return HoldsBytes(header.dataFile, header.dataOffset, header.compressedSize);
  }
  // Without a size, MetaImage takes the file from its first byte on, which only works where the header is elsewhere.
  return InflatesToBytes(header.dataFile, NumberOfBytes(io));
}

bool
IsCompleteNifti(const itk::ImageIOBase &, const std::string & fileName)
{
  const NiftiHeader header = ReadNiftiHeader(fileName);
  return !header.valid || HoldsBytes(header.dataFile, header.dataOffset, header.dataSize);
}

bool
IsCompleteGipl(const itk::ImageIOBase & io, const std::string & fileName)
{
  constexpr std::uint64_t headerSize = 256;
  return HoldsBytes(fileName, headerSize, NumberOfBytes(io));
}

bool
IsCompleteMrc(const itk::ImageIOBase & io, const std::string & fileName)
{
  // The size of the extended header stands at byte 92, in the byte order of the file, which the size tells: it is
  // small.
  constexpr std::size_t headerSize = 1024;
  constexpr std::size_t extendedSizeAt = 92;
  const std::string     head = ReadHead(fileName, headerSize);
  if (head.size() < headerSize)
  {
    return false;
  }
  unsigned char bytes[4];
  std::memcpy(bytes, head.data() + extendedSizeAt, 4);
  const auto compose = [&bytes](int a, int b, int c, int d) {
    return std::uint32_t{ bytes[a] } | std::uint32_t{ bytes[b] } << 8 | std::uint32_t{ bytes[c] } << 16 |
           std::uint32_t{ bytes[d] } << 24;
  };
  const std::uint64_t extendedSize = std::min(compose(0, 1, 2, 3), compose(3, 2, 1, 0));
  return HoldsBytes(fileName, headerSize + extendedSize, NumberOfBytes(io));
}

bool
IsCompleteTiff(const itk::ImageIOBase &, const std::string & fileName)
{
  return IsCompleteTiffFile(fileName);
}

bool
IsCompleteVtk(const itk::ImageIOBase & io, const std::string & fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  std::string   line;
  bool          binary = false;
  while (std::getline(file, line))
  {
    if (line.compare(0, 6, "BINARY") == 0)
    {
      binary = true;
    }
    else if (line.compare(0, 12, "LOOKUP_TABLE") == 0)
    {
      const auto offset = static_cast<std::uint64_t>(file.tellg());
      return binary ? HoldsBytes(fileName, offset, NumberOfBytes(io))
                    : HoldsWords(fileName, offset, NumberOfVoxels(io));
    }
  }
  return false;
}
} // namespace

void
RequireCompleteFile(const itk::ImageIOBase & io, const std::string & fileName)
{
  using TestType = bool (*)(const itk::ImageIOBase &, const std::string &);
  const std::pair<const char *, TestType> tests[] = {
    { "MetaImageIO", IsCompleteMetaImage }, { "NiftiImageIO", IsCompleteNifti }, { "GiplImageIO", IsCompleteGipl },
    { "MRCImageIO", IsCompleteMrc },        { "TIFFImageIO", IsCompleteTiff },   { "VTKImageIO", IsCompleteVtk }
  };
  for (const auto & [reader, isComplete] : tests)
  {
    if (std::strcmp(io.GetNameOfClass(), reader) == 0 && !isComplete(io, fileName))
    {
      throw RunError(
        fileName + " is truncated or damaged: it holds fewer voxels than its header promises; copy or export it again");
    }
  }
}
} // namespace meshimage
