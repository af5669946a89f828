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

#include <algorithm>
#include <numeric>
#include <random>

namespace itk
{
namespace
{
constexpr unsigned int BitsPerAxis = 21;

/** Points of one round over those of all rounds up to it. */
constexpr double      RoundShare = 0.875;
constexpr std::size_t SmallestRound = 16;

/** The position along Hilbert's curve of a cube with BitsPerAxis bits along each axis (after J. Skilling, "Programming
 * the Hilbert curve", 2004). */
std::uint64_t
ComputeHilbertIndex(std::array<std::uint32_t, 3> x)
{
  for (std::uint32_t bit = 1u << (BitsPerAxis - 1); bit > 1; bit >>= 1)
  {
    const std::uint32_t lower = bit - 1;
    for (std::uint32_t & coordinate : x)
    {
      if (coordinate & bit)
      {
        x[0] ^= lower;
      }
      else
      {
        const std::uint32_t change = (x[0] ^ coordinate) & lower;
        x[0] ^= change;
        coordinate ^= change;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t gray = 0;
  for (std::uint32_t bit = 1u << (BitsPerAxis - 1); bit > 1; bit >>= 1)
  {
    if (x[2] & bit)
    {
      gray ^= bit - 1;
    }
  }
  std::uint64_t index = 0;
  for (unsigned int bit = BitsPerAxis; bit-- > 0;)
  {
    for (const std::uint32_t coordinate : x)
    {
      index = index << 1 | ((coordinate ^ gray) >> bit & 1u);
    }
  }
  return index;
}
} // namespace

std::vector<std::uint32_t>
ComputeDelaunayRefinementSpatialOrder(const std::vector<DelaunayRefinementPoint> & points)
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

  struct EntryType
  {
    std::uint64_t key;
    std::uint32_t number;
  };
  std::vector<EntryType> entries(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::array<std::uint32_t, 3> cell;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = static_cast<std::uint32_t>((points[i][axis] - minimum[axis]) * perLength);
    }
    entries[i] = { ComputeHilbertIndex(cell), static_cast<std::uint32_t>(i) };
  }
  std::mt19937_64 random(points.size());
  for (std::size_t i = entries.size(); i > 1; --i)
  {
    std::swap(entries[i - 1], entries[random() % i]);
  }
  const auto precedes = [](const EntryType & a, const EntryType & b) {
    return a.key != b.key ? a.key < b.key : a.number < b.number;
  };
  auto end = entries.end();
  while (end != entries.begin())
  {
    const auto length = static_cast<std::size_t>(end - entries.begin());
    const auto round =
      length <= SmallestRound ? length : static_cast<std::size_t>(RoundShare * static_cast<double>(length));
    std::sort(end - static_cast<std::ptrdiff_t>(round), end, precedes);
    end -= static_cast<std::ptrdiff_t>(round);
  }
  std::vector<std::uint32_t> order(points.size());
  std::transform(entries.begin(), entries.end(), order.begin(), [](const EntryType & entry) { return entry.number; });
  return order;
}
} // end namespace itk
