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
#include "itkDelaunayRefinementInteriorSeeds.h"

#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementGeometry.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
using PointType = DelaunayRefinementPoint;

/** Distance of a seed from other vertices over delta: 2, with room for the rounding of double precision. */
constexpr double Separation = 2.001;

/** Steps of the lattice over delta: to vary a place along x costs less than more rows. */
constexpr std::array<double, 3> Steps{ 0.5, 1.25, 1.25 };

/** Rows of the lattice start at shares of a step that neighbors and diagonals don't have in common. */
constexpr double SharePerRow = 0.6180339887;
constexpr double SharePerLayer = 0.7548776662;

/** A lattice with more bits for each feature vertex would take longer than it saves. */
constexpr double MostBitsPerFeature = 1024.0;

/** More along an axis have no number. */
constexpr double MostPointsPerAxis = 1 << 30;

constexpr std::size_t LeastLayersPerPiece = 8;
constexpr std::size_t PointsBetweenQuestions = 4096;

/** The points of a lattice in a box; a bit for each, rows along x in words. Rows start anywhere within a step, so that
 * hardly any five points are on a sphere. */
class LatticeType
{
public:
  LatticeType(const DelaunayRefinementOracle::BoundsType & bounds, double delta)
    : m_Minimum(bounds.minimum)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Steps[i] = Steps[i] * delta;
      m_PerStep[i] = 1.0 / m_Steps[i];
      m_Extent[i] = (bounds.maximum[i] - bounds.minimum[i]) * m_PerStep[i];
    }
  }

  /** How many it would take; infinite if rows, layers or points of a row would be too many to be numbered. */
  double
  CountBits() const
  {
    const bool areNumbered =
      std::all_of(m_Extent.begin(), m_Extent.end(), [](double extent) { return extent < MostPointsPerAxis; });
    return areNumbered ? (64.0 + m_Extent[0]) * (1.0 + m_Extent[1]) * (1.0 + m_Extent[2])
                       : std::numeric_limits<double>::infinity();
  }

  /** All bits are 0; nothing else but CountBits() may be called before. */
  void
  Start()
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Size[i] = 1 + static_cast<std::int32_t>(m_Extent[i]);
    }
    m_WordsPerRow = (static_cast<std::size_t>(m_Size[0]) + 63) / 64;
    m_Starts.resize(static_cast<std::size_t>(m_Size[1]) * m_Size[2]);
    for (std::size_t row = 0; row < m_Starts.size(); ++row)
    {
      const double turns =
        SharePerRow * static_cast<double>(row % m_Size[1]) + SharePerLayer * static_cast<double>(row / m_Size[1]);
      m_Starts[row] = turns - std::floor(turns);
    }
    m_Words.assign(m_Starts.size() * m_WordsPerRow, 0);
  }

  std::int32_t
  GetNumberOfLayers() const
  {
    return m_Size[2];
  }

  /** Calls \c change with words, and the bits in them of points closer than \c radius to \c center, in some layers. */
  template <typename TChange>
  void
  ChangeWithin(const PointType & center,
               double            radius,
               std::int32_t      beginLayer,
               std::int32_t      endLayer,
               const TChange &   change)
  {
    const std::int32_t firstLayer = std::max(beginLayer, this->GetFirst(center, radius, 2));
    const std::int32_t lastLayer = std::min(endLayer - 1, this->GetLast(center, radius, 2));
    if (firstLayer > lastLayer)
    {
      return;
    }
    const std::int32_t firstRow = this->GetFirst(center, radius, 1);
    const std::int32_t lastRow = this->GetLast(center, radius, 1);
    const double       place = (center[0] - m_Minimum[0]) * m_PerStep[0];
    for (std::int32_t z = firstLayer; z <= lastLayer; ++z)
    {
      const double dz = m_Minimum[2] + z * m_Steps[2] - center[2];
      for (std::int32_t y = firstRow; y <= lastRow; ++y)
      {
        const double dy = m_Minimum[1] + y * m_Steps[1] - center[1];
        const double squaredHalf = radius * radius - dy * dy - dz * dz;
        if (squaredHalf < 0.0)
        {
          continue;
        }
        const double       half = std::sqrt(squaredHalf) * m_PerStep[0];
        const std::size_t  row = this->ToRow(y, z);
        const double       middle = place - m_Starts[row];
        const std::int32_t first = std::max(0, RoundDown(middle - half) + 1);
        const std::int32_t last = std::min(m_Size[0] - 1, RoundDown(middle + half));
        if (first <= last)
        {
          std::uint64_t * const words = m_Words.data() + row * m_WordsPerRow;
          for (std::int32_t word = first >> 6; word <= last >> 6; ++word)
          {
            change(words[word], GetDelaunayRefinementBitsOfRun(first, last, word));
          }
        }
      }
    }
  }

  /** Sets the bits of those that are not set and next to one that is, and clears all others. */
  void
  KeepMargin()
  {
    const std::vector<std::uint64_t> set = m_Words;
    const std::size_t                wordsPerLayer = m_WordsPerRow * m_Size[1];
    const auto                       get = [&set](std::size_t word) { return word < set.size() ? set[word] : 0; };
    for (std::size_t word = 0; word < set.size(); ++word)
    {
      // Those before the first wrap around to beyond the last. Where a row or a layer ends, what is next is elsewhere:
      // a few points more.
      m_Words[word] =
        (set[word] << 1 | set[word] >> 1 | get(word - 1) >> 63 | get(word + 1) << 63 | get(word - m_WordsPerRow) |
         get(word + m_WordsPerRow) | get(word - wordsPerLayer) | get(word + wordsPerLayer)) &
        ~set[word];
    }
  }

  /** Calls \c visitor with the points whose bits are set, in order, as long as it returns true; it may clear bits that
   * follow. */
  template <typename TVisitor>
  void
  Visit(const TVisitor & visitor)
  {
    for (std::size_t row = 0; row < m_Starts.size(); ++row)
    {
      for (std::size_t word = 0; word < m_WordsPerRow; ++word)
      {
        std::uint64_t & bits = m_Words[row * m_WordsPerRow + word];
        while (bits != 0)
        {
          const auto x = static_cast<std::int32_t>(64 * word + FindDelaunayRefinementBit(bits));
          bits &= bits - 1;
          if (x < m_Size[0] && !visitor(PointType{ m_Minimum[0] + (m_Starts[row] + x) * m_Steps[0],
                                                   m_Minimum[1] + static_cast<double>(row % m_Size[1]) * m_Steps[1],
                                                   m_Minimum[2] + static_cast<double>(row / m_Size[1]) * m_Steps[2] }))
          {
            return;
          }
        }
      }
    }
  }

