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
#ifndef itkDelaunayRefinementPointGrid_h
#define itkDelaunayRefinementPointGrid_h

#include "itkDelaunayRefinementGeometry.h"

namespace itk
{
/** \class DelaunayRefinementPointGrid
 * \brief Points in a hashed grid of cubes, to find the nearest one within a distance.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPointGrid
{
public:
  using PointType = DelaunayRefinementPoint;

  /** The cubes' edge, best about as long as the distances that will be asked for. */
  explicit DelaunayRefinementPointGrid(double cubeSize);

  void
  Add(const PointType & point);

  /** Squared distance to the nearest point within \c radius; infinity if there is none. Stops at the first point found
   * within \c enough. */
  double
  FindSquaredDistance(const PointType & point, double radius, double enough) const;

private:
  /** The indexes of a cube along the three axes, 21 bits each. */
  using CubeType = std::uint64_t;

  struct EntryType
  {
    CubeType     cube;
    std::int32_t last;
  };

  struct NodeType
  {
    PointType    point;
    std::int32_t previous;
  };

  std::uint64_t
  ToIndex(double coordinate) const;

  static CubeType
  ToCube(std::uint64_t x, std::uint64_t y, std::uint64_t z)
  {
    return x | y << 21 | z << 42;
  }

  /** The slot of the cube, or the empty one where it belongs. */
  std::size_t
  FindSlot(CubeType cube) const;

  void
  Grow();

  double                 m_InverseSize;
  std::size_t            m_Used{ 0 };
  std::vector<EntryType> m_Slots;
  std::vector<NodeType>  m_Nodes{};
};
} // end namespace itk

#endif
