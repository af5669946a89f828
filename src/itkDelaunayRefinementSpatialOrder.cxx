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
#include "itkDelaunayRefinementSpatialOrder.h"

#include "itkDelaunayRefinementThreads.h"

#include <algorithm>

namespace itk
{
namespace
{
/** Points of the first round that are not chosen at random. */
constexpr std::size_t NumberOfFirst = 8;

/** A round has three times as many points as all before it. */
constexpr unsigned int BitsOfRound = 2;

/** Ten bits, two zeros before each. */
std::uint32_t
Spread(std::uint32_t bits)
{
  bits = (bits | bits << 16) & 0x030000FFu;
  bits = (bits | bits << 8) & 0x0300F00Fu;
  bits = (bits | bits << 4) & 0x030C30C3u;
  return (bits | bits << 2) & 0x09249249u;
}

/** The position along Hilbert's curve of a cube with \c bitsPerAxis bits along each axis, ten at most (after J.
 * Skilling, "Programming the Hilbert curve", 2004). */
std::uint32_t
ComputeHilbertIndex(std::array<std::uint32_t, 3> x, unsigned int bitsPerAxis)
{
  // Which bits are set no processor foresees: all is done for either case.
  for (unsigned int place = bitsPerAxis - 1; place > 0; --place)
  {
    const std::uint32_t lower = (1u << place) - 1;
    for (std::uint32_t & coordinate : x)
    {
      const std::uint32_t isSet = 0u - (coordinate >> place & 1u);
      const std::uint32_t change = (x[0] ^ coordinate) & lower & ~isSet;
      coordinate ^= change;
      x[0] ^= change | (lower & isSet);
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t gray = 0;
  for (unsigned int place = bitsPerAxis - 1; place > 0; --place)
  {
    gray ^= (0u - (x[2] >> place & 1u)) & ((1u << place) - 1);
  }
  return Spread(x[0] ^ gray) << 2 | Spread(x[1] ^ gray) << 1 | Spread(x[2] ^ gray);
}

/** Random bits that depend on a number alone (S. Vigna, "splitmix64", 2015). */
std::uint64_t
Scramble(std::uint64_t number)
{
  number += 0x9E3779B97F4A7C15u;
  number = (number ^ number >> 30) * 0xBF58476D1CE4E5B9u;
  number = (number ^ number >> 27) * 0x94D049BB133111EBu;
  return number ^ number >> 31;
}

/** The round of a point that is not among the first. */
unsigned int
ChooseRound(std::size_t number)
{
  unsigned int  round = DelaunayRefinementSpatialOrder::NumberOfRounds - 1;
  std::uint64_t random = Scramble(number);
  while (round > 0 && random % (1u << BitsOfRound) == 0)
  {
    random >>= BitsOfRound;
    --round;
  }
  return round;
}
} // namespace

DelaunayRefinementSpatialOrder::DelaunayRefinementSpatialOrder(const std::vector<DelaunayRefinementPoint> & points,
                                                               DelaunayRefinementThreads *                  threads)
  : m_Entries(points.size())
{
  DelaunayRefinementPoint minimum;
  minimum.fill(std::numeric_limits<double>::infinity());
  DelaunayRefinementPoint maximum;
  maximum.fill(-std::numeric_limits<double>::infinity());
  for (const auto & point : points)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      minimum[i] = std::min(minimum[i], point[i]);
      maximum[i] = std::max(maximum[i], point[i]);
    }
  }
  double extent = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    extent = std::max(extent, maximum[i] - minimum[i]);
  }
  const double perLength = extent > 0.0 ? ((1u << BitsPerAxis) - 1) / extent : 0.0;

  DelaunayRefinementArray<EntryType> entries(points.size());
  constexpr std::size_t              pointsPerPiece = 4096;
  const auto                         computeKeys = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      std::array<std::uint32_t, 3> cell;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        cell[axis] = static_cast<std::uint32_t>((points[i][axis] - minimum[axis]) * perLength);
      }
      const unsigned int round = i < NumberOfFirst ? 0 : ChooseRound(i);
      entries[i] = { round << BitsOfCurve | ComputeHilbertIndex(cell, BitsPerAxis), static_cast<std::uint32_t>(i) };
    }
  };
  DelaunayRefinementThreads::RunPieces(threads, points.size(), pointsPerPiece, computeKeys);

  // By digits, the last ones first.
  constexpr unsigned int bitsPerDigit = 11;
  for (unsigned int shift = 0; shift < 32; shift += bitsPerDigit)
  {
    std::array<std::size_t, (1u << bitsPerDigit) + 1> places{};
    const auto digit = [&](const EntryType & entry) { return entry.key >> shift & ((1u << bitsPerDigit) - 1); };
    for (const EntryType & entry : entries)
    {
      ++places[digit(entry) + 1];
    }
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      places[i] += places[i - 1];
    }
    for (const EntryType & entry : entries)
    {
      m_Entries[places[digit(entry)]++] = entry;
    }
    m_Entries.swap(entries);
  }
  m_Entries.swap(entries);
}

std::size_t
DelaunayRefinementSpatialOrder::GetBegin(unsigned int round) const
{
  const auto found = std::partition_point(
    m_Entries.begin(), m_Entries.end(), [round](const EntryType & entry) { return entry.key >> BitsOfCurve < round; });
  return static_cast<std::size_t>(found - m_Entries.begin());
}
} // end namespace itk
