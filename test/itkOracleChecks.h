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
#ifndef itkOracleChecks_h
#define itkOracleChecks_h

#include "itkDelaunayRefinementOracle.h"
#include "itkMeshDistanceChecks.h"

#include <gtest/gtest.h>

#include <random>

namespace itk::DelaunayRefinementTest
{
/** Points of the surface such that every surface point is within \c reach of one of them, from the oracle's patches. */
inline std::vector<PointType>
SampleSurface(const DelaunayRefinementOracle & oracle, double reach)
{
  std::vector<PointType>                   samples;
  DelaunayRefinementOracle::SurfacePatches patches = oracle.GetSurfacePatches();
  while (patches.GetSize() > 0)
  {
    DelaunayRefinementOracle::SurfacePatches parts(patches.GetOrigin());
    for (std::size_t i = 0; i < patches.GetSize(); ++i)
    {
      const auto patch = patches.Get(i);
      if (2.0 * patch.radius > reach)
      {
        oracle.SplitSurfacePatch(patch.identifier, parts);
        continue;
      }
      PointType point;
      if (oracle.FindPointOfPatch(patch.identifier, point))
      {
        samples.push_back(point);
      }
    }
    patches = std::move(parts);
  }
  return samples;
}

/** Where Classify() changes between two points, by bisection. */
inline PointType
BisectSurface(const DelaunayRefinementOracle & oracle, PointType from, PointType to)
{
  const auto start = oracle.Classify(from);
  for (unsigned int i = 0; i < 60; ++i)
  {
    const PointType middle = Scale(Add(from, to), 0.5);
    (oracle.Classify(middle) == start ? from : to) = middle;
  }
  return to;
}

/** The first change of Classify() along a segment looked at in steps. */
inline bool
FindFirstChange(const DelaunayRefinementOracle & oracle,
                const PointType &                from,
                const PointType &                to,
                unsigned int                     numberOfSteps,
                PointType &                      change)
{
  PointType previous = from;
  for (unsigned int i = 1; i <= numberOfSteps; ++i)
  {
    const PointType next = Add(from, Scale(Subtract(to, from), static_cast<double>(i) / numberOfSteps));
    if (oracle.Classify(previous) != oracle.Classify(next))
    {
      change = BisectSurface(oracle, previous, next);
      return true;
    }
    previous = next;
  }
  return false;
}

/** A box around the surface with some room. */
inline BoxType
MakeRoomyBox(const DelaunayRefinementOracle & oracle)
{
  const auto      bounds = oracle.GetSurfaceBounds();
  const PointType room = Scale(Subtract(bounds.maximum, bounds.minimum), 0.11);
  return { Subtract(bounds.minimum, room), Add(bounds.maximum, room) };
}

/** Points of the surface, from Classify() alone: the changes along the lines of a grid. */
inline std::vector<PointType>
SampleSurfaceByClassify(const DelaunayRefinementOracle & oracle, unsigned int linesPerAxis)
{
  const BoxType          box = MakeRoomyBox(oracle);
  const PointType        size = Subtract(box.maximum, box.minimum);
  std::vector<PointType> samples;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    for (unsigned int i = 0; i < linesPerAxis; ++i)
    {
      for (unsigned int j = 0; j < linesPerAxis; ++j)
      {
        const auto pointAt = [&](unsigned int k) {
          std::array<double, 3> share;
          share[axis] = k;
          share[(axis + 1) % 3] = i + 0.5;
          share[(axis + 2) % 3] = j + 0.5;
          PointType point;
          for (unsigned int c = 0; c < 3; ++c)
          {
            point[c] = box.minimum[c] + size[c] * share[c] / linesPerAxis;
          }
          return point;
        };
        for (unsigned int k = 0; k < linesPerAxis; ++k)
        {
          if (oracle.Classify(pointAt(k)) != oracle.Classify(pointAt(k + 1)))
          {
            samples.push_back(BisectSurface(oracle, pointAt(k), pointAt(k + 1)));
          }
        }
      }
    }
  }
  return samples;
}

