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
#ifndef itkDelaunayRefinementMeshFilter_h
#define itkDelaunayRefinementMeshFilter_h

#include "itkDelaunayRefinementLatticeOracle.h"
#include "itkDelaunayRefinementTypes.h"
#include "itkImageDelaunayRefinementOracle.h"
#include "itkImageToMeshFilter.h"
#include "itkInterpolateImageFunction.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementMeshFilter
 * \brief Turns a segmented 3D image into a tetrahedral mesh with guaranteed quality: image to mesh.
 *
 * The first output is a mesh of tetrahedra in the image's physical space (spacing, origin and direction apply), each
 * with the value of its label as cell data; the second output holds the triangles of its boundary and of the interfaces
 * between labels. All tetrahedra are positively oriented and have a radius-edge ratio below RadiusEdgeRatioBound; all
 * planar angles of boundary and interface triangles are above 30 degrees.
 *
 * \par The object
 * One of three definitions:
 * - labels (integer pixel types, the default): voxels with one of the \c Labels, or any value but 0; several labels
 *   are tissues of one mesh that share their interfaces' triangles, or one object with \c MergeLabels;
 * - a threshold: voxels between \c LowerThreshold and \c UpperThreshold, both included;
 * - an iso value: all points where the interpolated grey value is at or above \c IsoValue.
 * For the first two the interpolator runs over the indicator of the object (1 inside, 0 outside) and the surface is its
 * half level. Between labels the surface is where the one with the largest interpolated indicator changes; of equals
 * the smallest value counts. A tetrahedron has the label of its circumcenter. Beyond the image is outside, so an object
 * that touches the image's border is closed there, half a voxel beyond the centers of its outermost voxels.
 *
 * \par Parameters
 * Delta (mm) is the sampling density of the surface: no surface point is farther than Delta from a vertex on the
 * surface. Every other parameter has a default that suits most images.
 *
 * \par Threads
 * As many as NumberOfWorkUnits says, at most those that the MultiThreader has. The mesh is the same for any number, bit
 * for bit. The interpolator is asked by several threads at once, as ITK's own may be.
 *
 * \par Errors
 * An ExceptionObject says what to change: no object, NaN in the image, a singular direction, labels that are not in
 * the image, several labels with an interpolator of another kind than linear and nearest neighbor, parameters that
 * contradict each other or are out of range, a mesh that would not fit into memory, MaximumNumberOfVertices reached,
 * and with \c Strict a label, component or cavity that is missing in the mesh. An abort ends in ProcessAborted.
 *
 * \par References
 * P. Foteinos, A. Chernikov, N. Chrisochoides, "Guaranteed Quality Tetrahedral Delaunay Meshing for Medical Images",
 * International Symposium on Voronoi Diagrams in Science and Engineering, 2010.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TInputImage, typename TOutputMesh>
