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
#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementBricks.h"
#include "itkDelaunayRefinementVoxelComponents.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using itk::DelaunayRefinementBricks;
using itk::DelaunayRefinementRegionChanges;
using itk::DelaunayRefinementVoxelComponents;
using itk::DelaunayRefinementVoxelMask;

namespace
{
/** Blocks of some size, each with its first voxel at one in so many. */
DelaunayRefinementVoxelMask
MakeMask(const DelaunayRefinementVoxelMask::SizeType & size, unsigned int oneIn, int block, std::mt19937_64 & random)
{
  DelaunayRefinementVoxelMask mask(size);
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      for (std::int32_t x = 0; x < size[0]; ++x)
      {
        const std::int32_t number = random() % oneIn == 0 ? block * block * block : 0;
        for (std::int32_t i = 0; i < number; ++i)
        {
          const std::int32_t to[3] = { x + i % block, y + i / block % block, z + i / block / block };
          if (to[0] < size[0] && to[1] < size[1] && to[2] < size[2])
          {
            mask.Set(to[0], to[1], to[2], true);
          }
        }
      }
    }
  }
  return mask;
}

/** Of regions in which one in eight voxels differs from the others. */
DelaunayRefinementRegionChanges
MakeChanges(const DelaunayRefinementVoxelMask::SizeType & size, std::mt19937_64 & random)
{
  std::vector<int> values(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
  for (int & value : values)
  {
    value = random() % 8 == 0 ? 1 : 0;
  }
  DelaunayRefinementRegionChanges changes(size);
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      const std::size_t row = (static_cast<std::size_t>(z) * size[1] + y) * size[0];
      changes.SetRow(y, z, values.data() + row, size[0], static_cast<std::size_t>(size[0]) * size[1]);
    }
  }
  return changes;
}

void
ExpectSameBricks(const DelaunayRefinementBricks & one, const DelaunayRefinementBricks & other)
{
  EXPECT_EQ(one.GetActiveBricks(), other.GetActiveBricks());
  EXPECT_EQ(one.GetFirstCell(), other.GetFirstCell());
  EXPECT_EQ(one.GetLastCell(), other.GetLastCell());
  EXPECT_EQ(one.CountActiveCells(), other.CountActiveCells());
  const auto & size = one.GetLevelSize(0);
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      for (std::int32_t x = 0; x < size[0]; ++x)
      {
        EXPECT_EQ(one.GetKind({ x, y, z }), other.GetKind({ x, y, z }));
        EXPECT_EQ(one.GetCells({ x, y, z }), other.GetCells({ x, y, z }));
      }
    }
  }
}
} // namespace

TEST(DelaunayRefinementBits, SixteenNumbersAreCompared)
{
  std::mt19937_64                       random(1);
  std::uniform_real_distribution<float> number(-2.0f, 2.0f);
  for (unsigned int round = 0; round < 1000; ++round)
  {
    const float least = round % 100 == 0 ? std::numeric_limits<float>::quiet_NaN() : number(random);
    float       numbers[16];
    for (float & own : numbers)
    {
      own = random() % 8 == 0 ? least : random() % 16 == 0 ? std::numeric_limits<float>::quiet_NaN() : number(random);
    }
    std::uint32_t expected = 0;
    for (unsigned int i = 0; i < 16; ++i)
    {
      expected |= numbers[i] >= least ? 1u << i : 0u;
    }
    EXPECT_EQ(itk::FindDelaunayRefinementNumbersFrom(least, numbers), expected);
  }
}

TEST(DelaunayRefinementVoxelMask, RowsAreThoseOfSingleVoxels)
{
  std::mt19937_64 random(2);
  for (const std::int32_t width : { 1, 2, 61, 62, 63, 64, 65, 66, 100, 126, 127, 128, 129, 130, 200 })
  {
    SCOPED_TRACE("width " + std::to_string(width));
    const DelaunayRefinementVoxelMask::SizeType size{ width, 3, 2 };
    const DelaunayRefinementVoxelMask           expected = MakeMask(size, 3, 1, random);
    DelaunayRefinementVoxelMask                 mask(size);
    for (std::int32_t row = 0; row < 6; ++row)
    {
      mask.SetRow(row % 3, row / 3, [&](std::int32_t x) { return expected.Get(x, row % 3, row / 3); });
    }
    for (std::int32_t z = -1; z <= 2; ++z)
    {
      for (std::int32_t y = -1; y <= 3; ++y)
      {
        for (std::int32_t x = -1; x <= width; ++x)
        {
          EXPECT_EQ(mask.Get(x, y, z), expected.Get(x, y, z)) << x << ' ' << y << ' ' << z;
        }
        EXPECT_EQ(mask.IsRowEmpty(y + 1, z + 1), expected.IsRowEmpty(y + 1, z + 1));
      }
    }
  }
}

TEST(DelaunayRefinementBricks, AreTheSameAfterRemovalsAsFromTheStart)
{
  std::mt19937_64 random(3);
  for (unsigned int round = 0; round < 24; ++round)
  {
    SCOPED_TRACE("round " + std::to_string(round));
    const DelaunayRefinementVoxelMask::SizeType size{ 70 + static_cast<int>(round), 30, 25 };
    DelaunayRefinementVoxelMask             mask = MakeMask(size, round % 2 == 0 ? 400 : 2000, 1 + round % 7, random);
    const DelaunayRefinementRegionChanges   changes = MakeChanges(size, random);
    const DelaunayRefinementRegionChanges * own = round % 3 == 0 ? &changes : nullptr;
    DelaunayRefinementVoxelComponents       components(mask);
    DelaunayRefinementBricks                bricks(mask, own, nullptr);
    // Some, and then others.
    for (unsigned int removal = 0; removal < 2; ++removal)
    {
      std::vector<bool>                              isRemoved;
      std::vector<DelaunayRefinementBricks::BoxType> boxes;
      for (const auto & info : components.GetComponents())
      {
        isRemoved.push_back(random() % 2 == 0);
        if (isRemoved.back())
        {
          boxes.push_back({ info.minimum, info.maximum });
        }
      }
      components.Remove(isRemoved, mask);
      bricks.Update(mask, own, boxes);
      ExpectSameBricks(bricks, DelaunayRefinementBricks(mask, own, nullptr));
    }
  }
}
