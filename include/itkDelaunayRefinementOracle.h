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
#ifndef itkDelaunayRefinementOracle_h
#define itkDelaunayRefinementOracle_h

#include "itkDelaunayRefinementSurfaceCells.h"

#include <vector>

namespace itk
{
/** \class DelaunayRefinementOracle
 * \brief The object to be meshed, as the refinement engine sees it: the paper's function f (section II).
 *
 * The object is a closed, bounded set; its surface is the boundary of that set. All points and lengths are physical
 * (mm). Every function may be called by several threads at once.
 *
 * The surface is also offered in patches: small pieces that together cover it and can be split until they are as small
 * as one likes. They serve to sample the surface and to certify that a sample leaves no part of it out.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementOracle
{
public:
  /** A point of physical space (mm). */
  using PointType = DelaunayRefinementPoint;

  /** 0 is outside; the regions of the object are numbered from 1. */
  using RegionType = DelaunayRefinementRegion;

  /** Components are numbered from 0. */
  using ComponentType = std::uint32_t;

  /** An axis-aligned box. */
  struct BoundsType
  {
    /** Least coordinates (mm). */
    PointType minimum;
    /** Greatest coordinates (mm). */
    PointType maximum;
  };

  /** Bounds on numbers. */
  struct RangeType
  {
    /** None is less. */
    double least;
    /** None is greater. */
    double greatest;
  };

  /** Pieces of the surface. */
  using SurfacePatches = DelaunayRefinementSurfacePatches;

  /** By this the oracle knows one of them. */
  using SurfacePatchIdentifier = DelaunayRefinementSurfacePatches::IdentifierType;

  /** What a patch consists of. */
  using SurfaceCells = DelaunayRefinementSurfaceCells;

  virtual ~DelaunayRefinementOracle();

  /** The region that contains the point, 0 if it is outside. */
  virtual RegionType
  Classify(const PointType & point) const = 0;

  /** Finds the point of the surface closest to \c point, if there is one within \c maximumDistance. */
  virtual bool
  FindClosestSurfacePoint(const PointType & point, double maximumDistance, PointType & closest) const = 0;

  /** Whether a point of the surface lies within \c distance of \c point. Default: by FindClosestSurfacePoint(). */
  virtual bool
  IsSurfaceWithin(const PointType & point, double distance) const;

  /** Finds the first point of the surface on the way from \c from to \c to. */
  virtual bool
  FindFirstCrossing(const PointType & from, const PointType & to, PointType & crossing) const = 0;

  /** Cheap: false only if no point of the surface lies in the axis-aligned box. */
  virtual bool
  MayIntersectBox(const BoundsType & box) const = 0;

  /** A box that contains the surface; need not be tight. */
  virtual BoundsType
  GetSurfaceBounds() const = 0;

  /** Patches that together cover the surface; none if there is none. Their order is the oracle's own and always the
   * same. */
  virtual SurfacePatches
  GetSurfacePatches() const = 0;

  /** Whether patches are certain to leave out no surface that FindFirstCrossing() would find. Default: they are. */
  virtual bool
  KnowsAllSurface() const;

  /** Appends patches that together cover what a patch covers, within its box, each at most about half as large. */
  virtual void
  SplitSurfacePatch(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const = 0;

  /** The axes of all cells. Default: those of space. */
  virtual SurfaceCells::AxesType
  GetCellAxes() const;

  /** The cells of a patch. Many at once are covered as fast as one. Default: one, the patch itself. */
  virtual SurfaceCells
  GetCellsOfPatch(const SurfacePatches::PatchType & patch) const;

  /** Appends some of the cells that GetCellsOfPatch() gave, as patches. Default: with the cells' boxes. */
  virtual void
  AppendCells(const SurfaceCells & cells, SurfacePatches & patches) const;

  /** Finds a point of the surface in the ball of a patch; false if the patch turns out to hold none. */
  virtual bool
  FindPointOfPatch(const SurfacePatchIdentifier & patch, PointType & point) const = 0;

  /** Patches that together cover where regions meet, outside counted. */
  struct JunctionPatchesType
  {
    /** Where at least three meet: lines. */
    SurfacePatches lines{};
    /** Where at least four meet: points at which lines end. */
    SurfacePatches ends{};
  };

  /** Where regions meet. Default: nowhere. */
  virtual JunctionPatchesType
  GetJunctionPatches() const;

  /** Appends patches that together cover where at least as many regions (3 or 4) meet in a patch for so many, within
   * its box, each at most about half as large. Default: none. */
  virtual void
  SplitJunctionPatch(const SurfacePatchIdentifier & patch, unsigned int leastRegions, SurfacePatches & parts) const;

  /** Finds a point of the surface in a patch, very near to where at least as many regions meet, outside counted; false
   * if there seems to be none. Three regions meet in lines, four in points. */
  virtual bool
  FindJunctionInPatch(const SurfacePatchIdentifier & patch, unsigned int leastRegions, PointType & point) const;

  /** Number of components of the object: at least 1 unless it is empty. */
  virtual ComponentType
  GetNumberOfComponents() const = 0;

  /** The component that a point inside belongs to; the nearest one, of several any, for a point on the surface. */
  virtual ComponentType
  FindComponent(const PointType & point) const = 0;

  /** The least of some values, one for each component, among the components that meet at a point of the surface; others
   * nearby may be among them. Default: that of FindComponent(), which is enough where components don't touch. */
  virtual double
  FindLeastAt(const PointType & point, const std::vector<double> & values) const;

  /** Bounds on FindLeastAt() over the surface in a patch. Default: of the components whose bounds come within its
   * radius of its center. */
  virtual RangeType
  FindLeastInPatch(const SurfacePatches::PatchType & patch, const std::vector<double> & values) const;

  /** Number of cavities of the object. Default: 0. */
  virtual std::uint32_t
  GetNumberOfCavities() const;

  /** The cavity, numbered from 0, that a point outside belongs to; GetNumberOfCavities() for others. */
  virtual std::uint32_t
  FindCavity(const PointType & point) const;

  /** A box that contains the cavity and its surface; need not be tight. Default: GetSurfaceBounds(). */
  virtual BoundsType
  GetCavityBounds(std::uint32_t cavity) const;

  /** Counts the topology of the object, all regions together. Default: not known. */
  virtual DelaunayRefinementTopology
  CountTopology() const;

  /** A box that contains the component and its surface; need not be tight. Default: GetSurfaceBounds(). */
  virtual BoundsType
  GetComponentBounds(ComponentType component) const;
};
} // end namespace itk

#endif