/** The same points for the same seed. */
inline std::vector<PointType>
MakeRandomPoints(const BoxType & box, std::size_t count, unsigned int seed)
{
  std::mt19937           generator(seed);
  std::vector<PointType> points(count);
  for (PointType & point : points)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double share = static_cast<double>(generator()) / static_cast<double>(std::mt19937::max());
      point[i] = box.minimum[i] + share * (box.maximum[i] - box.minimum[i]);
    }
  }
  return points;
}

/** There are inside and outside within \c tolerance of the point. */
inline bool
IsOnSurface(const DelaunayRefinementOracle & oracle, const PointType & point, double tolerance)
{
  // Many directions, as the object may be a narrow cone here; in a spiral from pole to pole.
  constexpr int    numberOfDirections = 1000;
  constexpr double goldenAngle = 2.399963229728653;
  const bool       isInside = oracle.Classify(point) != 0;
  for (int i = 0; i < numberOfDirections; ++i)
  {
    const double    height = 1.0 - (2.0 * i + 1.0) / numberOfDirections;
    const double    radius = std::sqrt(1.0 - height * height);
    const PointType direction{ radius * std::cos(goldenAngle * i), radius * std::sin(goldenAngle * i), height };
    if ((oracle.Classify(Add(point, Scale(direction, tolerance))) != 0) != isInside)
    {
      return true;
    }
  }
  return false;
}

/** FindClosestSurfacePoint() answers with points on the surface, none of \c surface being closer by more than
 * \c tolerance, and does not answer if the surface is beyond the maximum distance. */
inline void
ExpectClosestSurfacePoints(const DelaunayRefinementOracle & oracle,
                           const std::vector<PointType> &   queries,
                           const std::vector<PointType> &   surface,
                           double                           tolerance,
                           double                           surfaceTolerance)
{
  const PointLocator locator(surface);
  for (const PointType & query : queries)
  {
    PointType closest;
    ASSERT_TRUE(oracle.FindClosestSurfacePoint(query, std::numeric_limits<double>::infinity(), closest));
    const double distance = Distance(query, closest);
    EXPECT_TRUE(IsOnSurface(oracle, closest, surfaceTolerance))
      << "closest to " << ::testing::PrintToString(query) << " is " << ::testing::PrintToString(closest);
    EXPECT_LE(distance, locator.FindDistance(query) + tolerance) << "at " << ::testing::PrintToString(query);

    PointType again;
    EXPECT_TRUE(oracle.FindClosestSurfacePoint(query, distance + tolerance, again));
    EXPECT_NEAR(Distance(query, again), distance, tolerance);
    if (distance > 2.0 * tolerance)
    {
      EXPECT_FALSE(oracle.FindClosestSurfacePoint(query, distance - 2.0 * tolerance, again))
        << "at " << ::testing::PrintToString(query);
    }
  }
}

/** FindFirstCrossing() from each point to the next agrees with small steps along the segment. Segments with less than
 * \c shortest between two changes may be seen differently; at most one in fifty. */
inline void
ExpectFirstCrossings(const DelaunayRefinementOracle & oracle,
                     const std::vector<PointType> &   ends,
                     unsigned int                     numberOfSteps,
                     double                           tolerance)
{
  std::size_t numberOfCrossings = 0;
  std::size_t numberOfMisses = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    PointType  crossing{};
    PointType  change{};
    const bool isFound = oracle.FindFirstCrossing(ends[i], ends[i + 1], crossing);
    const bool isChanged = FindFirstChange(oracle, ends[i], ends[i + 1], numberOfSteps, change);
    if (isFound)
    {
      ++numberOfCrossings;
      EXPECT_TRUE(IsOnSurface(oracle, crossing, tolerance)) << ::testing::PrintToString(crossing);
      EXPECT_NEAR(
        Distance(ends[i], crossing) + Distance(crossing, ends[i + 1]), Distance(ends[i], ends[i + 1]), tolerance);
    }
    if (oracle.Classify(ends[i]) != oracle.Classify(ends[i + 1]))
    {
      EXPECT_TRUE(isFound);
    }
    // Steps miss a change and its reversal between two of them; the oracle then is first.
    if (isChanged)
    {
      EXPECT_TRUE(isFound);
      EXPECT_LE(Distance(ends[i], crossing), Distance(ends[i], change) + tolerance);
    }
    numberOfMisses += isFound != isChanged || (isFound && Distance(crossing, change) > tolerance) ? 1 : 0;
  }
  EXPECT_GT(numberOfCrossings, ends.size() / 10);
  EXPECT_LE(numberOfMisses, ends.size() / 50);
}

