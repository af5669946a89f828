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
#include "MeshImageNiftiHeader.h"

#include "MeshImageFileBytes.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace meshimage
{
namespace
{
/** \class HeaderBytes
 * \brief Takes numbers out of a header that may be in the other byte order. */
class HeaderBytes
{
public:
  HeaderBytes(const std::string & bytes, bool swapped)
    : m_Bytes(bytes)
    , m_Swapped(swapped)
  {}

  template <typename TValue>
  TValue
  Get(std::size_t offset) const
  {
    char raw[sizeof(TValue)];
    std::memcpy(raw, m_Bytes.data() + offset, sizeof(TValue));
    if (m_Swapped)
    {
      std::reverse(raw, raw + sizeof(TValue));
    }
    TValue value;
    std::memcpy(&value, raw, sizeof(TValue));
    return value;
  }

private:
  const std::string & m_Bytes;
  bool                m_Swapped;
};

constexpr std::size_t sizeOfNifti1 = 348;
constexpr std::size_t sizeOfNifti2 = 540;

/** Number of bytes of all voxels, from the dimensions at \c offset and the bits of a voxel. */
template <typename TDimension>
std::uint64_t
ComputeDataSize(const HeaderBytes & bytes, std::size_t offset, int bitsOfVoxel)
{
  const auto    numberOfDimensions = std::min<TDimension>(bytes.Get<TDimension>(offset), 7);
  std::uint64_t voxels = 1;
  for (TDimension i = 1; i <= numberOfDimensions; ++i)
  {
    const auto length = bytes.Get<TDimension>(offset + static_cast<std::size_t>(i) * sizeof(TDimension));
    voxels *= length > 0 ? static_cast<std::uint64_t>(length) : 1;
  }
  return voxels * static_cast<std::uint64_t>(bitsOfVoxel) / 8;
}

/** Of the two files of a pair: image.hdr and image.img, each also with .gz. */
std::string
FindOther(const std::string & fileName, const char * extension)
{
  std::filesystem::path stem = fileName;
  if (stem.extension() == ".gz")
  {
    stem.replace_extension();
  }
  stem.replace_extension(extension);
  std::error_code ignored;
  return std::filesystem::exists(stem, ignored) ? stem.string() : stem.string() + ".gz";
}

bool
EndsIn(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
} // namespace

NiftiHeader
ReadNiftiHeader(const std::string & fileName)
{
  const bool        isImagePart = EndsIn(fileName, ".img") || EndsIn(fileName, ".img.gz");
  const std::string headerFile = isImagePart ? FindOther(fileName, ".hdr") : fileName;
  std::string       raw = ReadHead(headerFile, sizeOfNifti2);
  NiftiHeader       header;
  if (raw.size() < sizeOfNifti1)
  {
    return header;
  }
  const auto sizeOfHeader = HeaderBytes(raw, false).Get<std::int32_t>(0);
  const bool swapped = sizeOfHeader != sizeOfNifti1 && sizeOfHeader != sizeOfNifti2;
  raw.resize(sizeOfNifti2, '\0');
  const HeaderBytes bytes(raw, swapped);
  bool              onePiece = false;
  if (bytes.Get<std::int32_t>(0) == sizeOfNifti1)
  {
    onePiece = std::strncmp(raw.data() + 344, "n+1", 4) == 0;
    header.dataSize = ComputeDataSize<std::int16_t>(bytes, 40, bytes.Get<std::int16_t>(72));
    header.dataOffset = static_cast<std::uint64_t>(std::max(0.0F, bytes.Get<float>(108)));
  }
  else if (bytes.Get<std::int32_t>(0) == sizeOfNifti2)
  {
    onePiece = std::strncmp(raw.data() + 4, "n+2", 4) == 0;
    header.dataSize = ComputeDataSize<std::int64_t>(bytes, 16, bytes.Get<std::int16_t>(14));
    header.dataOffset = static_cast<std::uint64_t>(std::max<std::int64_t>(0, bytes.Get<std::int64_t>(168)));
  }
  else
  {
    return header;
  }
  header.valid = true;
  header.dataFile = onePiece ? headerFile : FindOther(headerFile, ".img");
  return header;
}
} // namespace meshimage
