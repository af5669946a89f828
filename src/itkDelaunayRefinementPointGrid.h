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
#include "itkDelaunayRefinementMemory.h"

namespace itk
{
/** \class DelaunayRefinementPointGrid
 * \brief Points in a grid of cubes, to find those within a distance.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPointGrid
{
public:
  using PointType = DelaunayRefinementPoint;

  /** Nothing may be added before Start(). */
  DelaunayRefinementPointGrid() = default;

  /** A grid over a box. The cubes' edge is best about as long as the distances that will be asked for; it is longer if
   * the box would take too many cubes. */
  DelaunayRefinementPointGrid(const PointType & minimum, const PointType & maximum, double cubeSize)
  {
    this->Start(minimum, maximum, cubeSize);
  }

  /** Forgets all points. The same box and cubes as those of the constructor. */
  void
  Start(const PointType & minimum, const PointType & maximum, double cubeSize);

  void
  Add(const PointType & point);

  bool
  HasPointWithin(const PointType & point, double radius) const;

  /** Appends the points within \c radius of a box. */
  void
  FindWithinOfBox(const PointType &                    center,
                  const PointType &                    halfExtents,
                  double                               radius,
                  DelaunayRefinementArray<PointType> & found) const;

  /** All points, in the order in which they were added. */
  const std::vector<PointType> &
  GetPoints() const
  {
    return m_Points;
  }

private:
  using CubeType = std::array<std::int32_t, 3>;

  static constexpr std::int32_t None = -1;

  /** Some points of one cube; the block with others that came before them. */
  struct BlockType
  {
    std::array<PointType, 8> points;
    std::uint32_t            numberOfPoints;
    std::int32_t             previous;
  };

  /** Calls \c visitor with the blocks of the cubes that meet a box until it returns true, and tells whether it did. */
  template <typename TVisitor>
  bool
  VisitBlocks(const PointType & minimum, const PointType & maximum, const TVisitor & visitor) const;

  /** Points beyond the box belong to the cubes at its border: slower there, never wrong. */
  CubeType
  ToCube(const PointType & point) const
  {
    CubeType cube;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double index = (point[i] - m_Minimum[i]) * m_InverseSize;
      cube[i] = index > 0.0 ? index < m_Size[i] ? static_cast<std::int32_t>(index) : m_Size[i] - 1 : 0;
    }
    return cube;
  }

  std::size_t
  ToOffset(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return this->ToRow(y, z) * m_Size[0] + x;
  }

  std::size_t
  ToRow(std::int32_t y, std::int32_t z) const
  {
    return static_cast<std::size_t>(z) * m_Size[1] + y;
  }

  PointType                             m_Minimum{};
  double                                m_InverseSize{ 1.0 };
  CubeType                              m_Size{};
  std::vector<PointType>                m_Points{};
  DelaunayRefinementArray<BlockType>    m_Blocks{};
  DelaunayRefinementArray<std::int32_t> m_LastBlocks{}; // of each cube

  // A bit for each cube with points.
  std::size_t                            m_WordsPerRow{ 0 };
  DelaunayRefinementArray<std::uint64_t> m_IsOccupied{};
};
} // end namespace itk

#endif