/** The cells of a patch, whole and split once or twice, are the parts of its parts. */
inline void
ExpectCellsArePartsOfParts(const DelaunayRefinementOracle & oracle)
{
  using PatchesType = DelaunayRefinementOracle::SurfacePatches;
  const auto getIndexes = [](const PatchesType & patches) {
    std::vector<std::array<std::int32_t, 3>> indexes;
    for (std::size_t i = 0; i < patches.GetSize(); ++i)
    {
      indexes.push_back(patches.GetIdentifier(i).index);
    }
    std::sort(indexes.begin(), indexes.end());
    return indexes;
  };
  // Distances are no shorter along the axes.
  const auto                             axes = oracle.GetCellAxes();
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (unsigned int i = 0; i < 1000; ++i)
  {
    const PointType vector{ coordinate(random), coordinate(random), coordinate(random) };
    const PointType along{ Dot(axes[0], vector), Dot(axes[1], vector), Dot(axes[2], vector) };
    EXPECT_GE(Norm(along), (1.0 - 1e-12) * Norm(vector));
  }
  PatchesType patches = oracle.GetSurfacePatches();
  for (unsigned int split = 0; split < 3; ++split)
  {
    SCOPED_TRACE("after splitting " + std::to_string(split) + " times");
    PatchesType parts(patches.GetOrigin());
    std::size_t numberOfDifferences = 0;
    std::size_t numberOfStrayCells = 0;
    for (std::size_t i = 0; i < patches.GetSize(); ++i)
    {
      const auto  patch = patches.Get(i);
      const auto  cells = oracle.GetCellsOfPatch(patch);
      PatchesType found(patch.center);
      oracle.AppendCells(cells, found);
      PatchesType expected(patch.center);
      PatchesType halves(patch.center);
      oracle.SplitSurfacePatch(patch.identifier, halves);
      for (std::size_t j = 0; j < halves.GetSize(); ++j)
      {
        oracle.SplitSurfacePatch(halves.GetIdentifier(j), expected);
      }
      numberOfDifferences += getIndexes(found) != getIndexes(expected) ? 1 : 0;
      for (std::size_t j = 0; j < found.GetSize(); ++j)
      {
        const auto cell = found.Get(j);
        bool       isStray = cell.identifier.level != cells.first.level;
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          const double place = (Dot(axes[axis], cell.center) - cells.corner[axis]) / cells.edges[axis] -
                               (cell.identifier.index[axis] - cells.first.index[axis]);
          isStray = isStray || place < -1e-4 || place > 1.0 + 1e-4;
        }
        const double radius = 0.5 * Norm(cells.edges);
        isStray = isStray || cell.radius > (1.0 + 1e-4) * radius;
        numberOfStrayCells += isStray ? 1 : 0;
      }
      oracle.SplitSurfacePatch(patch.identifier, parts);
    }
    EXPECT_EQ(numberOfDifferences, 0u);
    EXPECT_EQ(numberOfStrayCells, 0u);
    patches = std::move(parts);
  }
}

