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
#include "itkDelaunayRefinementNearbyPoints.h"

#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementWideLoops.h"

#include <cmath>

namespace itk
{
ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
DelaunayRefinementNearbyPoints::AnswerEnum
DelaunayRefinementNearbyPoints::Ask(const PatchesType & patches,
                                    std::size_t         number,
                                    double              delta,
                                    double              nearShare) const
{
  const float x = patches.GetCenters(0)[number];
  const float y = patches.GetCenters(1)[number];
  const float z = patches.GetCenters(2)[number];
  const float halfX = patches.GetHalfExtents(0)[number];
  const float halfY = patches.GetHalfExtents(1)[number];
  const float halfZ = patches.GetHalfExtents(2)[number];
  const float radius = patches.GetRadii()[number];
  // Points that cover are within delta of the patch; what rounding does to others is little against their distance.
  const auto  less = static_cast<float>((1.0 - Roundings) * delta - PatchesType::GetRounding(m_Extent + delta));
  const float squaredDelta = Square(less);
  const float squaredReach = Square(less - radius);
  const float squaredNear = Square(less - static_cast<float>(nearShare) * radius);
  bool        isNear = false;
  for (const BlockType & block : m_Blocks)
  {
    std::int32_t covers = 0;
    std::int32_t nears = 0;
    // Compilers do several of a block at once; GCC 12 unless it writes out the loop before.
#ifdef __GNUC__
#  pragma GCC unroll 1
#endif
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      const float dx = std::abs(block[0][i] - x);
      const float dy = std::abs(block[1][i] - y);
      const float dz = std::abs(block[2][i] - z);
      const float furthestX = dx + halfX;
      const float furthestY = dy + halfY;
      const float furthestZ = dz + halfZ;
      const float squared = dx * dx + dy * dy + dz * dz;
      const float squaredFurthest = furthestX * furthestX + furthestY * furthestY + furthestZ * furthestZ;
      covers |= (squaredFurthest <= squaredDelta ? 1 : 0) | (squared <= squaredReach ? 1 : 0);
      nears |= squared <= squaredNear ? 1 : 0;
    }
    if (covers != 0)
    {
      return AnswerEnum::COVERED;
    }
    isNear = isNear || nears != 0;
  }
  return isNear ? AnswerEnum::NEAR : AnswerEnum::FAR;
}

ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
bool
DelaunayRefinementNearbyPoints::HasPointWithin(const PointType & point, double radius) const
{
  const auto  x = static_cast<float>(point[0] - m_Origin[0]);
  const auto  y = static_cast<float>(point[1] - m_Origin[1]);
  const auto  z = static_cast<float>(point[2] - m_Origin[2]);
  const float squaredRadius = Square(static_cast<float>(radius));
  for (const BlockType & block : m_Blocks)
  {
    std::int32_t isWithin = 0;
#ifdef __GNUC__
#  pragma GCC unroll 1
#endif
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      const float dx = block[0][i] - x;
      const float dy = block[1][i] - y;
      const float dz = block[2][i] - z;
      isWithin |= dx * dx + dy * dy + dz * dz <= squaredRadius ? 1 : 0;
    }
    if (isWithin != 0)
    {
      return true;
    }
  }
  return false;
}

ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
void
DelaunayRefinementNearbyPoints::FindWithinOfBox(const PointType &            center,
                                                const PointType &            halfExtents,
                                                double                       radius,
                                                std::vector<std::uint32_t> & found) const
{
  const LocalPointType place{ static_cast<float>(center[0] - m_Origin[0]),
                              static_cast<float>(center[1] - m_Origin[1]),
                              static_cast<float>(center[2] - m_Origin[2]) };
  const BoxType        half{ static_cast<float>(halfExtents[0]),
                      static_cast<float>(halfExtents[1]),
                      static_cast<float>(halfExtents[2]) };
  const float          squaredRadius = Square(static_cast<float>(radius + PatchesType::GetRounding(m_Extent + radius)));
  const auto           beyond = [](float coordinate, float middle, float extent) {
    const float distance = std::abs(coordinate - middle) - extent;
    return 0.5f * (distance + std::abs(distance));
  };
  for (std::size_t number = 0; number < m_Blocks.size(); ++number)
  {
    const BlockType & block = m_Blocks[number];
    std::int32_t      within = 0;
#ifdef __GNUC__
#  pragma GCC unroll 1
#endif
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      const float dx = beyond(block[0][i], place[0], half[0]);
      const float dy = beyond(block[1][i], place[1], half[1]);
      const float dz = beyond(block[2][i], place[2], half[2]);
      within |= dx * dx + dy * dy + dz * dz <= squaredRadius ? 1 << i : 0;
    }
    for (auto bits = static_cast<std::uint64_t>(within); bits != 0; bits &= bits - 1)
    {
      found.push_back(static_cast<std::uint32_t>(number * BlockSize + FindDelaunayRefinementBit(bits)));
    }
  }
}

ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
bool
DelaunayRefinementNearbyPoints::DoTwoCover(const PatchesType::PatchType & patch, double delta) const
{
  // The halves of a box on either side of the plane between two points are convex: its corners, and where its edges
  // cross the plane, stand for all of it. What rounding moves these off the plane is little against the margin.
  const auto    less = static_cast<float>((1.0 - MarginOfTwo) * delta - PatchesType::GetRounding(m_Extent + delta));
  const float   squaredReach = Square(less);
  const BoxType box{ static_cast<float>(patch.halfExtents[0]),
                     static_cast<float>(patch.halfExtents[1]),
                     static_cast<float>(patch.halfExtents[2]) };
  const LocalPointType                                        center{ static_cast<float>(patch.center[0] - m_Origin[0]),
                               static_cast<float>(patch.center[1] - m_Origin[1]),
                               static_cast<float>(patch.center[2] - m_Origin[2]) };
  constexpr std::int32_t                                      allCorners = 0xFF;
  std::array<std::array<std::int32_t, BlockSize>, MostBlocks> corners;
  std::array<std::int32_t, BlockSize>                         together{};
  std::array<std::int32_t, BlockSize>                         nearestBlocks{};
  std::array<float, BlockSize>                                leasts;
  leasts.fill(std::numeric_limits<float>::infinity());
  const auto numberOfBlocks = static_cast<std::int32_t>(std::min(MostBlocks, m_Blocks.size()));
  for (std::int32_t j = 0; j < numberOfBlocks; ++j)
  {
    const BlockType & block = m_Blocks[j];
#ifdef __GNUC__
#  pragma GCC unroll 1
#endif
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      const float x = block[0][i] - center[0];
      const float y = block[1][i] - center[1];
      const float z = block[2][i] - center[2];
      const float lowX = (x + box[0]) * (x + box[0]);
      const float lowY = (y + box[1]) * (y + box[1]);
      const float lowZ = squaredReach - (z + box[2]) * (z + box[2]);
      const float highX = (x - box[0]) * (x - box[0]);
      const float highY = (y - box[1]) * (y - box[1]);
      const float highZ = squaredReach - (z - box[2]) * (z - box[2]);
      corners[j][i] = (lowX + lowY <= lowZ ? 1 : 0) | (highX + lowY <= lowZ ? 2 : 0) | (lowX + highY <= lowZ ? 4 : 0) |
                      (highX + highY <= lowZ ? 8 : 0) | (lowX + lowY <= highZ ? 16 : 0) |
                      (highX + lowY <= highZ ? 32 : 0) | (lowX + highY <= highZ ? 64 : 0) |
                      (highX + highY <= highZ ? 128 : 0);
      together[i] |= corners[j][i];
      const float squared = x * x + y * y + z * z;
      nearestBlocks[i] = squared < leasts[i] ? j : nearestBlocks[i];
      leasts[i] = squared < leasts[i] ? squared : leasts[i];
    }
  }
  if ((together[0] | together[1] | together[2] | together[3] | together[4] | together[5] | together[6] | together[7]) !=
      allCorners)
  {
    return false;
  }
  // The nearest, and another that covers the corners it does not.
  const auto nearest = static_cast<std::size_t>(std::min_element(leasts.begin(), leasts.end()) - leasts.begin());
  const auto getPoint = [&](const BlockType & block, std::size_t place) -> LocalPointType {
    return { block[0][place] - center[0], block[1][place] - center[1], block[2][place] - center[2] };
  };
  const std::int32_t   ownCorners = corners[nearestBlocks[nearest]][nearest];
  const LocalPointType point = getPoint(m_Blocks[nearestBlocks[nearest]], nearest);
  for (std::int32_t j = 0; j < numberOfBlocks; ++j)
  {
    std::int32_t others = 0;
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      others |= (corners[j][i] | ownCorners) == allCorners ? 1 << i : 0;
    }
    for (std::size_t i = 0; others >> i != 0; ++i)
    {
      if ((others >> i & 1) != 0 && AreEdgesCovered(box, point, getPoint(m_Blocks[j], i), squaredReach))
      {
        return true;
      }
    }
  }
  return false;
}

