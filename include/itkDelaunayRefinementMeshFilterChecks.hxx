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
#ifndef itkDelaunayRefinementMeshFilterChecks_hxx
#define itkDelaunayRefinementMeshFilterChecks_hxx

// What the filter may object to, before the run and when it ended too soon. Included at the end of the filter's own
// file.

#include "itkDelaunayRefinementMeshFilter.h"

#include "itkDelaunayRefinementImageCensus.h"
#include "itksys/SystemInformation.hxx"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  const auto isPositive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (ImageDimension != 3)
  {
    itkExceptionMacro("The image has dimension " << ImageDimension << "; only images of dimension 3 can be meshed");
  }
  if (m_DeltaIsSet && !isPositive(m_Delta))
  {
    itkExceptionMacro("Delta is " << m_Delta << "; it must be a positive, finite length");
  }
  for (const auto & labelDelta : m_LabelDeltas)
  {
    if (!isPositive(labelDelta.second))
    {
      itkExceptionMacro("LabelDelta of the label "
                        << static_cast<typename NumericTraits<InputPixelType>::PrintType>(labelDelta.first) << " is "
                        << labelDelta.second << "; it must be a positive, finite length");
    }
  }
  if (!(std::isfinite(m_RadiusEdgeRatioBound) && m_RadiusEdgeRatioBound >= 1.0))
  {
    itkExceptionMacro("RadiusEdgeRatioBound is " << m_RadiusEdgeRatioBound << "; it must be finite and at least 1");
  }
  if (!(m_CellSize > 0.0))
  {
    itkExceptionMacro("CellSize is " << m_CellSize << "; it must be a positive length");
  }
  if (!(m_HausdorffBound >= 0.0 && std::isfinite(m_HausdorffBound)))
  {
    itkExceptionMacro("HausdorffBound is " << m_HausdorffBound << "; it must be a length, or 0 for no bound");
  }
  if (!(m_MinimumDelta >= 0.0 && std::isfinite(m_MinimumDelta)))
  {
    itkExceptionMacro("MinimumDelta is " << m_MinimumDelta << "; it must be a length, or 0 for Delta alone");
  }
  if (m_PreserveTopology && !m_Manifold)
  {
    itkExceptionMacro("PreserveTopology needs a boundary that is a 2-manifold; set Manifold on");
  }
  if (!(m_MinimumDihedralAngle >= 0.0 && m_MinimumDihedralAngle < 60.0))
  {
    itkExceptionMacro("MinimumDihedralAngle is " << m_MinimumDihedralAngle
                                                 << "; it must be at least 0 and below 60 degrees");
  }
  if (m_PaperSlivers && m_MinimumDihedralAngle == 0.0)
  {
    itkExceptionMacro("PaperSlivers needs a bound on dihedral angles; set MinimumDihedralAngle");
  }
  if (m_MaximumNumberOfVertices == 0)
  {
    itkExceptionMacro("MaximumNumberOfVertices is 0; it must be positive");
  }
  if (m_IsoValueIsSet && !std::isfinite(m_IsoValue))
  {
    itkExceptionMacro("IsoValue is " << m_IsoValue << "; it must be finite");
  }
  if (std::isnan(m_LowerThreshold) || std::isnan(m_UpperThreshold) || m_LowerThreshold > m_UpperThreshold)
  {
    itkExceptionMacro("LowerThreshold is " << m_LowerThreshold << " and UpperThreshold is " << m_UpperThreshold
                                           << "; they must be numbers, the lower one not above the upper one");
  }
  if (!(std::isfinite(m_Smoothing) && m_Smoothing >= 0.0))
  {
    itkExceptionMacro("Smoothing is " << m_Smoothing << "; it must be a finite length, 0 for none");
  }
  if (m_Smoothing > 0.0 && m_IsoValueIsSet)
  {
    itkExceptionMacro("Smoothing is for labels and thresholds, and IsoValue is set; smooth the image instead, or leave "
                      "Smoothing at 0");
  }
  const bool hasThreshold = m_LowerThresholdIsSet || m_UpperThresholdIsSet;
  if ((m_IsoValueIsSet ? 1 : 0) + (hasThreshold ? 1 : 0) + (m_Labels.empty() && !m_MergeLabels ? 0 : 1) > 1)
  {
    itkExceptionMacro("IsoValue, LowerThreshold with UpperThreshold, and Labels with MergeLabels define the object in "
                      "different ways; set only one of them");
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::VerifyGeometry(const InputImageType * image) const
{
  const auto & d = image->GetDirection();
  const double determinant = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                             d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                             d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  constexpr double leastDeterminant = 1e-6;
  bool             isUsable = std::abs(determinant) >= leastDeterminant; // false for NaN
  for (unsigned int i = 0; i < ImageDimension; ++i)
  {
    isUsable = isUsable && std::isfinite(image->GetOrigin()[i]) && std::isfinite(image->GetSpacing()[i]);
  }
  if (!isUsable)
  {
    itkExceptionMacro("The image's origin, spacing and direction must be finite numbers, the direction not singular");
  }
  // Time and memory grow with the cube of it.
  constexpr double largestSmoothing = 6.0;
  const auto &     spacing = image->GetSpacing();
  const double     least = std::min({ spacing[0], spacing[1], spacing[2] });
  if (m_Smoothing > largestSmoothing * least)
  {
    itkExceptionMacro("Smoothing is " << m_Smoothing << " mm; it must be no larger than " << largestSmoothing
                                      << " times the least spacing of the voxels, which is " << least << " mm");
  }
  // Pieces of the surface are asked for that are smaller than the bound.
  constexpr double leastBound = 0.25;
  if (m_HausdorffBound > 0.0 && m_HausdorffBound < leastBound * least)
  {
    itkExceptionMacro("HausdorffBound is " << m_HausdorffBound << " mm; it must be at least " << leastBound
                                           << " times the least spacing of the voxels, which is " << least << " mm");
  }
}

template <typename TInputImage, typename TOutputMesh>
DelaunayRefinementOracle::RangeType
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::VerifySizeField() const
{
  constexpr double                    infinity = std::numeric_limits<double>::infinity();
  DelaunayRefinementOracle::RangeType range{ infinity, 0.0 };
  const SizeFieldType * const         field = this->GetSizeField();
  if (field == nullptr)
  {
    return range;
  }
  const std::size_t number = field->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < number; ++i)
  {
    const double size = field->GetBufferPointer()[i];
    if (!(size > 0.0 && std::isfinite(size)))
    {
      const auto index = field->ComputeIndex(static_cast<OffsetValueType>(i));
      itkExceptionMacro("SizeField has the value " << size << " at (" << index[0] << ", " << index[1] << ", "
                                                   << index[2] << "); all must be positive, finite lengths");
    }
    range.least = std::min(range.least, size);
    range.greatest = std::max(range.greatest, size);
  }
  if (number == 0)
  {
    itkExceptionMacro("SizeField is empty");
  }
  return range;
}

