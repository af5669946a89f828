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
#ifndef itkDelaunayRefinementLatticeOracle_h
#define itkDelaunayRefinementLatticeOracle_h

#include "itkDelaunayRefinementComponent.h"
#include "itkDelaunayRefinementOracle.h"
#include "itkDelaunayRefinementRegionChanges.h"
#include "itkDelaunayRefinementVoxelComponents.h"
#include "itkDelaunayRefinementVoxelMask.h"

#include <memory>

namespace itk
{
class DelaunayRefinementBricks;
class DelaunayRefinementRegionsCell;
class DelaunayRefinementSmoothedRegions;
class DelaunayRefinementVoxelCavities;

/** \class DelaunayRefinementLatticeOracle
 * \brief An object sampled on a lattice of voxels in physical space; what lies between the voxels is up to a model.
 *
 * A mask says which voxels are inside. A cell is the cube between eight voxel centers; the surface passes only through
 * cells with voxels of both kinds, and is found there by the model:
 * - INDICATOR: the half level of the trilinear interpolation of the mask;
 * - GREY: the zero level of the trilinear interpolation of values that a derived class gives for voxels;
 * - NEAREST: the faces of the voxels;
 * - FIELD: the zero level of any function, that a derived class evaluates; details smaller than a quarter of a voxel
 *   may be missed, and closest points are as exact as that.
 * Voxels may belong to several regions. The surface is where the region changes then: where the interpolation of the
 * mask is at least one half, the region with the largest interpolated indicator has a point, of equals the one with the
 * smallest number.
 *
 * Beyond the outermost voxels values are mirrored about the level where they are inside, so that the object is closed
 * half a voxel beyond its outermost voxels' centers.
 *
 * Closest surface points are exact to 0.05 voxel, and on the surface to 1e-6 voxel, but for FIELD.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementLatticeOracle : public DelaunayRefinementOracle
{
public:
  /** \class ModelEnum
   * \brief What lies between the voxels, see above.
   * \ingroup DelaunayRefinement
   */
  enum class ModelEnum : uint8_t
  {
    INDICATOR,
    GREY,
    NEAREST,
    FIELD
  };

  /** Patches of level 0 are bricks of cells, those of this level single cells. */
  static constexpr std::uint8_t CellLevel = 2;

  /** Where the voxels' centers are: origin + x * axes[0] + y * axes[1] + z * axes[2]. */
  struct FrameType
  {
    /** Center of the first voxel (mm). */
    PointType origin;
    /** From a voxel's center to that of its next neighbor along each axis (mm). */
    std::array<PointType, 3> axes;
  };

  ~DelaunayRefinementLatticeOracle() override;

  RegionType
  Classify(const PointType & point) const override;

  bool
  FindClosestSurfacePoint(const PointType & point, double maximumDistance, PointType & closest) const override;

  bool
  IsSurfaceWithin(const PointType & point, double distance) const override;

  bool
  FindFirstCrossing(const PointType & from, const PointType & to, PointType & crossing) const override;

  bool
  MayIntersectBox(const BoundsType & box) const override;

  BoundsType
  GetSurfaceBounds() const override;

  SurfacePatches
  GetSurfacePatches() const override;

  /** Not under a user's interpolator, which is asked at points alone. */
  bool
  KnowsAllSurface() const override
  {
    return m_Model != ModelEnum::FIELD;
  }

