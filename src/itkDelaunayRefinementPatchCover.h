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
#ifndef itkDelaunayRefinementPatchCover_h
#define itkDelaunayRefinementPatchCover_h

#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementPatchMarks.h"

namespace itk
{
/** \class DelaunayRefinementPatchCover
 * \brief All patches of a surface, in a grid, so that a vertex finds those that it covers.
 *
 * Patches come in groups, the parts of one larger patch each.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPatchCover
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchesType = DelaunayRefinementSurfacePatches;

  /** The parts \c begin to \c end (not included) of a patch. */
  struct GroupType
  {
    PointType     center;
    PointType     halfExtents;
    std::uint32_t begin;
    std::uint32_t end;
    bool          isUniform; // the caller's
  };

  /** The larger patches, and the greatest delta there is. */
  DelaunayRefinementPatchCover(const PatchesType & roots, double greatestDelta);

  /** The numbers of the roots in an order that has neighbors close together: that of the groups. */
  const std::vector<std::uint32_t> &
  GetOrder() const
  {
    return m_Order;
  }

  /** Adds parts to GetMarks().GetPatches(), those of the next group after those of the last one. */
  void
  EndGroup(bool isUniform);

  const std::vector<GroupType> &
  GetGroups() const
  {
    return m_Groups;
  }

  DelaunayRefinementPatchMarks &
  GetMarks()
  {
    return m_Marks;
  }

  /** All that vertices can reach lies within this distance of the patches' origin. */
  double
  GetExtent() const
  {
    return m_Extent;
  }

  /** Marks all patches that a vertex covers. */
  void
  CoverFrom(const PointType & vertex);

private:
  using CubeType = std::array<std::int32_t, 3>;

  /** Points beyond the grid belong to the cubes at its border. */
  CubeType
  FindCube(const PointType & point, double offset) const;

  std::size_t
  ToOffset(const CubeType & cube) const
  {
    return (static_cast<std::size_t>(cube[2]) * m_Size[1] + cube[1]) * m_Size[0] + cube[0];
  }

  double                       m_GreatestReach{ 0.0 };
  double                       m_Extent{ 0.0 };
  double                       m_CubesPerLength{ 1.0 };
  PointType                    m_Minimum{};
  CubeType                     m_Size{};
  std::vector<std::uint32_t>   m_Starts{}; // of each cube's groups, and the end
  std::vector<std::uint32_t>   m_Order{};
  std::vector<GroupType>       m_Groups{};
  std::size_t                  m_NumberOfGroups{ 0 };
  DelaunayRefinementPatchMarks m_Marks{};
};
} // end namespace itk

#endif
