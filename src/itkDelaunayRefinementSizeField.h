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
#ifndef itkDelaunayRefinementSizeField_h
#define itkDelaunayRefinementSizeField_h

#include "itkDelaunayRefinementCubes.h"
#include "itkDelaunayRefinementOracle.h"

namespace itk
{
/** \class DelaunayRefinementSizeField
 * \brief A size that varies in space: one for each of the cubes that fill a box, growing slowly from cube to cube.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementSizeField
{
public:
  using PointType = DelaunayRefinementPoint;
  using BoundsType = DelaunayRefinementOracle::BoundsType;
  using RangeType = DelaunayRefinementOracle::RangeType;

  /** The same size everywhere. Cubes are larger than asked for if there would be too many. */
  void
  Start(const BoundsType & bounds, double cubeSize, double size);

  bool
  IsStarted() const
  {
    return !m_Sizes.empty();
  }

  /** Sizes are at most this much larger at one point than at another, for each unit of their distance. */
  static constexpr double Growth = 0.5;

  /** Lowers the size within \c radius of a point. */
  void
  Lower(const PointType & point, double radius, double size);

  /** Lowers the size in each cube to a function's value for its center and half of its edge; returns the least of all.
   */
  double
  Lower(const std::function<double(const PointType &, double)> & size);

  /** Lowers sizes where they grow too fast, distances being counted along the directions to a cube's 26 neighbors. */
  void
  Grade();

  double
  GetAt(const PointType & point) const
  {
    return m_Sizes[m_Cubes.ToOffset(m_Cubes.ToCube(point))];
  }

  /** Sizes are as they should be. */
  void
  Settle()
  {
    m_Settled = m_Sizes;
  }

  /** Whether a size within \c radius of a point has changed since Settle(). */
  bool
  HasChanged(const PointType & point, double radius) const;

  /** Bounds on the size within \c radius of a point. */
  RangeType
  GetRange(const PointType & point, double radius) const;

private:
  using CubeType = DelaunayRefinementCubes::CubeType;

  /** From the rows before it in one direction, and along the row. */
  void
  GradeRow(std::int32_t y, std::int32_t z, std::int32_t before);

  double
  ComputeDistance(const PointType & point, const CubeType & cube) const;

  DelaunayRefinementCubes m_Cubes{};
  std::vector<float>      m_Sizes{};
  std::vector<float>      m_Settled{}; // as they were then; empty before
};
} // end namespace itk

#endif