template <typename TInputImage, typename TOutputMesh>
double
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::EstimateGrowth(
  const DelaunayRefinementLatticeOracle & oracle,
  const DelaunayRefinementParameters &    parameters) const
{
  if (!parameters.sizeField)
  {
    return 1.0;
  }
  const auto  patches = oracle.GetSurfacePatches();
  double      sum = 0.0;
  std::size_t numberWithin = 0;
  for (std::size_t i = 0; i < patches.GetSize(); ++i)
  {
    const double own = parameters.sizeField(patches.Get(i).center, 0.0);
    const double size = std::min(parameters.delta, own);
    numberWithin += std::isfinite(own) ? 1 : 0;
    sum += (parameters.delta / size) * (parameters.delta / size);
  }
  if (numberWithin == 0)
  {
    itkExceptionMacro("SizeField lies elsewhere in space than the object; check its origin, spacing and direction");
  }
  return sum / static_cast<double>(patches.GetSize());
}

template <typename TInputImage, typename TOutputMesh>
typename DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::LabelsType
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::ChooseObject(const InputImageType *      image,
                                                                     DelaunayRefinementThreads & threads,
                                                                     ObjectType &                object) const
{
  using DefinitionEnum = typename ObjectType::DefinitionEnum;
  const auto & region = image->GetBufferedRegion();
  if (region.GetNumberOfPixels() == 0)
  {
    itkExceptionMacro("The image is empty");
  }
  const DelaunayRefinementImageCensus<InputPixelType> census(
    image->GetBufferPointer(), region.GetNumberOfPixels(), region.GetSize(0), &threads);
  if (census.HasNaN())
  {
    itkExceptionMacro("The image has pixels that are NaN (not a number); replace them by values");
  }
  // The label of all but the image's own.
  const LabelsType merged{ InputPixelType{ 1 } };
  object.minimumComponentSize = m_MinimumComponentSize;
  object.largestComponentOnly = m_LargestComponentOnly;
  object.smoothingWidth = m_Smoothing;
  if (m_IsoValueIsSet)
  {
    object.definition = DefinitionEnum::ISO_VALUE;
    object.isoValue = m_IsoValue;
    return merged;
  }
  if (m_LowerThresholdIsSet || m_UpperThresholdIsSet)
  {
    object.definition = DefinitionEnum::THRESHOLD;
    object.lower = m_LowerThreshold;
    object.upper = m_UpperThreshold;
    return merged;
  }
  if (std::is_floating_point<InputPixelType>::value)
  {
    itkExceptionMacro("The image has floating-point values, which are no labels; set IsoValue, or LowerThreshold and "
                      "UpperThreshold");
  }
  const std::vector<InputPixelType> labels = census.FindLabels();
  for (const InputPixelType label : m_Labels)
  {
    if (!(label > InputPixelType{ 0 }))
    {
      itkExceptionMacro("Labels has the value " << static_cast<double>(label)
                                                << "; labels must be positive, 0 being outside");
    }
    if (!std::binary_search(labels.begin(), labels.end(), label))
    {
      itkExceptionMacro("No voxel has the label " << static_cast<double>(label) << " of Labels; the image has "
                                                  << this->DescribeLabels(labels));
    }
  }
  if (!m_Labels.empty())
  {
    object.definition = DefinitionEnum::LABELS;
    object.labels = m_Labels;
    std::sort(object.labels.begin(), object.labels.end());
    object.labels.erase(std::unique(object.labels.begin(), object.labels.end()), object.labels.end());
    object.regionLabels = m_MergeLabels ? merged : object.labels;
    return object.regionLabels;
  }
  object.definition = DefinitionEnum::NON_ZERO;
  if (labels.empty())
  {
    return merged;
  }
  constexpr std::size_t manyLabels = 8;
  constexpr double      speckled = 0.3;
  if (!m_MergeLabels && labels.size() >= manyLabels && census.ComputeSpeckle() > speckled)
  {
    itkExceptionMacro("The image seems to hold grey values, not labels: " << labels.size()
                                                                          << " values change from voxel to voxel. Set "
                                                                             "LowerThreshold and UpperThreshold, or "
                                                                             "IsoValue, or MergeLabels");
  }
  if (labels.front() < InputPixelType{ 0 })
  {
    itkExceptionMacro("The image has negative values, which are no labels; set LowerThreshold and UpperThreshold, or "
                      "IsoValue, or Labels");
  }
  object.regionLabels = m_MergeLabels ? merged : labels;
  return object.regionLabels;
}

