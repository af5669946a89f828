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
#include "MeshImageTiffHeader.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace meshimage
{
namespace
{
/** \class TiffPages
 * \brief Reads the pages of a TIFF file (TIFF 6.0, section 2) or of a BigTIFF file, whose offsets have 64 bits. */
class TiffPages
{
public:
  explicit TiffPages(const std::string & fileName)
    : m_File(fileName, std::ios::binary)
  {
    std::error_code error;
    m_Size = std::filesystem::file_size(fileName, error);
  }

  bool
  AreComplete()
  {
    m_BigEndian = this->ReadNumber(0, 1) == 'M';
    m_Big = this->ReadNumber(2, 2) == 43;
    std::uint64_t page = m_Big ? this->ReadNumber(8, 8) : this->ReadNumber(4, 4);
    // Pages that point to each other in a circle cannot be more than fit into the file.
    for (std::uint64_t count = 0; page != 0 && m_Complete && count <= m_Size; ++count)
    {
      page = this->CheckPage(page);
    }
    return m_Complete;
  }

private:
  std::uint64_t
  ReadNumber(std::uint64_t offset, unsigned int length)
  {
    unsigned char bytes[8] = {};
    if (offset > m_Size || m_Size - offset < length)
    {
      m_Complete = false;
      return 0;
    }
    m_File.seekg(static_cast<std::streamoff>(offset));
    m_File.read(reinterpret_cast<char *>(bytes), length);
    std::uint64_t value = 0;
    for (unsigned int i = 0; i < length; ++i)
    {
      value |= std::uint64_t{ bytes[m_BigEndian ? length - 1 - i : i] } << (8 * i);
    }
    return value;
  }

  /** The values of a field, which are in its entry if they fit there. */
  std::vector<std::uint64_t>
  ReadValues(std::uint64_t entry)
  {
    constexpr unsigned int shortType = 3;
    constexpr unsigned int long8Type = 16;

    const auto          type = this->ReadNumber(entry + 2, 2);
    const unsigned int  length = type == shortType ? 2 : type == long8Type ? 8 : 4;
    const unsigned int  offsetLength = m_Big ? 8 : 4;
    const auto          count = this->ReadNumber(entry + 4, offsetLength);
    const std::uint64_t inEntry = entry + 4 + offsetLength;
    const std::uint64_t first = count * length <= offsetLength ? inEntry : this->ReadNumber(inEntry, offsetLength);
    std::vector<std::uint64_t> values;
    for (std::uint64_t i = 0; i < count && m_Complete; ++i)
    {
      values.push_back(this->ReadNumber(first + i * length, length));
    }
    return values;
  }

  /** Returns the offset of the next page, 0 after the last. */
  std::uint64_t
  CheckPage(std::uint64_t page)
  {
    constexpr std::uint64_t stripOffsets = 273;
    constexpr std::uint64_t stripLengths = 279;
    constexpr std::uint64_t tileOffsets = 324;
    constexpr std::uint64_t tileLengths = 325;

    const std::uint64_t        entryLength = m_Big ? 20 : 12;
    const std::uint64_t        numberOfEntries = this->ReadNumber(page, m_Big ? 8 : 2);
    const std::uint64_t        firstEntry = page + (m_Big ? 8 : 2);
    std::vector<std::uint64_t> offsets;
    std::vector<std::uint64_t> lengths;
    for (std::uint64_t i = 0; i < numberOfEntries && m_Complete; ++i)
    {
      const std::uint64_t entry = firstEntry + i * entryLength;
      const std::uint64_t tag = this->ReadNumber(entry, 2);
      if (tag == stripOffsets || tag == tileOffsets)
      {
        offsets = this->ReadValues(entry);
      }
      else if (tag == stripLengths || tag == tileLengths)
      {
        lengths = this->ReadValues(entry);
      }
    }
    for (std::size_t i = 0; i < std::min(offsets.size(), lengths.size()); ++i)
    {
      m_Complete = m_Complete && offsets[i] <= m_Size && lengths[i] <= m_Size - offsets[i];
    }
    return m_Complete ? this->ReadNumber(firstEntry + numberOfEntries * entryLength, m_Big ? 8 : 4) : 0;
  }

  std::ifstream m_File;
  std::uint64_t m_Size{ 0 };
  bool          m_BigEndian{ false };
  bool          m_Big{ false };
  bool          m_Complete{ true };
};
} // namespace

bool
IsCompleteTiffFile(const std::string & fileName)
{
  return TiffPages(fileName).AreComplete();
}
} // namespace meshimage