class ITK_TEMPLATE_EXPORT DelaunayRefinementMeshFilter : public ImageToMeshFilter<TInputImage, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DelaunayRefinementMeshFilter);

  /** Standard class type aliases. */
  /** @ITKStartGrouping */
  using Self = DelaunayRefinementMeshFilter;
  using Superclass = ImageToMeshFilter<TInputImage, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  /** @ITKEndGrouping */

  /** Method for creation through the object factory. */
  itkNewMacro(Self);

  /** Run-time type information. */
  itkTypeMacro(DelaunayRefinementMeshFilter, ImageToMeshFilter);

  /** The image: 3D, with scalar pixels; integers if they are labels. */
  /** @ITKStartGrouping */
  using InputImageType = TInputImage;
  using InputPixelType = typename TInputImage::PixelType;
  /** @ITKEndGrouping */

  /** The type of both outputs; its cell data hold the labels. */
  using OutputMeshType = TOutputMesh;

  /** Labels of cells. */
  using CellDataType = typename TOutputMesh::CellDataContainer;

  /** What may stand between the pixels. */
  using InterpolatorType = InterpolateImageFunction<TInputImage, double>;

  /** An image of lengths (mm). */
  using SizeFieldType = Image<float, 3>;

  /** A list of pixel values. */
  using LabelsType = std::vector<InputPixelType>;

  /** Components with widths (mm). */
  using LoweredSmoothingsType = std::vector<std::pair<DelaunayRefinementComponent, double>>;

  /** Dimension of the image; Update() throws if it is not 3. */
  static constexpr unsigned int ImageDimension = TInputImage::ImageDimension;

  /** The triangles of the mesh's boundary and of the interfaces between labels, in physical space. Each has as cell
   * data the larger one of the two labels that it parts, and is counterclockwise as seen from the other one, which is 0
   * for outside. Empty before the first Update(). */
  OutputMeshType *
  GetBoundaryOutput();

  /** For each triangle of GetBoundaryOutput() the smaller one of the two labels that it parts; 0 is outside. Empty
   * before the first Update(). */
  const CellDataType *
  GetBoundaryOtherLabels() const
  {
    return m_BoundaryOtherLabels;
  }

  /** Sampling density of the surface, the paper's delta (section III), in physical units (mm): no point of the surface
   * is farther from a vertex on the surface. Positive and finite, else Update() throws. Unset, the default, it is
   * chosen from the spacing and the size of the object so that the mesh has some 300,000 tetrahedra at most;
   * GetEffectiveDelta() tells the choice. GetDelta() is 0 if it is unset. */
  /** @ITKStartGrouping */
  void
  SetDelta(double delta);
  itkGetConstMacro(Delta, double);
  void
  UnsetDelta();
  /** @ITKEndGrouping */

  /** Delta for the surface of one label, its interfaces with others included, in physical units (mm); the smaller one
   * of two labels' deltas holds where they meet. Delta holds for all other labels. Positive and finite, else Update()
   * throws, as it does if the label is not meshed. Elements grow gradually between a small and a large delta. */
  /** @ITKStartGrouping */
  void
  SetLabelDelta(InputPixelType label, double delta);
  double
  GetLabelDelta(InputPixelType label) const;
  void
  UnsetLabelDeltas();
  /** @ITKEndGrouping */

  /** Upper bound on the ratio of circumradius to shortest edge of every tetrahedron, a number without unit: the paper's
   * rho bar (rule R4 and Theorem 2). Finite and at least 1, else Update() throws; default 2. Below 2 the boundary may
   * have vertices off the surface (Lemma 5). */
  /** @ITKStartGrouping */
  itkSetMacro(RadiusEdgeRatioBound, double);
  itkGetConstMacro(RadiusEdgeRatioBound, double);
  /** @ITKEndGrouping */

  /** Upper bound on the circumradius of tetrahedra, in physical units (mm). Positive, else Update() throws; default
   * infinity: no bound. Not in the paper. */
  /** @ITKStartGrouping */
  itkSetMacro(CellSize, double);
  itkGetConstMacro(CellSize, double);
  /** @ITKEndGrouping */

  /** Lower bound on all dihedral angles, in degrees: slivers are removed, by vertices inserted and moved, with all
   * other guarantees kept. At least 0 and below 60, else Update() throws; default 0: off. Up to some 15 degrees on
   * images of organs, and 20 on smooth shapes, all of them go; a warning says if some are left, and GetStatistics()
   * which. At 10 degrees the mesh grows by a tenth. Not in the paper. */
  /** @ITKStartGrouping */
  itkSetMacro(MinimumDihedralAngle, double);
  itkGetConstMacro(MinimumDihedralAngle, double);
  /** @ITKEndGrouping */

  /** Against dihedral angles below MinimumDihedralAngle, which has to be set or Update() throws, the paper's own rule
   * is applied instead: R4' (section VI-B) splits such tetrahedra at their circumcenters, here as long as that keeps
   * edges above a quarter of Delta. It leaves some, keeps no angle for sure, and the mesh grows more. Default off. */
  /** @ITKStartGrouping */
  itkSetMacro(PaperSlivers, bool);
  itkGetConstMacro(PaperSlivers, bool);
  itkBooleanMacro(PaperSlivers);
  /** @ITKEndGrouping */

  /** Rule R2, with E1 to E3, is applied to all intersecting tetrahedra, as in the paper (section III), not only to
   * those with a vertex on the surface and their circumcenter inside the object. No guarantee needs it, and the run
   * takes about twice as long. Default off. */
  /** @ITKStartGrouping */
  itkSetMacro(RefineOutside, bool);
  itkGetConstMacro(RefineOutside, bool);
  itkBooleanMacro(RefineOutside);
  /** @ITKEndGrouping */

  /** The boundary of the object, and of each label, is made a 2-manifold: two triangles at each edge, one fan of them
   * at each vertex. A few tetrahedra come in or go out for it against where their circumcenter is. Between labels some
   * edges or vertices may be left, which the statistics count. Default on. Not in the paper. */
  /** @ITKStartGrouping */
  itkSetMacro(Manifold, bool);
  itkGetConstMacro(Manifold, bool);
  itkBooleanMacro(Manifold);
  /** @ITKEndGrouping */

  /** Upper bound, in physical units (mm), on the Hausdorff distance between the boundary of the mesh and the surface in
   * the image, cavities and interfaces between labels included: no point of either is farther from the other. Delta is
   * lowered where that takes it, and a warning says if it could not be kept. 0 for no bound, which is the default, or
   * finite and at least a quarter of the least spacing, else Update() throws. Not in the paper, which has a bound for
   * small Delta. */
  /** @ITKStartGrouping */
  itkSetMacro(HausdorffBound, double);
  itkGetConstMacro(HausdorffBound, double);
  /** @ITKEndGrouping */

  /** Delta is lowered, to a thirty-second of the least spacing if need be, where boundary and surface are joined in
   * different ways, until the mesh has as many components, cavities and handles as the object in the image; a warning
   * says if that was not reached. GetStatistics() has the counts. Voxels that touch in an edge are joined then, which
   * moves the surface there by a sixth of a voxel at most. For one object, not for several labels, with Manifold on,
   * and not with nearest-neighbor interpolation, else Update() throws. Give a mask by labels or a threshold: where an
   * iso value ties with pixels, what touches in an edge is not joined. Default off. Not in the paper. */
  /** @ITKStartGrouping */
  itkSetMacro(PreserveTopology, bool);
  itkGetConstMacro(PreserveTopology, bool);
  itkBooleanMacro(PreserveTopology);
  /** @ITKEndGrouping */

  /** Delta is lowered down to this, in physical units (mm), where the surface is bent or parts are thin: where boundary
   * and surface are farther from each other than 15 % of the delta there, and than the least spacing, or a quarter of
   * it with an iso value or with Smoothing. Finite, not negative, and no larger than Delta, else Update() throws; 0,
   * the default, leaves Delta as it is. Not in the paper. */
  /** @ITKStartGrouping */
  itkSetMacro(MinimumDelta, double);
  itkGetConstMacro(MinimumDelta, double);
  /** @ITKEndGrouping */

  /** An image of lengths in physical units (mm): an upper bound on delta at each point of the surface, interpolated
   * linearly, beside Delta, which holds alone beyond that image. It may have any spacing, origin and direction. Delta
   * grows from small lengths to large ones by at most half of the distance between them. Unset Delta is the greatest
   * length then. All pixels must be positive and finite, else Update() throws. Default: none. */
  /** @ITKStartGrouping */
  itkSetInputMacro(SizeField, SizeFieldType);
  itkGetInputMacro(SizeField, SizeFieldType);
  /** @ITKEndGrouping */

  /** The filter gives up with an exception before the triangulation (vertices outside the object included) has more
   * vertices. Positive, else Update() throws; default: the largest number, no limit. Not in the paper. */
  /** @ITKStartGrouping */
  itkSetMacro(MaximumNumberOfVertices, SizeValueType);
  itkGetConstMacro(MaximumNumberOfVertices, SizeValueType);
  /** @ITKEndGrouping */

  /** Defines the object by an iso value, in pixel values: inside is where the interpolated value is at or above it.
   * Finite, else Update() throws, as it does if another definition is set. Unset by default, GetIsoValue() is 0 then.
   */
  /** @ITKStartGrouping */
  void
  SetIsoValue(double value);
  itkGetConstMacro(IsoValue, double);
  /** @ITKEndGrouping */

  /** Defines the object by a range of pixel values, both ends included. One end may be left unset, and is infinite
   * then, which is the default of both. Update() throws if the lower one is above the upper one, if one is NaN, or if
   * another definition is set. */
  /** @ITKStartGrouping */
  void
  SetLowerThreshold(double value);
  itkGetConstMacro(LowerThreshold, double);
  void
  SetUpperThreshold(double value);
  itkGetConstMacro(UpperThreshold, double);
  /** @ITKEndGrouping */

  /** Defines the object by labels, pixel values above 0; all others are outside. Empty, the default: every value but 0.
   * Update() throws if there is no pixel of a label, or if another definition is set. */
  /** @ITKStartGrouping */
  void
  SetLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(Labels, LabelsType);
  /** @ITKEndGrouping */

  /** Unsets the iso value, the thresholds and the labels: back to every label but 0. */
  void
  UnsetObjectDefinition();

  /** Several labels are meshed as one object, whose label is 1. Default off: they are tissues of one mesh. */
  /** @ITKStartGrouping */
  itkSetMacro(MergeLabels, bool);
  itkGetConstMacro(MergeLabels, bool);
  itkBooleanMacro(MergeLabels);
  /** @ITKEndGrouping */

  /** Width, in physical units (mm), by which the surface of labels or of a threshold's object is smoothed: the standard
   * deviation of a Gaussian over the voxels' indicators, as in itk::LabelImageGaussianInterpolateImageFunction, but
   * corrected so that curved surfaces don't shrink. A width of 0.5 to 1 voxel takes away most of the voxels' steps.
   * Components thinner than four widths, or that would lose 3 % of their voxels, are smoothed by less, and are told of
   * in the warnings. Not negative and no larger than 6 times the least spacing, else Update() throws, as it does with
   * an iso value or with another interpolator than the linear one. Default 0: not smoothed. */
  /** @ITKStartGrouping */
  itkSetMacro(Smoothing, double);
  itkGetConstMacro(Smoothing, double);
  /** @ITKEndGrouping */

  /** Only the 18-connected component of the object, labels merged, with the most voxels is meshed. Default off. */
  /** @ITKStartGrouping */
  itkSetMacro(LargestComponentOnly, bool);
  itkGetConstMacro(LargestComponentOnly, bool);
  itkBooleanMacro(LargestComponentOnly);
  /** @ITKEndGrouping */

  /** 18-connected components of the object, labels merged, with fewer voxels are left out; Update() throws if that
   * leaves none. Default 1: none is left out. Components of fewer than 8 voxels are also left out, and named in the
   * warnings, where Delta is more than 1.4 times the smallest spacing, unless the object has no other; those of several
   * labels may be missing then, and are named. */
  /** @ITKStartGrouping */
  itkSetMacro(MinimumComponentSize, SizeValueType);
  itkGetConstMacro(MinimumComponentSize, SizeValueType);
  /** @ITKEndGrouping */

  /** Update() throws if a label, component or cavity of the image is missing in the mesh, or if HausdorffBound,
   * PreserveTopology or MinimumDihedralAngle is not kept. Default off: a warning names what it is. */
  /** @ITKStartGrouping */
  itkSetMacro(Strict, bool);
  itkGetConstMacro(Strict, bool);
  itkBooleanMacro(Strict);
  /** @ITKEndGrouping */

  /** The interpolator of the indicator or of the grey values, part of the paper's function f (section II). Default:
   * linear, also if it is null. One that is neither linear nor nearest neighbor is given an input image by the filter,
   * and asked on several threads at once by EvaluateAtContinuousIndex(), which is const: one of your own that keeps
   * state there needs SetNumberOfWorkUnits(1). After a change of its own parameters call Modified() on the filter. */
  /** @ITKStartGrouping */
  itkSetObjectMacro(Interpolator, InterpolatorType);
  itkGetModifiableObjectMacro(Interpolator, InterpolatorType);
  /** @ITKEndGrouping */

  /** The delta of the last run, in physical units (mm): Delta, or the one that was chosen. 0 before the first run. */
  itkGetConstMacro(EffectiveDelta, double);

  /** Counts and times of the last run, also of one that failed. */
  itkGetConstReferenceMacro(Statistics, DelaunayRefinementStatistics);

  /** The components of the object in the last run, each of one label, in the order of their first voxels. Their regions
   * count the labels from 1. */
  itkGetConstReferenceMacro(Components, std::vector<DelaunayRefinementComponent>);

  /** The cavities of the object in the last run, in the order of their first voxels; all labels together are the
   * object. Statistics tell which of them the mesh fills. */
  itkGetConstReferenceMacro(Cavities, std::vector<DelaunayRefinementCavity>);

  /** The components that were smoothed by less than Smoothing in the last run, as they were before, and their widths in
   * physical units (mm), 0 for none. */
  itkGetConstReferenceMacro(LoweredSmoothings, LoweredSmoothingsType);

  /** The labels of the object in the last run, ascending: those of regions 1, 2, ... */
  itkGetConstReferenceMacro(RegionLabels, LabelsType);

  /** The labels of the image, of those that were to be meshed, that no tetrahedron has in the last run, ascending. */
  itkGetConstReferenceMacro(MissingLabels, LabelsType);

  /** What the user should know of the last run, a sentence each: labels, components and cavities that are missing in
   * the mesh, components for which delta or smoothing was lowered. */
  itkGetConstReferenceMacro(Warnings, std::vector<std::string>);

  /** Seconds of the last run, before the first vertex: scans of the image, components, the oracle. */
  itkGetConstMacro(PreparationSeconds, double);

  /** Seconds of the last run spent on copying into the output meshes. */
  itkGetConstMacro(CopySeconds, double);

