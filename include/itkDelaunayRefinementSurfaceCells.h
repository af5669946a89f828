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
#ifndef itkDelaunayRefinementSurfaceCells_h
#define itkDelaunayRefinementSurfaceCells_h

#include "itkDelaunayRefinementSurfacePatches.h"

namespace itk
{
/** \class DelaunayRefinementSurfaceCells
 * \brief What a piece of a surface consists of: some of 4 x 4 x 4 boxes, all of one size, each a patch.
 *
 * They lie along axes that all cells of a surface share.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementSurfaceCells
{
  /** A point along the cells' axes. */
  using PointType = DelaunayRefinementPoint;

  /** By this the oracle knows a patch. */
  using IdentifierType = DelaunayRefinementSurfacePatches::IdentifierType;

  /** Coordinates of points along the axes are their products with these vectors, in which distances are no shorter than
   * in space. */
  using AxesType = std::array<PointType, 3>;

  /** Along each axis. */
  static constexpr std::int32_t CellsPerSide = 4;

  /** Bit x + 4 y + 16 z for each cell that may hold surface. */
  std::uint64_t bits;
  /** The patch that is cell 0; the indexes of others are greater by x, y, z. */
  IdentifierType first;
  /** Of cell 0, along the axes. */
  PointType corner;
  /** Of each cell, along the axes. */
  PointType edges;
  /** No cell's surface lies further out of its box than this. */
  double margin;

  /** The patch that is a cell, from the one that is cell 0. */
  static IdentifierType
  GetPatch(const IdentifierType & first, unsigned int bit)
  {
    const auto place = static_cast<std::int32_t>(bit);
    return { { first.index[0] + (place & 3), first.index[1] + (place >> 2 & 3), first.index[2] + (place >> 4) },
             first.level };
  }
};
} // end namespace itk

#endif