/** The patches that hold a point, whole and split a few times, cover the surface. */
inline void
ExpectPatchesCoverSurface(const DelaunayRefinementOracle & oracle,
                          const std::vector<PointType> &   surface,
                          double                           tolerance)
{
  using PatchType = DelaunayRefinementSurfacePatches::PatchType;
  DelaunayRefinementOracle::SurfacePatches patches = oracle.GetSurfacePatches();
  ASSERT_GT(patches.GetSize(), 0u);
  for (unsigned int split = 0; split < 3; ++split)
  {
    SCOPED_TRACE("after splitting " + std::to_string(split) + " times");
    std::vector<PatchType>                   filled;
    std::vector<BoxType>                     boxes;
    DelaunayRefinementOracle::SurfacePatches parts(patches.GetOrigin());
    std::size_t                              numberOfStrayPoints = 0;
    std::size_t                              numberOfStrayParts = 0;
    double                                   largestPatch = 0.0;
    double                                   largestPart = 0.0;
    for (std::size_t number = 0; number < patches.GetSize(); ++number)
    {
      const PatchType patch = patches.Get(number);
      PointType       point;
      if (oracle.FindPointOfPatch(patch.identifier, point))
      {
        filled.push_back(patch);
        boxes.push_back({ Subtract(patch.center, patch.halfExtents), Add(patch.center, patch.halfExtents) });
        const bool isStray = Distance(point, patch.center) > patch.radius + tolerance;
        numberOfStrayPoints += isStray || !IsOnSurface(oracle, point, tolerance) ? 1 : 0;
      }
      const std::size_t first = parts.GetSize();
      oracle.SplitSurfacePatch(patch.identifier, parts);
      largestPatch = std::max(largestPatch, patch.radius);
      for (std::size_t i = first; i < parts.GetSize(); ++i)
      {
        const PatchType part = parts.Get(i);
        const bool      isStray = Distance(part.center, patch.center) > patch.radius + tolerance;
        numberOfStrayParts += isStray || part.radius > patch.radius + tolerance ? 1 : 0;
        largestPart = std::max(largestPart, part.radius);
      }
    }
    EXPECT_EQ(numberOfStrayPoints, 0u);
    EXPECT_EQ(numberOfStrayParts, 0u);
    // One by one, parts need not be smaller than a whole that was tight.
    EXPECT_LE(largestPart, 0.75 * largestPatch);

    const SpatialGrid grid(boxes);
    std::size_t       numberOfUncoveredPoints = 0;
    for (const PointType & point : surface)
    {
      bool isCovered = false;
      grid.ForEachItem({ point, point }, [&](std::size_t i) {
        isCovered = isCovered || Distance(point, filled[i].center) <= filled[i].radius + tolerance;
      });
      numberOfUncoveredPoints += isCovered ? 0 : 1;
    }
    EXPECT_EQ(numberOfUncoveredPoints, 0u);
    patches = std::move(parts);
  }
}

/** MayIntersectBox() is true for boxes around points of the surface, and false for some of those without any. */
inline void
ExpectBoxBound(const DelaunayRefinementOracle & oracle, const std::vector<PointType> & surface)
{
  const BoxType      roomyBox = MakeRoomyBox(oracle);
  const auto         centers = MakeRandomPoints(roomyBox, surface.size(), 4711);
  const double       largest = 0.2 * Distance(roomyBox.minimum, roomyBox.maximum);
  const PointLocator locator(surface);
  std::size_t        numberOfEmptyBoxes = 0;
  std::size_t        numberOfFalse = 0;
  for (std::size_t i = 0; i < surface.size(); ++i)
  {
    const double    width = largest * static_cast<double>(i + 1) / static_cast<double>(surface.size());
    const PointType offset{ width, 0.3 * width, 0.7 * width };
    EXPECT_TRUE(oracle.MayIntersectBox({ Subtract(surface[i], offset), Add(surface[i], Scale(offset, 0.1)) }));
    if (locator.FindDistance(centers[i]) > 3.0 * width)
    {
      ++numberOfEmptyBoxes;
      numberOfFalse += oracle.MayIntersectBox({ Subtract(centers[i], offset), Add(centers[i], offset) }) ? 0 : 1;
    }
  }
  EXPECT_GT(numberOfFalse, numberOfEmptyBoxes / 2);
}
} // end namespace itk::DelaunayRefinementTest

#endif