protected:
  DelaunayRefinementMeshFilter();
  ~DelaunayRefinementMeshFilter() override = default;

  /** Prints all parameters, and what is known of the last run. */
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** Throws unless all parameters are in range and agree with each other. */
  void
  VerifyPreconditions() ITKv5_CONST override;

  /** Does nothing: meshes have nothing to tell before they are made. */
  void
  GenerateOutputInformation() override;

  /** Makes both meshes; throws if there is no object, or if the run does not end with a mesh. */
  void
  GenerateData() override;

private:
  using ObjectType = DelaunayRefinementObject<InputPixelType>;

  /** Looks at the pixels and says what the object is; returns the labels of its regions. */
  LabelsType
  ChooseObject(const InputImageType * image, DelaunayRefinementThreads & threads, ObjectType & object) const;

  static std::string
  DescribeLabels(const LabelsType & labels);

  void
  VerifyObject(const InputImageType * image, const DelaunayRefinementLatticeOracle & oracle) const;

  /** Whether a component may be left out at the delta that holds for it. */
  bool
  IsNegligible(std::uint32_t component, const DelaunayRefinementLatticeOracle & oracle) const;

  /** Returns the numbers of the components that stay. */
  std::vector<std::uint32_t>
  LeaveOutNegligibleComponents(DelaunayRefinementLatticeOracle & oracle) const;

  /** Statistics number the components as m_Components does; those left out are missing. */
  void
  RenumberComponents(const std::vector<std::uint32_t> & kept, const DelaunayRefinementParameters & parameters);

  /** The delta that the user wishes for a component. */
  double
  GetDeltaOf(const DelaunayRefinementComponent & component) const;

  unsigned int
  ComputeNumberOfThreads();

  DelaunayRefinementParameters
  MakeParameters(const DelaunayRefinementLatticeOracle & oracle,
                 const std::vector<std::uint32_t> &      kept,
                 double                                  leastSize);

  static void
  SetSizes(const SizeFieldType * field, double leastSize, DelaunayRefinementParameters & parameters);

  void
  VerifyGeometry(const InputImageType * image) const;

  /** Throws unless all its lengths are positive and finite; the least and the greatest one. Infinity and 0 if there is
   * none. */
  DelaunayRefinementOracle::RangeType
  VerifySizeField() const;

  /** How many times as many tetrahedra delta makes where the size field is less. */
  double
  EstimateGrowth(const DelaunayRefinementLatticeOracle & oracle, const DelaunayRefinementParameters & parameters) const;

  void
  VerifyPrecision(const DelaunayRefinementLatticeOracle & oracle,
                  const DelaunayRefinementParameters &    parameters,
                  double                                  leastSize) const;

  void
  VerifyMemory(const DelaunayRefinementLatticeOracle & oracle,
               const std::vector<std::uint32_t> &      kept,
               const DelaunayRefinementParameters &    parameters) const;

  void
  ThrowUnlessCompleted(DelaunayRefinementEnums::TerminationReason reason) const;

  void
  ThrowIfAborted() const;

  /** A label as the mesh's cell data hold it. */
  static typename OutputMeshType::CellPixelType
  ToCellData(InputPixelType label);

  void
  VerifyLabels() const;

  void
  FindMissingLabels(const DelaunayRefinementResult & result);

  /** The first of so many as \c describe writes them, with dots if there are more. */
  template <typename TDescribe>
  static std::string
  DescribeSome(std::size_t number, const TDescribe & describe);

  static std::string
  DescribePlace(const DelaunayRefinementPoint & place);

  /** Of a component or a cavity: how many, and where. */
  template <typename TPart>
  static std::string
  DescribeVoxels(const TPart & part);

  std::string
  DescribeComponent(const DelaunayRefinementComponent & component) const;

  /** Those that are left against a bound; empty if there are none. */
  std::string
  DescribeSlivers() const;

  void
  WarnOfLabels();

  void
  WarnOfComponents();

  void
  WarnOfCavities();

  void
  WarnOfSlivers();

  void
  WarnOfSurface();

  void
  WarnOfSmoothing();

  void
  ThrowIfStrict() const;

  /** Leaves both outputs empty if it throws. */
  void
  CopyResult(const DelaunayRefinementResult & result, DelaunayRefinementThreads & threads);

  /** Those that have a number. */
  template <typename TNumbering>
  static void
  CopyPoints(const DelaunayRefinementArray<DelaunayRefinementPoint> & from,
             std::size_t                                              number,
             const TNumbering &                                       numberOf,
             DelaunayRefinementThreads &                              threads,
             OutputMeshType *                                         to);

  /** \c regionOf gives each cell's region. */
  template <typename TCell, typename TCellPoints, typename TRegionOf, typename TNumbering>
  void
  CopyCells(const DelaunayRefinementArray<TCellPoints> & from,
            const TRegionOf &                            regionOf,
            const TNumbering &                           numberOf,
            DelaunayRefinementThreads &                  threads,
            OutputMeshType *                             to);

  double                             m_Delta{ 0.0 };
  bool                               m_DeltaIsSet{ false };
  std::map<InputPixelType, double>   m_LabelDeltas{};
  double                             m_RadiusEdgeRatioBound{ 2.0 };
  double                             m_CellSize{ std::numeric_limits<double>::infinity() };
  double                             m_MinimumDihedralAngle{ 0.0 };
  bool                               m_PaperSlivers{ false };
  bool                               m_RefineOutside{ false };
  bool                               m_Manifold{ true };
  double                             m_HausdorffBound{ 0.0 };
  bool                               m_PreserveTopology{ false };
  double                             m_MinimumDelta{ 0.0 };
  SizeValueType                      m_MaximumNumberOfVertices{ NumericTraits<SizeValueType>::max() };
  double                             m_IsoValue{ 0.0 };
  bool                               m_IsoValueIsSet{ false };
  double                             m_LowerThreshold{ -std::numeric_limits<double>::infinity() };
  bool                               m_LowerThresholdIsSet{ false };
  double                             m_UpperThreshold{ std::numeric_limits<double>::infinity() };
  bool                               m_UpperThresholdIsSet{ false };
  LabelsType                         m_Labels{};
  bool                               m_MergeLabels{ false };
  bool                               m_LargestComponentOnly{ false };
  double                             m_Smoothing{ 0.0 };
  SizeValueType                      m_MinimumComponentSize{ 1 };
  bool                               m_Strict{ false };
  typename InterpolatorType::Pointer m_Interpolator{};

  double                                   m_EffectiveDelta{ 0.0 };
  DelaunayRefinementStatistics             m_Statistics{};
  std::vector<DelaunayRefinementComponent> m_Components{};
  std::vector<DelaunayRefinementCavity>    m_Cavities{};
  LoweredSmoothingsType                    m_LoweredSmoothings{};
  LabelsType                               m_RegionLabels{};
  LabelsType                               m_MissingLabels{};
  typename CellDataType::Pointer           m_BoundaryOtherLabels{ CellDataType::New() };
  std::vector<std::string>                 m_Warnings{};
  double                                   m_PreparationSeconds{ 0.0 };
  double                                   m_CopySeconds{ 0.0 };
};
} // end namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkDelaunayRefinementMeshFilter.hxx"
#endif

#endif