  void
  SplitSurfacePatch(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const override;

  SurfaceCells::AxesType
  GetCellAxes() const override;

  SurfaceCells
  GetCellsOfPatch(const SurfacePatches::PatchType & patch) const override;

  void
  AppendCells(const SurfaceCells & cells, SurfacePatches & patches) const override;

  bool
  FindPointOfPatch(const SurfacePatchIdentifier & patch, PointType & point) const override;

  JunctionPatchesType
  GetJunctionPatches() const override;

  void
  SplitJunctionPatch(const SurfacePatchIdentifier & patch,
                     unsigned int                   leastRegions,
                     SurfacePatches &               parts) const override;

  bool
  FindJunctionInPatch(const SurfacePatchIdentifier & patch,
                      unsigned int                   leastRegions,
                      PointType &                    point) const override;

  ComponentType
  GetNumberOfComponents() const override;

  ComponentType
  FindComponent(const PointType & point) const override;

  double
  FindLeastAt(const PointType & point, const std::vector<double> & values) const override;

  RangeType
  FindLeastInPatch(const SurfacePatches::PatchType & patch, const std::vector<double> & values) const override;

  BoundsType
  GetComponentBounds(ComponentType component) const override;

  std::uint32_t
  GetNumberOfCavities() const override;

  std::uint32_t
  FindCavity(const PointType & point) const override;

  BoundsType
  GetCavityBounds(std::uint32_t cavity) const override;

  /** By the Euler characteristic of what each cell has inside, after FindCavities(). Components and cavities are those
   * of voxels: grey values between the voxels may part what touches in an edge. Handles smaller than an eighth of a
   * voxel may be missed. */
  DelaunayRefinementTopology
  CountTopology() const override;

  /** For each component that was smoothed by less than the width that was asked for: what it was before, and its width
   * (mm), 0 for none. */
  const std::vector<std::pair<DelaunayRefinementComponent, double>> &
  GetLoweredWidths() const
  {
    return m_LoweredWidths;
  }

  /** INDICATOR, one region that is not smoothed: joins voxels inside that touch in an edge alone, where the half level
   * is no 2-manifold, by raising the interpolated mask at the two voxels outside between them; the surface comes nearer
   * to these, by a sixth of a voxel at most. To be called after RemoveComponents(). Does nothing for other models. */
  void
  JoinDiagonalVoxels();

  /** Makes components outside; the others keep their order. */
  void
  RemoveComponents(const std::vector<bool> & isRemoved);

  /** Describes the components. Inscribed radii are found by climbing away from the surface, which stops once \c enough
   * is reached: they may be too small, never too large; by a tenth for small components of masks unless \c isAccurate.
   */
  std::vector<DelaunayRefinementComponent>
  ComputeComponents(double enough, bool isAccurate = false) const;

  /** Finds the cavities of the object, as it was before it was smoothed, and describes them. There are none before. */
  std::vector<DelaunayRefinementCavity>
  FindCavities();

  /** Area of the surface (mm^2), estimated from the faces of the mask's voxels. */
  double
  EstimateSurfaceArea() const;

  /** Volume of the object's voxels (mm^3). */
  double
  ComputeVoxelVolume() const;

  /** A delta that suits the voxels' size and leads to some 300,000 tetrahedra at most. */
  double
  ComputeDefaultDelta() const;

  /** The delta for a component: \c delta, or less if the component is too thin for it. */
  double
  ComputeComponentDelta(const DelaunayRefinementComponent & component, double delta) const;

  /** Whether a component has fewer than 8 voxels and is much too small for \c delta. */
  bool
  IsNegligible(const DelaunayRefinementComponent & component, double delta) const;

  /** False for components of voxels at the level of a grey image that do not rise above it. */
  bool
  HasVolume(const DelaunayRefinementComponent & component) const;

  /** A rough estimate of the number of tetrahedra of the mesh, with one delta for all components. */
  double
  EstimateNumberOfTetrahedra(const DelaunayRefinementParameters & parameters) const;

  /** No less than that, and cheap: some three times as much if voxels are about as long as wide. */
  double
  BoundNumberOfTetrahedra(const DelaunayRefinementParameters & parameters) const;

  /** The same for one component with a delta of its own. */
  double
  EstimateNumberOfTetrahedra(const DelaunayRefinementComponent & component, double delta) const;

protected:
  /** Nothing can be asked before Initialize(). */
  DelaunayRefinementLatticeOracle();

  /** Takes the mask, its components and the frame, and sets up the search for the surface. With \c changes the object
   * has regions, which GetVoxelRegion() tells; models are INDICATOR or NEAREST then. Threads, if there are any, share
   * the work here and in what describes the object as a whole; they must outlive the oracle. */
  void
  Initialize(ModelEnum                                        model,
             const FrameType &                                frame,
             DelaunayRefinementVoxelMask                      mask,
             DelaunayRefinementVoxelComponents                components,
             DelaunayRefinementThreads *                      threads = nullptr,
             std::unique_ptr<DelaunayRefinementRegionChanges> changes = nullptr);

  /** INDICATOR: smooths the indicators of all regions by a width (mm) of at most 6 of the least spacing; components
   * that are thinner than four widths, or would lose some hundredths of their voxels, by a half of it, a quarter, and
   * so on. To be called once, after Initialize(). */
  void
  Smooth(double width);

  /** GREY: the value of a voxel minus the level; its sign need not agree with the mask, which prevails. May be called
   * on several threads at once. */
  virtual double
  GetVoxelValue(std::int32_t x, std::int32_t y, std::int32_t z) const;

  /** Regions: that of a voxel that the mask has. May be called on several threads at once. */
  virtual RegionType
  GetVoxelRegion(std::int32_t x, std::int32_t y, std::int32_t z) const;

  /** The same for those of 2 x 2 x 2 voxels, x fastest, whose bits are set. Default: by GetVoxelRegion(). */
  virtual void
  GetVoxelRegions(const std::array<std::int32_t, 3> & first,
                  unsigned int                        voxels,
                  std::array<RegionType, 8> &         regions) const;

  /** Whether there may be more than two regions, outside counted, among 5 x 5 x 5 voxels of which some may be outside
   * of the image. May be called on several threads at once. Default: yes. */
  virtual bool
  MayHaveJunctions(const std::array<std::int32_t, 3> & first) const;

  /** FIELD: whether a point is inside, given in voxels from the first voxel's center. May be called on several threads
   * at once. */
  virtual bool
  IsInsideField(const PointType & position) const;

private:
  using IndexType = std::array<std::int32_t, 3>;

  bool
  HasRegions() const
  {
    return m_Changes != nullptr;
  }

  /** Lattice coordinates count voxels from the outer layer: cell (i, j, k) spans [i, i+1] x [j, j+1] x [k, k+1]. */
  PointType
  ToLattice(const PointType & physical) const;
  PointType
  ToPhysical(const PointType & lattice) const;
  BoundsType
  ToPhysical(const BoundsType & lattice) const;

  /** Bounds on the values of the components with voxels at the corners of some cells, \c last included; those of the
   * component nearest to \c point if there are none. */
  RangeType
  FindRangeInCells(IndexType first, IndexType last, const PointType & point, const std::vector<double> & values) const;

  /** Of one voxel (mm^3). */
  double
  GetVoxelVolume() const;

  double
  GetSquaredLength(const PointType & latticeVector) const;

  /** A lower bound on the squared length of vectors with at least these absolute coordinates. */
  double
  GetLeastSquaredLength(const PointType & separations) const;

  /** An upper bound on the length of vectors with at most these absolute coordinates. */
  double
  GetGreatestLength(const PointType & extents) const;

  /** Half the box around all vectors with at most these absolute coordinates. */
  PointType
  GetHalfExtents(const PointType & extents) const;

  /** GREY: the values at the corners of a cell, minus the level. */
  std::array<double, 8>
  GetCellValues(const IndexType & cell) const;

  /** The octants of a cube of a cell that may hold surface, x fastest. */
  unsigned int
  FindOctants(const IndexType & cell, const PointType & corner, double size) const;

  double
  GetCornerValue(std::int32_t x, std::int32_t y, std::int32_t z) const;

  /** Calls \c visitor with the cell in the kind that the model asks for. */
  template <typename TVisitor>
  auto
  VisitCell(const IndexType & cell, const TVisitor & visitor) const;

  bool
  FindChangeInBrick(const IndexType & brick,
                    const PointType & from,
                    const PointType & direction,
                    double            begin,
                    double            end,
                    RegionType        region,
                    double &          share) const;

  /** The region of a voxel of the mask, as it is now. */
  RegionType
  GetRegion(std::int32_t x, std::int32_t y, std::int32_t z) const;

  /** The value of a voxel, as it is now, or of one of the outer layer. */
  double
  GetValue(std::int32_t x, std::int32_t y, std::int32_t z) const;

  /** Mask, components and bricks follow what was smoothed. */
  void
  TakeSmoothedRegions();

  DelaunayRefinementRegionsCell
  MakeSmoothedCell(const IndexType & cell) const;

  /** The regions of a cell's corners. */
  std::array<RegionType, 8>
  GetCellRegions(const IndexType & cell) const;

  /** The voxels of a cell at which the interpolated mask was raised. */
  unsigned int
  GetRaised(const IndexType & cell) const
  {
    return m_Raised != nullptr ? m_Raised->GetConfiguration(cell[0], cell[1], cell[2]) : 0;
  }

  /** The entry of the indicator's tables that describes a cell with surface; 0 if there is none, as for other models,
   * where the mask was raised, and for more than two regions. */
  unsigned int
  GetIndicatorConfiguration(const IndexType & cell) const;

  /** The region that has all corners of a cell without surface. */
  RegionType
  GetUniformRegion(const IndexType & cell) const;

  /** INDICATOR: of a cell and of its eight octants, which of them may hold surface and within which boxes. */
  struct CellShapesType
  {
    unsigned int                             octants;
    SurfacePatches::ShapeType                cell;
    std::array<SurfacePatches::ShapeType, 8> parts;
  };

  /** One for each configuration of a cell. */
  std::vector<CellShapesType>
  MakeCellShapes() const;

  /** The quarters of a cell, 64 in all, that may hold surface: bit x + 4 y + 16 z. */
  std::uint64_t
  GetQuarters(const IndexType & cell) const;

  /** The box around a patch from a corner, both in lattice coordinates. */
  SurfacePatches::ShapeType
  MakeShape(const PointType & center, const PointType & extents) const;

  /** Around some of 4 x 4 x 4 cubes, with bits as in GetQuarters(), from the corner of the first. */
  SurfacePatches::ShapeType
  MakeShapeOfCubes(std::uint64_t cubes, double cubeSize) const;

  /** The octants of a patch within a cell that may hold surface. */
  unsigned int
  GetOctants(const SurfacePatchIdentifier & patch) const;

  void
  SplitBrick(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const;
  void
  AddCell(const SurfacePatchIdentifier & cell, const std::array<float, 3> & corner, SurfacePatches & patches) const;
  void
  SplitCell(const SurfacePatchIdentifier & patch, SurfacePatches & parts) const;

  class TopologyCount;

  class ClosestSearch;

  double
  GetLeastSpacing() const;

  /** As FindClosestSurfacePoint(); but of points nearer than \c nearEnough the first one that is found will do, and any
   * that is nearest but for a share \c slack of its distance. */
  bool
  FindClosestSurfacePoint(const PointType & point,
                          double            maximumDistance,
                          double            nearEnough,
                          double            slack,
                          PointType &       closest) const;

  /** Some voxels of each component, in the order of its runs. */
  struct CandidateType
  {
    IndexType     voxel;
    ComponentType component;
  };
  std::vector<CandidateType>
  ChooseCandidates() const;

  /** How far the surface is along the axis where it is nearest, and what decides between equals. */
  std::pair<double, double>
  MeasureThickness(const IndexType & voxel, double enough) const;

  /** For each component a voxel that is likely to be far from the surface; up to \c enough matters. */
  std::vector<IndexType>
  FindThickVoxels(double enough) const;

  /** Tetrahedra for an area of the surface and the object's volume. */
  double
  EstimateNumberOfTetrahedra(double area, const DelaunayRefinementParameters & parameters) const;

  /** The area of a voxel's face that is crossed by an axis. */
  double
  GetFaceArea(unsigned int axis) const;

  double
  ClimbToInscribedRadius(const IndexType & voxel, double enough, double slack) const;

  ModelEnum                                                   m_Model{ ModelEnum::INDICATOR };
  FrameType                                                   m_Frame{};
  PointType                                                   m_LatticeOrigin{};
  std::array<PointType, 3>                                    m_InverseRows{};
  std::array<PointType, 3>                                    m_Gram{};
  double                                                      m_LeastStretch{ 1.0 };
  PointType                                                   m_CellEdges{}; // along the axes of GetCellAxes()
  std::vector<CellShapesType>                                 m_CellShapes{};
  std::array<std::array<float, 3>, 8>                         m_CornerOffsets{};
  std::unique_ptr<DelaunayRefinementVoxelMask>                m_Mask;
  std::unique_ptr<DelaunayRefinementVoxelMask>                m_Raised{};
  std::unique_ptr<DelaunayRefinementRegionChanges>            m_Changes;
  std::unique_ptr<DelaunayRefinementVoxelComponents>          m_Components;
  std::unique_ptr<DelaunayRefinementVoxelCavities>            m_Cavities{};
  std::unique_ptr<DelaunayRefinementBricks>                   m_Bricks;
  std::unique_ptr<DelaunayRefinementSmoothedRegions>          m_Smoothed;
  std::vector<std::pair<DelaunayRefinementComponent, double>> m_LoweredWidths{};
  DelaunayRefinementThreads *                                 m_Threads{ nullptr };
};
} // end namespace itk

#endif
