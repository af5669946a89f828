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
#ifndef itkDelaunayRefinementCubes_h
#define itkDelaunayRefinementCubes_h

#include "itkDelaunayRefinementGeometry.h"

namespace itk
{
/** \class DelaunayRefinementCubes
 * \brief The cubes that fill a box, numbered along its axes, x fastest.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementCubes
{
  using PointType = DelaunayRefinementPoint;
  using CubeType = std::array<std::int32_t, 3>;

  /** The box is a little larger than asked for if the edge does not divide it. */
  void
  Start(const PointType & first, const PointType & extent, double edge)
  {
    minimum = first;
    size = edge;
    for (unsigned int i = 0; i < 3; ++i)
    {
      length[i] = static_cast<std::int32_t>(extent[i] / edge) + 1;
    }
  }

  std::size_t
  GetNumber() const
  {
    return static_cast<std::size_t>(length[0]) * length[1] * length[2];
  }

  /** Of a point moved by \c offset along each axis. Points beyond the box belong to the cubes at its border. */
  CubeType
  ToCube(const PointType & point, double offset = 0.0) const
  {
    CubeType cube;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double index = (point[i] + offset - minimum[i]) / size;
      cube[i] = index > 0.0 ? index < length[i] ? static_cast<std::int32_t>(index) : length[i] - 1 : 0;
    }
    return cube;
  }

  std::size_t
  ToOffset(const CubeType & cube) const
  {
    return (static_cast<std::size_t>(cube[2]) * length[1] + cube[1]) * length[0] + cube[0];
  }

  PointType minimum{};
  double    size{ 1.0 };
  CubeType  length{};
};
} // end namespace itk

#endif
