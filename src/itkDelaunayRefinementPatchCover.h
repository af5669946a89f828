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
#include "itkDelaunayRefinementOracle.h"

namespace itk
{
/** \class DelaunayRefinementPatchCover
 * \brief Patches of the surface in a grid of cubes, each marked once it is covered: within delta of a vertex.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPatchCover
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchType = DelaunayRefinementOracle::SurfacePatch;

  /** A patch is covered by a vertex within \c delta of all of it. \c isUniform is the caller's. */
  struct EntryType
  {
    PatchType patch;
    double    delta;
    bool      isUniform;
  };

  /** Whether all of a patch is within delta of a point. */
  static bool
  IsWithin(const PatchType & patch, double delta, const PointType & point)
  {
    const double reach = delta - patch.radius;
    const double x = std::abs(point[0] - patch.center[0]);
    const double y = std::abs(point[1] - patch.center[1]);
    const double z = std::abs(point[2] - patch.center[2]);
    const double furthestX = x + patch.halfExtents[0];
    const double furthestY = y + patch.halfExtents[1];
    const double furthestZ = z + patch.halfExtents[2];
    return furthestX * furthestX + furthestY * furthestY + furthestZ * furthestZ <= delta * delta ||
           (reach > 0.0 && x * x + y * y + z * z <= reach * reach);
  }

  /** Sorts the entries by cubes. */
  explicit DelaunayRefinementPatchCover(std::vector<EntryType> entries);

  std::size_t
  GetNumberOfPatches() const
  {
    return m_Entries.size();
  }

  const EntryType &
  GetEntry(std::size_t number) const
  {
    return m_Entries[number];
  }

  bool
  IsCovered(std::size_t number) const
  {
    return m_IsCovered[number] != 0;
  }

  void
  SetCovered(std::size_t number)
  {
    m_IsCovered[number] = 1;
  }

  /** Marks all patches that a vertex covers. */
  void
  CoverFrom(const PointType & vertex);

private:
  using CubeType = std::array<std::int32_t, 3>;

  /** What decides, in single precision, from the grid's corner: a little less is covered than could be. One array each,
   * so that several are compared at once. */
  struct BoxesType
  {
    std::array<std::vector<float>, 3> center{};
    std::array<std::vector<float>, 3> halfExtents{};
    std::vector<float>                squaredDelta{};
    std::vector<float>                squaredReach{};
  };

  void
  MakeBoxes(double extent);

  /** Points beyond the grid belong to the cubes at its border. */
  CubeType
  FindCube(const PointType & point, double offset) const;

  std::size_t
  ToOffset(const CubeType & cube) const
  {
    return (static_cast<std::size_t>(cube[2]) * m_Size[1] + cube[1]) * m_Size[0] + cube[0];
  }

  double                     m_GreatestReach{ 0.0 };
  double                     m_CubesPerLength{ 1.0 };
  PointType                  m_Minimum{};
  CubeType                   m_Size{};
  std::vector<std::uint32_t> m_Starts{}; // of each cube's patches, and the end
  std::vector<EntryType>     m_Entries{};
  BoxesType                  m_Boxes{};
  std::vector<char>          m_IsCovered{};
};
} // end namespace itk

#endif
