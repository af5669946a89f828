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

  /** The patches to be marked, to be there before Start(). */
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

  /** Nothing is covered as yet. Vertices that matter lie within \c extent of the patches' origin. A patch is near a
   * vertex if its center is no further than delta less \c nearShare of its radius. */
  void
  Start(double extent, double nearShare, DelaunayRefinementArray<float> && deltas)
  {
    m_NearShare = static_cast<float>(nearShare);
    m_Deltas = std::move(deltas);
    // Each of the coordinates and differences is off by at most the loss.
    const auto loss = Roundings * static_cast<float>(extent);
    for (float & delta : m_Deltas)
    {
      delta = (1.0f - Roundings) * delta - loss;
    }
    m_Deltas.resize(m_Patches.GetSize() + BlockSize, -1.0f);
    m_Marks.assign(m_Patches.GetSize() + BlockSize, 0);
  }

  /** Marks those of the patches \c begin to \c end (not included) that a vertex covers, and perhaps some after them
   * unless \c isExact, which takes longer. */
  void
  CoverFrom(const PointType & vertex, std::size_t begin, std::size_t end, bool isExact);

  bool
  IsCovered(std::size_t number) const
  {
    return (m_Marks[number] & Covered) != 0;
  }

  bool
  IsCoveredOrNear(std::size_t number) const
  {
    return m_Marks[number] != 0;
  }

  void
  SetCovered(std::size_t number)
  {
    m_Marks[number] |= Covered;
  }

private:
  static constexpr std::size_t BlockSize = PatchesType::BlockSize;

  /** More than is lost to any rounding here. */
  static constexpr float Roundings = 8.0f * std::numeric_limits<float>::epsilon();

  static constexpr std::int32_t Covered = 1;
  static constexpr std::int32_t Near = 2;

  PatchesType                           m_Patches{};
  float                                 m_NearShare{ 0.0f };
  DelaunayRefinementArray<float>        m_Deltas{}; // less what is lost to rounding
  DelaunayRefinementArray<std::int32_t> m_Marks{};
};
} // end namespace itk

#endif
