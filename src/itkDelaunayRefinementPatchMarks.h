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
#ifndef itkDelaunayRefinementPatchMarks_h
#define itkDelaunayRefinementPatchMarks_h

#include "itkDelaunayRefinementSurfacePatches.h"

#include <algorithm>

namespace itk
{
/** \class DelaunayRefinementPatchMarks
 * \brief Patches of the surface, each marked once it is covered: within its delta of a vertex.
 *
 * Compared in single precision; a little less is covered than could be.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPatchMarks
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchesType = DelaunayRefinementSurfacePatches;

  /** The patches to be marked; deltas and marks have to follow, by Mark(). */
  PatchesType &
  GetPatches()
  {
    return m_Patches;
  }

  const PatchesType &
  GetPatches() const
  {
    return m_Patches;
  }

  /** Nothing is covered as yet. Vertices that matter lie within \c extent of the patches' origin. \c getDelta tells
   * delta, by a patch's number. A patch is near a vertex if its center is no further than delta less \c nearShare of
   * its radius. */
  template <typename TGetDelta>
  void
  Start(double extent, double nearShare, const TGetDelta & getDelta)
  {
    const std::size_t size = m_Patches.GetSize();
    m_SquaredDeltas.resize(size + BlockSize);
    m_SquaredReaches.resize(size + BlockSize);
    m_SquaredNears.resize(size + BlockSize);
    m_IsCovered.assign(size + BlockSize, 0);
    m_IsNear.assign(size + BlockSize, 0);
    // Each of the coordinates and differences is off by at most the loss.
    const auto          loss = Roundings * static_cast<float>(extent);
    const auto          share = static_cast<float>(nearShare);
    const auto          square = [](float length) { return length > 0.0f ? length * length : -1.0f; };
    const float * const radii = m_Patches.GetRadii();
    for (std::size_t i = 0; i < size; ++i)
    {
      const float delta = (1.0f - Roundings) * static_cast<float>(getDelta(i)) - loss;
      m_SquaredDeltas[i] = square(delta);
      m_SquaredReaches[i] = square(delta - radii[i]);
      m_SquaredNears[i] = square(delta - share * radii[i]);
    }
  }

  /** Marks those of the patches \c begin to \c end (not included) that a vertex covers, and perhaps some after them. */
  void
  CoverFrom(const PointType & vertex, std::size_t begin, std::size_t end)
  {
    const PointType &    origin = m_Patches.GetOrigin();
    const auto           x = static_cast<float>(vertex[0] - origin[0]);
    const auto           y = static_cast<float>(vertex[1] - origin[1]);
    const auto           z = static_cast<float>(vertex[2] - origin[2]);
    const float * const  centerX = m_Patches.GetCenters(0) + begin;
    const float * const  centerY = m_Patches.GetCenters(1) + begin;
    const float * const  centerZ = m_Patches.GetCenters(2) + begin;
    const float * const  halfX = m_Patches.GetHalfExtents(0) + begin;
    const float * const  halfY = m_Patches.GetHalfExtents(1) + begin;
    const float * const  halfZ = m_Patches.GetHalfExtents(2) + begin;
    const float * const  squaredDeltas = m_SquaredDeltas.data() + begin;
    const float * const  squaredReaches = m_SquaredReaches.data() + begin;
    const float * const  squaredNears = m_SquaredNears.data() + begin;
    std::int32_t * const isCovered = m_IsCovered.data() + begin;
    std::int32_t * const isNear = m_IsNear.data() + begin;
    // Whole blocks: compilers do several of these at once.
    const auto length = static_cast<std::int32_t>((end - begin + BlockSize - 1) / BlockSize * BlockSize);
    for (std::int32_t i = 0; i < length; ++i)
    {
      const float dx = std::abs(x - centerX[i]);
      const float dy = std::abs(y - centerY[i]);
      const float dz = std::abs(z - centerZ[i]);
      const float furthestX = dx + halfX[i];
      const float furthestY = dy + halfY[i];
      const float furthestZ = dz + halfZ[i];
      const float squared = dx * dx + dy * dy + dz * dz;
      const float squaredFurthest = furthestX * furthestX + furthestY * furthestY + furthestZ * furthestZ;
      isCovered[i] |= (squaredFurthest <= squaredDeltas[i] ? 1 : 0) | (squared <= squaredReaches[i] ? 1 : 0);
      isNear[i] |= squared <= squaredNears[i] ? 1 : 0;
    }
  }

  bool
  IsCovered(std::size_t number) const
  {
    return m_IsCovered[number] != 0;
  }

  bool
  IsNear(std::size_t number) const
  {
    return m_IsNear[number] != 0;
  }

  void
  SetCovered(std::size_t number)
  {
    m_IsCovered[number] = 1;
  }

private:
  static constexpr std::size_t BlockSize = PatchesType::BlockSize;

  /** More than is lost to any rounding here. */
  static constexpr float Roundings = 8.0f * std::numeric_limits<float>::epsilon();

  PatchesType               m_Patches{};
  std::vector<float>        m_SquaredDeltas{};
  std::vector<float>        m_SquaredReaches{};
  std::vector<float>        m_SquaredNears{};
  std::vector<std::int32_t> m_IsCovered{};
  std::vector<std::int32_t> m_IsNear{};
};
} // end namespace itk

#endif
