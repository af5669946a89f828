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
#include "itkDelaunayRefinementNearbyPoints.h"
#include "itkDelaunayRefinementPatchCover.h"
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

  /** Appends the points that R1 inserts, until all of the surface is covered; always the same in the same order. Again
   * after delta was lowered somewhere. False if \c keepGoing, asked now and then, said so. */
  bool
  Certify(std::vector<PointType> & points, const std::function<bool()> & keepGoing);

  bool
  HasVertexWithin(const PointType & point, double radius) const
  {
    return m_Grid.HasPointWithin(point, radius);
  }

  /** Cheap: false only if no surface point lies within \c radius of a point, as it would be covered. */
  bool
  MayHaveSurfaceWithin(const PointType & point, double radius) const;

private:
  using PatchesType = DelaunayRefinementSurfacePatches;
  using PatchType = PatchesType::PatchType;
  using AnswerEnum = DelaunayRefinementNearbyPoints::AnswerEnum;

  /** Asked before as many patches as it is told are visited. */
  using MayVisitType = std::function<bool(std::size_t)>;

  /** Splits the whole surface into patches that are small against delta; \c roots are the oracle's. */
  bool
  CollectPatches(const PatchesType & roots, DelaunayRefinementPatchCover & cover, const MayVisitType & mayVisit);

  /** Whether no component with a lower delta reaches into a patch. */
  bool
  IsUniform(const PatchType & patch) const;

  /** The least delta that holds in a patch. \c isUniform: of it or of one that it is a part of. */
  double
  GetLeastDelta(const PatchesType & patches, std::size_t number, bool isUniform) const;

  enum class OutcomeEnum : uint8_t
  {
    TOO_NEAR,
    INSERTED,
    EMPTY // the patch holds no surface
  };

  /** Inserts a point of a patch, last in \c points, unless \c vertices has one too near. */
  template <typename TVertices>
  OutcomeEnum
  Sample(const PatchesType::IdentifierType & patch,
         bool                                isUniform,
         const TVertices &                   vertices,
         DelaunayRefinementPatchCover &      cover,
         std::vector<PointType> &            points);

  /** Covers all patches of a group that are not yet, by splitting them again and again. */
  bool
  CoverGroup(const DelaunayRefinementPatchCover::GroupType & group,
             DelaunayRefinementPatchCover &                  cover,
             std::vector<PointType> &                        points,
             const MayVisitType &                            mayVisit);

  /** The same for some patches of a group, within a box. */
  bool
  CoverPatches(const DelaunayRefinementPatchCover::GroupType & patches,
               DelaunayRefinementPatchCover &                  cover,
               std::vector<PointType> &                        points,
               const MayVisitType &                            mayVisit);

  /** The feature vertices that may cover what lies in a box. */
  void
  FindNearby(const PointType & center, const PointType & halfExtents);

  static std::vector<std::uint32_t>
  MakeRandomOrder(std::size_t length);

  const DelaunayRefinementOracle &     m_Oracle;
  const DelaunayRefinementLocalDelta & m_LocalDelta;
  bool                                 m_RoundToFloat;
  DelaunayRefinementPointGrid          m_Grid;

  // Scratch of single calls.
  PatchesType                    m_Wholes{};
  PatchesType                    m_Parts{};
  std::vector<PointType>         m_Found{};
  DelaunayRefinementNearbyPoints m_Nearby{};
};
} // end namespace itk

#endif
