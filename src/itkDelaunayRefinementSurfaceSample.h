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
#ifndef itkDelaunayRefinementSurfaceSample_h
#define itkDelaunayRefinementSurfaceSample_h

#include "itkDelaunayRefinementLocalDelta.h"
#include "itkDelaunayRefinementPointGrid.h"

namespace itk
{
/** \class DelaunayRefinementSurfaceSample
 * \brief Rule R1 of the paper (section III), asked of the whole surface: a surface point that is at least delta away
 * from every feature vertex is inserted.
 *
 * The paper asks R1 of the surface points closest to circumcenters, which all lie on the surface; here every patch of
 * the surface is certified to lie within delta of one feature vertex, or split, or given a vertex. So R1 in the paper's
 * words can't fire either once Certify() is done, feature vertices never being removed. Vertices keep a little less
 * than delta between them, so that certification ends.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementSurfaceSample
{
public:
  using PointType = DelaunayRefinementPoint;

  /** Points are rounded to floats if \c roundToFloat is set. */
  DelaunayRefinementSurfaceSample(const DelaunayRefinementOracle &     oracle,
                                  const DelaunayRefinementLocalDelta & localDelta,
                                  bool                                 roundToFloat);

  /** Tells of a feature vertex inserted by another rule. */
  void
  Add(const PointType & point);

  /** Appends the points that R1 inserts, until no part of the surface is open; always the same in the same order.
   * False if \c keepGoing, asked now and then, said so. */
  bool
  Certify(std::vector<PointType> & points, const std::function<bool()> & keepGoing);

  /** Opens the whole surface again, after delta was lowered somewhere. */
  void
  Reopen();

private:
  using PatchType = DelaunayRefinementOracle::SurfacePatch;

  /** A patch that is not known to be covered, and a vertex near it: likely to cover its parts. */
  struct OpenPatchType
  {
    PatchType    patch;
    std::int32_t vertex;
  };

  /** The least delta that holds in a patch. */
  double
  GetLeastDelta(const PatchType & patch) const;

  /** Whether a patch is covered now; it gets a vertex if a point of it is far enough from all. \c isUniform: delta is
   * the same in all of it. Keeps the vertex that is nearest in \c open. */
  bool
  Cover(OpenPatchType & open, bool isUniform, std::vector<PointType> & points);

  void
  Split(const OpenPatchType & open, std::vector<OpenPatchType> & parts);

  static std::vector<std::uint32_t>
  MakeRandomOrder(std::size_t length);

  const DelaunayRefinementOracle &     m_Oracle;
  const DelaunayRefinementLocalDelta & m_LocalDelta;
  bool                                 m_RoundToFloat;
  DelaunayRefinementPointGrid          m_Grid;
  std::vector<OpenPatchType>           m_Open{};
  std::vector<PatchType>               m_Parts{};
};
} // end namespace itk

#endif
