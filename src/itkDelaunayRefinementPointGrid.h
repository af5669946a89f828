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
 * \brief Points in a grid of cubes, to find the nearest one within a distance.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPointGrid
{
public:
  using PointType = DelaunayRefinementPoint;

  /** A grid over a box. The cubes' edge is best about as long as the distances that will be asked for; it is longer if
   * the box would take too many cubes. */
  DelaunayRefinementPointGrid(const PointType & minimum, const PointType & maximum, double cubeSize);

  /** Returns the point's number. */
  std::int32_t
  Add(const PointType & point);

  static constexpr std::int32_t None = -1;

  const PointType &
  GetPoint(std::int32_t number) const
  {
    return m_Nodes[number].point;
  }

  /** The number of the nearest point within \c radius, None if there is none. Stops at the first point found within
   * \c enough. */
  std::int32_t
  FindNearest(const PointType & point, double radius, double enough) const;

  /** Appends the points within \c radius. */
  void
  FindWithin(const PointType & point, double radius, std::vector<PointType> & found) const;

  std::size_t
  GetNumberOfPoints() const
  {
    return m_Nodes.size();
  }

private:
  using CubeType = std::array<std::int32_t, 3>;

  struct NodeType
  {
    PointType    point;
    std::int32_t previous;
  };

  /** Points beyond the box belong to the cubes at its border: slower there, never wrong. */
  CubeType
  ToCube(const PointType & point, double offset) const
  {
    CubeType cube;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double index = (point[i] + offset - m_Minimum[i]) * m_InverseSize;
      cube[i] = index > 0.0 ? index < m_Size[i] ? static_cast<std::int32_t>(index) : m_Size[i] - 1 : 0;
    }
    return cube;
  }

  std::size_t
  ToOffset(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return (static_cast<std::size_t>(z) * m_Size[1] + y) * m_Size[0] + x;
  }

  PointType                 m_Minimum;
  double                    m_InverseSize;
  CubeType                  m_Size;
  std::vector<std::int32_t> m_Last{};
  std::vector<NodeType>     m_Nodes{};
};
} // end namespace itk

#endif
