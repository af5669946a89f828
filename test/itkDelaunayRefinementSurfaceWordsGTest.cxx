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
#include "itkDelaunayRefinementSurfaceWords.h"

#include "itkAnalyticOracles.h"
#include "itkMeshDistanceChecks.h"

#include <gtest/gtest.h>

#include <random>

using namespace itk::DelaunayRefinementTest;
using itk::DelaunayRefinementSurfacePatches;
using itk::DelaunayRefinementSurfaceWords;

namespace
{
using CellsType = DelaunayRefinementSurfaceWords::CellsType;
using AxesType = DelaunayRefinementSurfaceWords::AxesType;

constexpr double Delta = 3.0;

/** What rounding may lose. */
constexpr double Margin = 1e-4;

const PointType origin{ 70.0, -90.0, 120.0 };

/** Space turned by a third of a full turn, and along some axes longer. */
const AxesType turned{ PointType{ 0.0, 1.0, 0.0 }, PointType{ 0.0, 0.0, 1.25 }, PointType{ 1.5, 0.0, 0.0 } };

/** Along the axes. */
PointType
ToAxes(const AxesType & axes, const PointType & point)
{
  return { Dot(axes[0], point), Dot(axes[1], point), Dot(axes[2], point) };
}

/** Clears what a vertex covers in the words \c begin to \c end (not included). */
void
CoverFrom(const PointType & vertex, std::size_t begin, std::size_t end, DelaunayRefinementSurfaceWords & words)
{
  DelaunayRefinementSurfaceWords::NumbersType found;
  words.FindWithinReach(words.FindPlace(vertex), begin, end, found);
  words.CoverFrom(words.FindPlace(vertex), found);
}

/** Cell boxes somewhere around the origin, a few of which hold surface. */
CellsType
MakeCells(const AxesType & axes, std::mt19937_64 & random)
{
  std::uniform_real_distribution<double> offset(-12.0, 12.0);
  std::uniform_real_distribution<double> edge(0.3, 1.5);
  CellsType                              cells;
  cells.bits = random() | random();
  cells.first = { { 4, 8, -4 }, 2 };
  cells.corner = Add(ToAxes(axes, origin), { offset(random), offset(random), offset(random) });
  cells.edges = { edge(random), edge(random), edge(random) };
  cells.margin = 0.0;
  return cells;
}

/** From a place along the axes to the nearest point of a cell (0), to its center (1) or to its furthest point (2). */
double
GetDistance(const CellsType & cells, unsigned int bit, const PointType & place, unsigned int which)
{
  const unsigned int numbers[3] = { bit % 4, bit / 4 % 4, bit / 16 };
  double             squared = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double center = std::abs(cells.corner[i] + (numbers[i] + 0.5) * cells.edges[i] - place[i]);
    const double distance = std::max(0.0, center + 0.5 * (static_cast<double>(which) - 1.0) * cells.edges[i]);
    squared += distance * distance;
  }
  return std::sqrt(squared);
}
} // namespace