private:
  /** Faster than std::floor() where processors may be old. */
  static std::int32_t
  RoundDown(double value)
  {
    const auto towardsZero = static_cast<std::int32_t>(value);
    return towardsZero - (value < towardsZero ? 1 : 0);
  }

  std::size_t
  ToRow(std::int32_t y, std::int32_t z) const
  {
    return static_cast<std::size_t>(z) * m_Size[1] + y;
  }

  std::int32_t
  GetFirst(const PointType & center, double radius, unsigned int axis) const
  {
    return std::max(0, RoundDown((center[axis] - radius - m_Minimum[axis]) * m_PerStep[axis]) + 1);
  }

  std::int32_t
  GetLast(const PointType & center, double radius, unsigned int axis) const
  {
    return std::min(m_Size[axis] - 1, RoundDown((center[axis] + radius - m_Minimum[axis]) * m_PerStep[axis]));
  }

  PointType                   m_Minimum{};
  PointType                   m_Steps{};
  PointType                   m_PerStep{};
  PointType                   m_Extent{}; // in steps
  std::array<std::int32_t, 3> m_Size{};
  std::size_t                 m_WordsPerRow{ 0 };
  std::vector<double>         m_Starts{}; // of rows, in steps
  std::vector<std::uint64_t>  m_Words{};
};
} // namespace

std::vector<DelaunayRefinementPoint>
FindDelaunayRefinementInteriorSeeds(const DelaunayRefinementOracle &             oracle,
                                    const std::vector<DelaunayRefinementPoint> & features,
                                    double                                       delta,
                                    bool                                         roundToFloat,
                                    DelaunayRefinementThreads &                  threads,
                                    const std::function<bool()> &                keepGoing)
{
  using Geometry = DelaunayRefinementGeometry;
  std::vector<PointType> seeds;
  const auto             bounds = oracle.GetSurfaceBounds();
  LatticeType            lattice(bounds, delta);
  if (!(lattice.CountBits() < MostBitsPerFeature * static_cast<double>(features.size())))
  {
    return seeds;
  }
  double separation = Separation * delta;
  for (unsigned int i = 0; i < 3 && roundToFloat; ++i)
  {
    separation +=
      2.0 * std::numeric_limits<float>::epsilon() * std::max(std::abs(bounds.minimum[i]), std::abs(bounds.maximum[i]));
  }
  lattice.Start();
  const auto        numberOfLayers = static_cast<std::size_t>(lattice.GetNumberOfLayers());
  const std::size_t length =
    DelaunayRefinementThreads::ChoosePieceLength(&threads, numberOfLayers, LeastLayersPerPiece);
  std::atomic<bool> isStopped{ false };
  threads.Run(
    DelaunayRefinementThreads::CountPieces(numberOfLayers, length), [&](std::size_t piece, unsigned int thread) {
      const auto begin = static_cast<std::int32_t>(piece * length);
      const auto end = static_cast<std::int32_t>(std::min(numberOfLayers, (piece + 1) * length));
      for (std::size_t i = 0; i < features.size() && !isStopped.load(std::memory_order_relaxed); ++i)
      {
        if (thread == 0 && i % PointsBetweenQuestions == 0 && !keepGoing())
        {
          isStopped.store(true, std::memory_order_relaxed);
        }
        lattice.ChangeWithin(
          features[i], separation, begin, end, [](std::uint64_t & word, std::uint64_t bits) { word |= bits; });
      }
    });
  lattice.KeepMargin();
  std::size_t numberOfPoints = 0;
  lattice.Visit([&](const PointType & point) {
    if (++numberOfPoints % PointsBetweenQuestions == 0 && !keepGoing())
    {
      isStopped.store(true, std::memory_order_relaxed);
    }
    if (oracle.Classify(point) != 0)
    {
      seeds.push_back(point);
      lattice.ChangeWithin(
        point, separation, 0, lattice.GetNumberOfLayers(), [](std::uint64_t & word, std::uint64_t bits) {
          word &= ~bits;
        });
    }
    return !isStopped.load(std::memory_order_relaxed);
  });
  if (isStopped)
  {
    // Not all vertices may have been heeded.
    return {};
  }
  if (roundToFloat)
  {
    std::transform(seeds.begin(), seeds.end(), seeds.begin(), Geometry::RoundPointToFloat);
  }
  return seeds;
}
} // end namespace itk