bool
DelaunayRefinementNearbyPoints::AreEdgesCovered(const BoxType &        box,
                                                const LocalPointType & a,
                                                const LocalPointType & b,
                                                float                  squaredReach)
{
  const LocalPointType normal{ a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  const float  offset = 0.5f * (normal[0] * (a[0] + b[0]) + normal[1] * (a[1] + b[1]) + normal[2] * (a[2] + b[2]));
  std::int32_t numberUncovered = 0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const unsigned int y = (axis + 1) % 3;
    const unsigned int z = (axis + 2) % 3;
    const float        perNormal = 1.0f / normal[axis];
    constexpr float    signs[2][4] = { { -1.0f, 1.0f, -1.0f, 1.0f }, { -1.0f, -1.0f, 1.0f, 1.0f } };
    for (unsigned int edge = 0; edge < 4; ++edge)
    {
      const float placeY = signs[0][edge] * box[y];
      const float placeZ = signs[1][edge] * box[z];
      const float crossing = (offset - normal[y] * placeY - normal[z] * placeZ) * perNormal;
      const float dx = crossing - a[axis];
      const float dy = placeY - a[y];
      const float dz = placeZ - a[z];
      numberUncovered +=
        (std::abs(crossing) <= box[axis] ? 1 : 0) & (dx * dx + dy * dy + dz * dz > squaredReach ? 1 : 0);
    }
  }
  return numberUncovered == 0;
}
} // end namespace itk