TEST(DelaunayRefinementSurfaceWords, ClearsTheCellsWithinReach)
{
  std::mt19937_64                        random(1);
  std::uniform_real_distribution<double> offset(-12.0, 12.0);
  std::size_t                            numberOfCovered = 0;
  std::size_t                            numberOfLeft = 0;
  for (unsigned int run = 0; run < 3000; ++run)
  {
    const CellsType                cells = MakeCells(turned, random);
    DelaunayRefinementSurfaceWords words;
    words.Start(origin, turned);
    words.Add(cells, { Delta, Delta });
    std::array<double, 64> centers;
    std::array<double, 64> furthests;
    centers.fill(std::numeric_limits<double>::infinity());
    furthests.fill(std::numeric_limits<double>::infinity());
    for (unsigned int i = 0; i < 4; ++i)
    {
      const PointType vertex = Add(origin, { offset(random), offset(random), offset(random) });
      CoverFrom(vertex, 0, 1, words);
      for (unsigned int bit = 0; bit < 64; ++bit)
      {
        centers[bit] = std::min(centers[bit], GetDistance(cells, bit, ToAxes(turned, vertex), 1));
        furthests[bit] = std::min(furthests[bit], GetDistance(cells, bit, ToAxes(turned, vertex), 2));
      }
    }
    const auto & word = words.GetWord(0);
    for (unsigned int bit = 0; bit < 64; ++bit)
    {
      const bool holdsSurface = cells.bits >> bit & 1u;
      const bool isUncovered = word.uncovered >> bit & 1u;
      const bool isHopeful = word.hopeful >> bit & 1u;
      EXPECT_LE(isUncovered || isHopeful, holdsSurface);
      if (holdsSurface)
      {
        // Never covered without being so; not covered without need only where it is close.
        EXPECT_TRUE(isUncovered || furthests[bit] <= Delta) << furthests[bit];
        EXPECT_TRUE(!isUncovered || furthests[bit] > Delta - Margin) << furthests[bit];
        EXPECT_TRUE(isHopeful || centers[bit] <= Delta) << centers[bit];
        EXPECT_TRUE(!isHopeful || centers[bit] > Delta - Margin) << centers[bit];
        (isUncovered ? numberOfLeft : numberOfCovered) += 1;
      }
    }
  }
  EXPECT_GT(numberOfCovered, 1000u);
  EXPECT_GT(numberOfLeft, 1000u);
}

TEST(DelaunayRefinementSurfaceWords, RoundsTowardsLess)
{
  // A vertex at a corner of cells that reach just as far as it does.
  std::mt19937_64 random(1);
  for (unsigned int run = 0; run < 3000; ++run)
  {
    const CellsType                cells = MakeCells(turned, random);
    const PointType                place = cells.corner;
    const double                   reach = GetDistance(cells, 42, place, 2);
    DelaunayRefinementSurfaceWords words;
    words.Start(origin, turned);
    words.Add(cells, { (1.0 - 1e-9) * reach, (1.0 - 1e-9) * reach });
    CoverFrom({ place[2] / 1.5, place[0], place[1] / 1.25 }, 0, 1, words);
    EXPECT_EQ(words.GetWord(0).uncovered >> 42 & 1u, cells.bits >> 42 & 1u);
  }
}

TEST(DelaunayRefinementSurfaceWords, CellsWithAMarginAreReachedLater)
{
  std::mt19937_64 random(1);
  CellsType       cells = MakeCells(turned, random);
  cells.bits = ~std::uint64_t{ 0 };
  const double reach = GetDistance(cells, 63, cells.corner, 2);
  for (const double margin : { 0.0, 0.1 })
  {
    cells.margin = margin;
    DelaunayRefinementSurfaceWords words;
    words.Start(origin, turned);
    words.Add(cells, { reach + 0.05, reach + 0.05 });
    CoverFrom({ cells.corner[2] / 1.5, cells.corner[0], cells.corner[1] / 1.25 }, 0, 1, words);
    EXPECT_EQ(words.GetWord(0).uncovered, margin == 0.0 ? 0u : std::uint64_t{ 1 } << 63);
  }
}

TEST(DelaunayRefinementSurfaceWords, LeavesOtherWordsAlone)
{
  std::mt19937_64                random(1);
  const CellsType                cells = MakeCells(turned, random);
  DelaunayRefinementSurfaceWords words;
  words.Start(origin, turned);
  for (unsigned int i = 0; i < 5; ++i)
  {
    words.Add(cells, { 100.0, 100.0 });
  }
  CoverFrom(origin, 1, 4, words);
  for (unsigned int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(words.GetWord(i).uncovered, 1 <= i && i < 4 ? 0u : cells.bits);
    EXPECT_EQ(words.GetWord(i).hopeful, 1 <= i && i < 4 ? 0u : cells.bits);
  }
}

