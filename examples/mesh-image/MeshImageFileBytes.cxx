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
#include "MeshImageFileBytes.h"

#include "itk_zlib.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

namespace meshimage
{
namespace
{
constexpr std::size_t bufferSize = std::size_t{ 1 } << 20;

bool
IsGzipped(std::ifstream & file)
{
  unsigned char magic[2] = { 0, 0 };
  file.read(reinterpret_cast<char *>(magic), 2);
  return file && magic[0] == 0x1F && magic[1] == 0x8B;
}

/** The length that a gzipped file states in its last four bytes, modulo 2^32. */
std::uint32_t
StatedLength(std::ifstream & file)
{
  unsigned char trailer[4] = { 0, 0, 0, 0 };
  file.seekg(-4, std::ios::end);
  file.read(reinterpret_cast<char *>(trailer), 4);
  return std::uint32_t{ trailer[0] } | std::uint32_t{ trailer[1] } << 8 | std::uint32_t{ trailer[2] } << 16 |
         std::uint32_t{ trailer[3] } << 24;
}

using GzipFile = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

GzipFile
OpenGzip(const std::string & fileName)
{
  return { gzopen(fileName.c_str(), "rb"), gzclose };
}

} // namespace

std::string
ReadHead(const std::string & fileName, std::size_t count)
{
  std::string    bytes(count, '\0');
  const GzipFile file = OpenGzip(fileName);
  const int      read = file ? gzread(file.get(), bytes.data(), static_cast<unsigned int>(count)) : 0;
  bytes.resize(read > 0 ? static_cast<std::size_t>(read) : 0);
  return bytes;
}

bool
HoldsBytes(const std::string & fileName, std::uint64_t offset, std::uint64_t wanted)
{
  const std::uint64_t total = offset + wanted;
  std::ifstream       file(fileName, std::ios::binary);
  if (!IsGzipped(file))
  {
    std::error_code     error;
    const std::uint64_t size = std::filesystem::file_size(fileName, error);
    return !error && size >= total;
  }
  // Unzipping a large file only to count would take as long as to read it.
  if (StatedLength(file) == static_cast<std::uint32_t>(total))
  {
    return true;
  }
  const GzipFile    unzipped = OpenGzip(fileName);
  std::vector<char> buffer(bufferSize);
  std::uint64_t     found = 0;
  while (unzipped && found < total)
  {
    const int count = gzread(unzipped.get(), buffer.data(), static_cast<unsigned int>(buffer.size()));
    if (count <= 0)
    {
      return false;
    }
    found += static_cast<std::uint64_t>(count);
  }
  return found >= total;
}

bool
InflatesToBytes(const std::string & fileName, std::uint64_t wanted)
{
  std::ifstream file(fileName, std::ios::binary);
  z_stream      stream{};
  // Both headers, zlib's and gzip's, are recognized.
  constexpr int anyHeader = 32;
  if (inflateInit2(&stream, MAX_WBITS + anyHeader) != Z_OK)
  {
    return false;
  }
  std::vector<unsigned char> input(bufferSize);
  std::vector<unsigned char> output(bufferSize);
  std::uint64_t              found = 0;
  int                        status = Z_OK;
  while (status == Z_OK && found < wanted)
  {
    if (stream.avail_in == 0)
    {
      file.read(reinterpret_cast<char *>(input.data()), static_cast<std::streamsize>(input.size()));
      stream.next_in = input.data();
      stream.avail_in = static_cast<unsigned int>(file.gcount());
    }
    stream.next_out = output.data();
    stream.avail_out = static_cast<unsigned int>(output.size());
    // Ends with Z_BUF_ERROR at the end of the file.
    status = inflate(&stream, Z_NO_FLUSH);
    found += output.size() - stream.avail_out;
  }
  inflateEnd(&stream);
  return found >= wanted;
}

bool
HoldsWords(const std::string & fileName, std::uint64_t offset, std::uint64_t wanted)
{
  std::ifstream file(fileName, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  std::string   word;
  std::uint64_t found = 0;
  while (found < wanted && file >> word)
  {
    ++found;
  }
  return found >= wanted;
}
} // namespace meshimage
