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
#ifndef itkCommandTestImages_h
#define itkCommandTestImages_h

#include "itkTemporaryFolder.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace itk::DelaunayRefinementTest
{
/** \class TestVolume
 * \brief Voxels of a small image, x fastest.
 */
template <typename TPixel>
struct TestVolume
{
  std::array<int, 3>  size{ { 24, 24, 24 } };
  std::vector<TPixel> voxels = std::vector<TPixel>(24 * 24 * 24, TPixel{});

  TPixel &
  At(int x, int y, int z)
  {
    return voxels[static_cast<std::size_t>((z * size[1] + y) * size[0] + x)];
  }

  void
  AddBall(const std::array<double, 3> & center, double radius, TPixel value)
  {
    for (int z = 0; z < size[2]; ++z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        for (int x = 0; x < size[0]; ++x)
        {
          if (std::hypot(x - center[0], y - center[1], z - center[2]) <= radius)
          {
            this->At(x, y, z) = value;
          }
        }
      }
    }
  }

  std::string
  Bytes() const
  {
    return { reinterpret_cast<const char *>(voxels.data()), voxels.size() * sizeof(TPixel) };
  }
};

/** A ball of label 1. */
inline TestVolume<std::uint8_t>
MakeBall()
{
  TestVolume<std::uint8_t> volume;
  volume.AddBall({ { 11.5, 11.5, 11.5 } }, 8.0, 1);
  return volume;
}

/** A ball of label 200 within a ball of label 3. */
inline TestVolume<std::uint8_t>
MakeNestedBalls()
{
  TestVolume<std::uint8_t> volume;
  volume.AddBall({ { 11.5, 11.5, 11.5 } }, 9.0, 3);
  volume.AddBall({ { 11.5, 11.5, 11.5 } }, 5.0, 200);
  return volume;
}

/** A ball of radius 6 and two of radius 2. */
inline TestVolume<std::uint8_t>
MakeThreeBalls()
{
  TestVolume<std::uint8_t> volume;
  volume.AddBall({ { 8.0, 8.0, 8.0 } }, 6.0, 1);
  volume.AddBall({ { 19.0, 19.0, 19.0 } }, 2.0, 1);
  volume.AddBall({ { 19.0, 19.0, 5.0 } }, 2.0, 1);
  return volume;
}

/** Distance to the center, negated: inside a ball of radius r the values are at and above -r. */
inline TestVolume<float>
MakeDistances()
{
  TestVolume<float> volume;
  for (int z = 0; z < 24; ++z)
  {
    for (int y = 0; y < 24; ++y)
    {
      for (int x = 0; x < 24; ++x)
      {
        volume.At(x, y, z) = static_cast<float>(-std::hypot(x - 11.5, y - 11.5, z - 11.5));
      }
    }
  }
  return volume;
}

template <typename TPixel>
std::string
MetaTypeName()
{
  return std::is_same_v<TPixel, std::uint8_t>   ? "MET_UCHAR"
         : std::is_same_v<TPixel, std::int16_t> ? "MET_SHORT"
         : std::is_same_v<TPixel, std::int64_t> ? "MET_LONG_LONG"
                                                : "MET_FLOAT";
}

/** The header of a MetaImage; \c dataFile is LOCAL where the voxels follow. */
template <typename TPixel>
std::string
MetaHeader(const TestVolume<TPixel> & volume, const std::string & dataFile, const std::string & more = "")
{
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + more +
         "DimSize = " + std::to_string(volume.size[0]) + " " + std::to_string(volume.size[1]) + " " +
         std::to_string(volume.size[2]) + "\nElementType = " + MetaTypeName<TPixel>() +
         "\nElementDataFile = " + dataFile + "\n";
}

template <typename TPixel>
std::string
WriteMetaImage(const std::string & fileName, const TestVolume<TPixel> & volume)
{
  WriteBytes(fileName, MetaHeader(volume, "LOCAL") + volume.Bytes());
  return fileName;
}

inline void
AppendNumber(std::string & bytes, std::uint64_t value, unsigned int count)
{
  for (unsigned int i = 0; i < count; ++i)
  {
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
  }
}

/** The header of a NIfTI-1 image of bytes; the voxels are in one piece with it from byte 352 on, or in another file. */
inline std::string
NiftiHeaderBytes(const std::array<int, 3> & size, bool onePiece)
{
  std::string header(onePiece ? 352 : 348, '\0');
  const auto  put = [&header](std::size_t at, std::uint64_t value, unsigned int count) {
    std::string bytes;
    AppendNumber(bytes, value, count);
    header.replace(at, count, bytes);
  };
  const auto putFloat = [&put](std::size_t at, float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    put(at, bits, 4);
  };
  put(0, 348, 4);
  put(40, 3, 2);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    put(42 + 2 * axis, static_cast<std::uint64_t>(size[axis]), 2);
    putFloat(80 + 4 * axis, 1.0F);
  }
  put(70, 2, 2);
  put(72, 8, 2);
  putFloat(76, 1.0F);
  putFloat(108, onePiece ? 352.0F : 0.0F);
  putFloat(112, 1.0F);
  header.replace(344, 3, onePiece ? "n+1" : "ni1");
  return header;
}

/** A gzip file that only stores the bytes. */
inline std::string
Gzip(const std::string & bytes)
{
  constexpr std::size_t largestBlock = 65535;

  std::string   result("\x1F\x8B\x08\0\0\0\0\0\0\xFF", 10);
  std::uint32_t checksum = 0xFFFFFFFFU;
  for (const char letter : bytes)
  {
    checksum ^= static_cast<unsigned char>(letter);
    for (int bit = 0; bit < 8; ++bit)
    {
      checksum = (checksum >> 1) ^ ((checksum & 1U) != 0U ? 0xEDB88320U : 0U);
    }
  }
  for (std::size_t at = 0; at < bytes.size(); at += largestBlock)
  {
    const std::size_t count = std::min(largestBlock, bytes.size() - at);
    AppendNumber(result, at + count == bytes.size() ? 1 : 0, 1);
    AppendNumber(result, count, 2);
    AppendNumber(result, ~count, 2);
    result += bytes.substr(at, count);
  }
  AppendNumber(result, ~checksum, 4);
  AppendNumber(result, bytes.size(), 4);
  return result;
}
} // namespace itk::DelaunayRefinementTest

#endif