TEST(DelaunayRefinementSurfaceWords, BoxesAreThoseOfTheCells)
{
  std::mt19937_64 random(1);
  for (unsigned int run = 0; run < 1000; ++run)
  {
    const CellsType                cells = MakeCells(turned, random);
    const std::uint64_t            some = random() & random() & random() & random();
    DelaunayRefinementSurfaceWords words;
    words.Start(origin, turned);
    words.Add(cells, { Delta, Delta });
    if (some == 0)
    {
      continue;
    }
    PointType minimum{ 1e9, 1e9, 1e9 };
    PointType maximum{ -1e9, -1e9, -1e9 };
    for (unsigned int bit = 0; bit < 64; ++bit)
    {
      for (unsigned int corner = 0; corner < 8 && (some >> bit & 1u); ++corner)
      {
        const double    place[3] = { cells.corner[0] + (bit % 4 + (corner & 1u)) * cells.edges[0],
                                     cells.corner[1] + (bit / 4 % 4 + (corner >> 1 & 1u)) * cells.edges[1],
                                     cells.corner[2] + (bit / 16 + (corner >> 2)) * cells.edges[2] };
        const PointType point{ place[2] / 1.5, place[0], place[1] / 1.25 };
        for (unsigned int i = 0; i < 3; ++i)
        {
          minimum[i] = std::min(minimum[i], point[i]);
          maximum[i] = std::max(maximum[i], point[i]);
        }
      }
    }
    PointType center;
    PointType halfExtents;
    words.GetBox(words.GetWord(0), some, center, halfExtents);
    for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(center[i] - halfExtents[i], minimum[i], Margin);
      EXPECT_NEAR(center[i] + halfExtents[i], maximum[i], Margin);
    }
  }
}

TEST(DelaunayRefinementSurfaceWords, CellsComeBackWithinTheirMargin)
{
  std::mt19937_64 random(1);
  for (unsigned int run = 0; run < 100; ++run)
  {
    const CellsType                cells = MakeCells(turned, random);
    DelaunayRefinementSurfaceWords words;
    words.Start({ 0.0, 0.0, 0.0 }, turned);
    words.Add(cells, { Delta, Delta });
    const CellsType found = words.GetCells(words.GetWord(0), 5);
    EXPECT_EQ(found.bits, 5u);
    EXPECT_EQ(found.first.index, cells.first.index);
    EXPECT_EQ(found.first.level, cells.first.level);
    EXPECT_LT(found.margin, 10.0 * Margin);
    for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_LE(std::abs(found.corner[i] - cells.corner[i]) + 4.0 * std::abs(found.edges[i] - cells.edges[i]),
                found.margin);
    }
  }
}

TEST(DelaunayRefinementSurfaceWords, APatchIsItsOnlyCellUnlessTheOracleKnowsMore)
{
  const BallOracle               ball(origin, 5.0);
  const auto                     patches = ball.GetSurfacePatches();
  DelaunayRefinementSurfaceWords words;
  words.Start(patches.GetOrigin(), ball.GetCellAxes());
  ASSERT_GT(patches.GetSize(), 0u);
  for (std::size_t i = 0; i < patches.GetSize(); ++i)
  {
    const auto patch = patches.Get(i);
    words.Add(ball.GetCellsOfPatch(patch), { Delta, Delta });
    const auto & word = words.GetWord(i);
    EXPECT_EQ(word.uncovered, 1u);
    DelaunayRefinementSurfacePatches cells(patch.center);
    ball.AppendCells(words.GetCells(word, 1), cells);
    ASSERT_EQ(cells.GetSize(), 1u);
    const auto cell = cells.Get(0);
    EXPECT_EQ(cell.identifier.index, patch.identifier.index);
    EXPECT_EQ(cell.identifier.level, patch.identifier.level);
    EXPECT_NEAR(cell.radius, patch.radius, Margin);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LE(std::abs(cell.center[axis] - patch.center[axis]) + patch.halfExtents[axis], cell.halfExtents[axis]);
      EXPECT_NEAR(cell.halfExtents[axis], patch.halfExtents[axis], Margin);
    }
  }
}
