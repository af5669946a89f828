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
#include "MeshImageMetaImageHeader.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace meshimage
{
namespace
{
std::string
Trim(const std::string & text)
{
  const auto isSpace = [](unsigned char letter) { return std::isspace(letter) != 0; };
  const auto first = std::find_if_not(text.begin(), text.end(), isSpace);
  const auto last = std::find_if_not(text.rbegin(), text.rend(), isSpace).base();
  return first < last ? std::string(first, last) : std::string();
}

bool
IsTrue(const std::string & value)
{
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}
} // namespace

MetaImageHeader
ReadMetaImageHeader(const std::string & fileName)
{
  MetaImageHeader header;
  std::ifstream   file(fileName, std::ios::binary);
  std::string     line;
  long long       headerSize = 0;
  while (std::getline(file, line))
  {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos)
    {
      continue;
    }
    const std::string key = Trim(line.substr(0, equals));
    const std::string value = Trim(line.substr(equals + 1));
    if (key == "BinaryData")
    {
      header.binary = IsTrue(value);
    }
    else if (key == "CompressedData")
    {
      header.compressed = IsTrue(value);
    }
    else if (key == "CompressedDataSize")
    {
      header.compressedSize = std::strtoull(value.c_str(), nullptr, 10);
    }
    else if (key == "HeaderSize")
    {
      headerSize = std::atoll(value.c_str());
    }
    else if (key == "ElementDataFile")
    {
      // The last key: the voxels, or nothing, follow.
      if (value == "LOCAL" || value == "Local" || value == "local")
      {
        header.hasOneDataFile = true;
        header.dataFile = fileName;
        header.dataOffset = static_cast<std::uint64_t>(file.tellg());
      }
      else if (value.compare(0, 4, "LIST") != 0 && value.find('%') == std::string::npos)
      {
        header.hasOneDataFile = true;
        header.dataFile = (std::filesystem::path(fileName).parent_path() / value).string();
        // A negative size says that the voxels are at the end of the file.
        header.dataOffset = headerSize > 0 ? static_cast<std::uint64_t>(headerSize) : 0;
      }
      break;
    }
  }
  return header;
}
} // namespace meshimage