template <typename TInputImage, typename TOutputMesh>
std::string
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::DescribeLabels(const LabelsType & labels)
{
  std::ostringstream text;
  text << labels.size() << (labels.size() == 1 ? " label" : " labels") << (labels.empty() ? "" : ": ")
       << DescribeSome(labels.size(), [&labels](std::ostream & some, std::size_t i) {
            some << static_cast<typename NumericTraits<InputPixelType>::PrintType>(labels[i]);
          });
  return text.str();
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::VerifyObject(
  const InputImageType *                  image,
  const DelaunayRefinementLatticeOracle & oracle) const
{
  if (oracle.GetNumberOfComponents() > 0)
  {
    return;
  }
  const auto & region = image->GetBufferedRegion();
  const auto   range = DelaunayRefinementImageCensus<InputPixelType>(
                       image->GetBufferPointer(), region.GetNumberOfPixels(), region.GetSize(0))
                       .FindRange();
  std::ostringstream why;
  if (m_IsoValueIsSet)
  {
    why << "no voxel reaches the IsoValue " << m_IsoValue;
  }
  else if (m_LowerThresholdIsSet || m_UpperThresholdIsSet)
  {
    why << "no voxel is between LowerThreshold " << m_LowerThreshold << " and UpperThreshold " << m_UpperThreshold;
  }
  else
  {
    why << "no voxel has a label";
  }
  itkExceptionMacro("There is no object to mesh: " << why.str() << ", or no component has MinimumComponentSize "
                                                   << m_MinimumComponentSize << " voxels; pixel values range from "
                                                   << static_cast<double>(range.first) << " to "
                                                   << static_cast<double>(range.second));
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::VerifyPrecision(const DelaunayRefinementLatticeOracle & oracle,
                                                                        const DelaunayRefinementParameters & parameters,
                                                                        double leastSize) const
{
  using CoordinateType = typename OutputMeshType::CoordRepType;
  constexpr double largestShare = 0.05;
  const auto       bounds = oracle.GetSurfaceBounds();
  double           largest = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    largest = std::max({ largest, std::abs(bounds.minimum[i]), std::abs(bounds.maximum[i]) });
  }
  const double least =
    std::min(*std::min_element(parameters.componentDelta.begin(), parameters.componentDelta.end()), leastSize);
  if (largest * static_cast<double>(std::numeric_limits<CoordinateType>::epsilon()) > largestShare * least)
  {
    itkExceptionMacro("Coordinates as large as "
                      << largest << " mm can't tell points apart for Delta " << least
                      << " mm in the mesh's type of coordinates; use a mesh with double "
                         "coordinates, a larger Delta (and SizeField, if there is one), or an origin "
                         "nearer to 0");
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::VerifyMemory(
  const DelaunayRefinementLatticeOracle & oracle,
  const std::vector<std::uint32_t> &      kept,
  const DelaunayRefinementParameters &    parameters) const
{
  // Measured: some 800 bytes for each tetrahedron of the mesh, those outside it included.
  constexpr double megabytesPerTetrahedron = 1e-3;
  const double     growth = this->EstimateGrowth(oracle, parameters);
  double           ofComponents = 0.0;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    if (parameters.componentDelta[i] < parameters.delta)
    {
      ofComponents += oracle.EstimateNumberOfTetrahedra(m_Components[kept[i]], parameters.componentDelta[i]);
    }
  }
  // So much is there, or nearly: to ask takes longer than a small mesh.
  constexpr double fewMegabytes = 256.0;
  if (megabytesPerTetrahedron * (oracle.BoundNumberOfTetrahedra(parameters) * growth + ofComponents) < fewMegabytes)
  {
    return;
  }
  const double megabytes =
    megabytesPerTetrahedron * (oracle.EstimateNumberOfTetrahedra(parameters) * growth + ofComponents);
  itksys::SystemInformation system;
  system.RunMemoryCheck();
  const double available = static_cast<double>(system.GetAvailablePhysicalMemory());
  if (megabytes > available && available > 0.0)
  {
    itkExceptionMacro("Delta " << m_EffectiveDelta << " is too small for this object: the mesh would need some "
                               << std::ceil(megabytes / 1024.0) << " GB of memory, and "
                               << std::floor(available / 1024.0) << " GB are free; set a larger Delta or CellSize"
                               << (growth > 1.0 ? ", or larger lengths in SizeField" : ""));
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::ThrowUnlessCompleted(
  DelaunayRefinementEnums::TerminationReason reason) const
{
  using TerminationReason = DelaunayRefinementEnums::TerminationReason;
  switch (reason)
  {
    case TerminationReason::COMPLETED:
      return;
    case TerminationReason::STOPPED_BY_CALLER:
    {
      ProcessAborted aborted(__FILE__, __LINE__);
      aborted.SetDescription("The mesh generation was aborted");
      aborted.SetLocation(ITK_LOCATION);
      throw aborted;
    }
    case TerminationReason::VERTEX_LIMIT:
      itkExceptionMacro("The mesh needs more vertices than MaximumNumberOfVertices, which is "
                        << m_MaximumNumberOfVertices << "; set a larger Delta or a larger MaximumNumberOfVertices");
    case TerminationReason::NO_SURFACE_FOUND:
      itkExceptionMacro("There is no object to mesh: it has no surface");
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::ThrowIfAborted() const
{
  if (this->GetAbortGenerateData())
  {
    this->ThrowUnlessCompleted(DelaunayRefinementEnums::TerminationReason::STOPPED_BY_CALLER);
  }
}

template <typename TInputImage, typename TOutputMesh>
typename TOutputMesh::CellPixelType
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::ToCellData(InputPixelType label)
{
  return static_cast<typename OutputMeshType::CellPixelType>(label);
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::VerifyLabels() const
{
  for (const InputPixelType label : m_RegionLabels)
  {
    // Long doubles hold all of both types.
    if (static_cast<long double>(ToCellData(label)) != static_cast<long double>(label))
    {
      itkExceptionMacro("The mesh's type of cell data can't hold the label "
                        << static_cast<typename NumericTraits<InputPixelType>::PrintType>(label)
                        << "; use a mesh with larger integers for cell data");
    }
  }
  for (const auto & labelDelta : m_LabelDeltas)
  {
    if (!std::binary_search(m_RegionLabels.begin(), m_RegionLabels.end(), labelDelta.first))
    {
      itkExceptionMacro("LabelDelta is set for the label "
                        << static_cast<typename NumericTraits<InputPixelType>::PrintType>(labelDelta.first)
                        << ", which is not meshed; there are " << this->DescribeLabels(m_RegionLabels));
    }
  }
  if (m_PreserveTopology && m_RegionLabels.size() > 1)
  {
    itkExceptionMacro("PreserveTopology is for one object, and there are "
                      << this->DescribeLabels(m_RegionLabels) << "; choose one of them, or set MergeLabels");
  }
  const std::string interpolator = m_Interpolator.IsNull() ? "" : m_Interpolator->GetNameOfClass();
  if (m_PreserveTopology && interpolator == "NearestNeighborInterpolateImageFunction")
  {
    itkExceptionMacro(
      "PreserveTopology does not go with nearest-neighbor interpolation, whose surface is no 2-manifold "
      "where voxels touch in an edge; set another Interpolator");
  }
  if (m_Smoothing > 0.0 && !interpolator.empty() && interpolator != "LinearInterpolateImageFunction")
  {
    itkExceptionMacro("Smoothing goes with linear interpolation alone; set another Interpolator than "
                      << interpolator << ", or leave Smoothing at 0");
  }
  if (m_RegionLabels.size() > 1 && !interpolator.empty() && interpolator != "LinearInterpolateImageFunction" &&
      interpolator != "NearestNeighborInterpolateImageFunction")
  {
    itkExceptionMacro(
      "Several labels are meshed with linear or nearest-neighbor interpolation; set another Interpolator than "
      << interpolator << ", with Smoothing for smooth interfaces, or choose one of the labels, or set MergeLabels");
  }
}
} // end namespace itk

#endif
