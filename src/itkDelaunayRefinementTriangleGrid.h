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
#ifndef itkDelaunayRefinementTriangleGrid_h
#define itkDelaunayRefinementTriangleGrid_h

#include "itkDelaunayRefinementCubes.h"

namespace itk
{
/** \class DelaunayRefinementTriangleGrid
 * \brief Triangles in a grid of cubes, to find one that is near a point.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementTriangleGrid
{
public:
  using PointType = DelaunayRefinementPoint;
  using TriangleType = std::array<PointType, 3>;

  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  /** A triangle by its number, and how far it is (mm). */
  struct NearType
  {
    std::uint32_t number{ None };
    double        distance{ std::numeric_limits<double>::infinity() };
  };

  /** Forgets all triangles before. */
  void
  Start(std::vector<TriangleType> triangles);

  /** The nearest triangle of those within \c reach, or one within \c enough. Fast if \c first is such a one. */
  NearType
  Find(const PointType & point, double enough, double reach, std::uint32_t first = None) const;

  const std::vector<TriangleType> &
  GetTriangles() const
  {
    return m_Triangles;
  }

private:
  using CubeType = DelaunayRefinementCubes::CubeType;

  /** Calls \c action with the offset of each cube that meets the box of a triangle. */
  template <typename TAction>
  void
  ForEachCube(const TriangleType & triangle, const TAction & action) const;

  DelaunayRefinementCubes    m_Cubes{};
  std::vector<TriangleType>  m_Triangles{};
  std::vector<std::uint32_t> m_Ends{}; // of each cube's part of m_Numbers; the first is 0
  std::vector<std::uint32_t> m_Numbers{};
};
} // end namespace itk

#endif
