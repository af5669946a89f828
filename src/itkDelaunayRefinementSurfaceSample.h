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
#include "itkDelaunayRefinementThreads.h"

#include <set>

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
 * Threads work in blocks of one color after the other (DelaunayRefinementPatchCover).
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

  /** Tells of a feature vertex that is gone: R1 is asked again around it. Until then it still counts. */
  void
  Forget(const PointType & point)
  {
    m_Forgotten.insert(point);
  }

  /** Appends the points that R1 inserts, until all of the surface is covered; always the same in the same order,
   * however many \c threads there are. Again after delta was lowered somewhere: only there. False if \c keepGoing,
   * asked now and then on the calling thread, said so. */
  bool
  Certify(std::vector<PointType> &      points,
          DelaunayRefinementThreads &   threads,
          const std::function<bool()> & keepGoing);

  bool
  HasVertexWithin(const PointType & point, double radius) const
  {
    return m_Grid.HasPointWithin(point, radius);
  }

  /** Cheap: false only if no surface point lies within \c radius of a point, as it would be covered. */
  bool
  MayHaveSurfaceWithin(const PointType & point, double radius) const;

private:
  /** Whether R1 may no longer hold in a patch. */
  bool
  HasChanged(const DelaunayRefinementSurfacePatches::PatchType & patch,
             const DelaunayRefinementPointGrid &                 forgotten) const;

  /** Takes the vertices that are gone out of the grid, into one of their own; that one is empty if there are none. */
  DelaunayRefinementPointGrid
  TakeOutForgotten();

  /** A grid for the surface. */
  DelaunayRefinementPointGrid
  MakeGrid() const;

  const DelaunayRefinementOracle &     m_Oracle;
  const DelaunayRefinementLocalDelta & m_LocalDelta;
  bool                                 m_RoundToFloat;
  DelaunayRefinementPointGrid          m_Grid;
  std::multiset<PointType>             m_Forgotten{};
};
} // end namespace itk

#endif
