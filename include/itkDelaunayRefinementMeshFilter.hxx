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
#ifndef itkDelaunayRefinementMeshFilter_hxx
#define itkDelaunayRefinementMeshFilter_hxx

#include "itkDelaunayRefinementMeshFilter.h"

#include "itkDelaunayRefinementCellsContainer.h"
#include "itkDelaunayRefinementEngine.h"
#include "itkDelaunayRefinementFirstUses.h"
#include "itkImageDelaunayRefinementOracle.h"
#include "itkLinearInterpolateImageFunction.h"
#include "itkMultiThreaderBase.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>

namespace itk
{
template <typename TInputImage, typename TOutputMesh>
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::DelaunayRefinementMeshFilter()
{
  m_Interpolator = LinearInterpolateImageFunction<TInputImage, double>::New();
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(1, OutputMeshType::New().GetPointer());
}

template <typename TInputImage, typename TOutputMesh>
auto
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::GetBoundaryOutput() -> OutputMeshType *
{
  return dynamic_cast<OutputMeshType *>(this->ProcessObject::GetOutput(1));
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::SetDelta(double delta)
{
  if (!m_DeltaIsSet || m_Delta != delta)
  {
    m_Delta = delta;
    m_DeltaIsSet = true;
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::UnsetDelta()
{
  if (m_DeltaIsSet)
  {
    m_Delta = 0.0;
    m_DeltaIsSet = false;
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::SetLabelDelta(InputPixelType label, double delta)
{
  const auto place = m_LabelDeltas.find(label);
  if (place == m_LabelDeltas.end() || place->second != delta)
  {
    m_LabelDeltas[label] = delta;
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
double
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::GetLabelDelta(InputPixelType label) const
{
  const auto place = m_LabelDeltas.find(label);
  return place != m_LabelDeltas.end() ? place->second : m_Delta;
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::UnsetLabelDeltas()
{
  if (!m_LabelDeltas.empty())
  {
    m_LabelDeltas.clear();
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::SetIsoValue(double value)
{
  if (!m_IsoValueIsSet || m_IsoValue != value)
  {
    m_IsoValue = value;
    m_IsoValueIsSet = true;
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::SetLowerThreshold(double value)
{
  if (!m_LowerThresholdIsSet || m_LowerThreshold != value)
  {
    m_LowerThreshold = value;
    m_LowerThresholdIsSet = true;
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::SetUpperThreshold(double value)
{
  if (!m_UpperThresholdIsSet || m_UpperThreshold != value)
  {
    m_UpperThreshold = value;
    m_UpperThresholdIsSet = true;
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::SetLabels(const LabelsType & labels)
{
  if (m_Labels != labels)
  {
    m_Labels = labels;
    this->Modified();
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::UnsetObjectDefinition()
{
  m_IsoValue = 0.0;
  m_IsoValueIsSet = false;
  m_LowerThreshold = -std::numeric_limits<double>::infinity();
  m_LowerThresholdIsSet = false;
  m_UpperThreshold = std::numeric_limits<double>::infinity();
  m_UpperThresholdIsSet = false;
  m_Labels.clear();
  this->Modified();
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::GenerateOutputInformation()
{
  // Meshes have nothing to tell before they are made.
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::GenerateData()
{
  m_Statistics = DelaunayRefinementStatistics();
  m_Components.clear();
  m_Cavities.clear();
  m_LoweredSmoothings.clear();
  m_RegionLabels.clear();
  m_MissingLabels.clear();
  m_BoundaryOtherLabels = CellDataType::New();
  m_Warnings.clear();
  m_EffectiveDelta = 0.0;
  m_PreparationSeconds = 0.0;
  m_CopySeconds = 0.0;
  this->GetOutput()->Initialize();
  this->GetBoundaryOutput()->Initialize();
  if constexpr (ImageDimension == 3)
  {
    using Clock = std::chrono::steady_clock;
    const auto secondsSince = [](Clock::time_point start) {
      return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const auto             preparationStart = Clock::now();
    const InputImageType * image = this->GetInput();
    this->VerifyGeometry(image);
    const auto                rangeOfSizes = this->VerifySizeField();
    DelaunayRefinementThreads threads(this->ComputeNumberOfThreads());
    ObjectType                object;
    m_RegionLabels = this->ChooseObject(image, threads, object);
    this->VerifyLabels();
    this->ThrowIfAborted();

    ImageDelaunayRefinementOracle<InputImageType> oracle(image, object, m_Interpolator, &threads);
    this->ThrowIfAborted();
    this->VerifyObject(image, oracle);
    m_LoweredSmoothings = oracle.GetLoweredWidths();
    m_EffectiveDelta = m_DeltaIsSet                      ? m_Delta
                       : this->GetSizeField() != nullptr ? rangeOfSizes.greatest
                                                         : oracle.ComputeDefaultDelta();
    if (m_MinimumDelta > m_EffectiveDelta)
    {
      itkExceptionMacro("MinimumDelta is " << m_MinimumDelta << " mm; it must be no larger than Delta, which is "
                                           << m_EffectiveDelta << " mm");
    }
    double largestDelta = m_EffectiveDelta;
    for (const auto & labelDelta : m_LabelDeltas)
    {
      largestDelta = std::max(largestDelta, labelDelta.second);
    }
    m_Components = oracle.ComputeComponents(largestDelta);
    const std::vector<std::uint32_t> kept = this->LeaveOutNegligibleComponents(oracle);
    m_Cavities = oracle.FindCavities();
    if (m_PreserveTopology)
    {
      oracle.JoinDiagonalVoxels();
    }
    const DelaunayRefinementParameters parameters = this->MakeParameters(oracle, kept, rangeOfSizes.least);
    this->VerifyPrecision(oracle, parameters, rangeOfSizes.least);
    this->VerifyMemory(oracle, kept, parameters);
    m_PreparationSeconds = secondsSince(preparationStart);

    auto       engine = std::make_unique<DelaunayRefinementEngine>(oracle, parameters);
    const auto reason = engine->Run();
    m_Statistics = engine->GetStatistics();
    this->RenumberComponents(kept, parameters);
    this->ThrowUnlessCompleted(reason);
    const DelaunayRefinementResult result = engine->TakeResult();
    // The mesh goes where the triangulation was.
    engine.reset();
    if (result.tetrahedra.empty())
    {
      itkExceptionMacro("No tetrahedron has its center in the object, which is too thin for the image's spacing");
    }
    this->FindMissingLabels(result);
    this->WarnOfLabels();
    this->WarnOfComponents();
    this->WarnOfCavities();
    this->WarnOfSlivers();
    this->WarnOfSurface();
    this->ThrowIfStrict();
    this->WarnOfSmoothing();

    const auto copyStart = Clock::now();
    this->CopyResult(result, threads);
    // What was asked for is there: else every Update() would run again.
    this->GetOutput()->SetBufferedRegion(this->GetOutput()->GetRequestedRegion());
    this->GetBoundaryOutput()->SetBufferedRegion(this->GetBoundaryOutput()->GetRequestedRegion());
    m_CopySeconds = secondsSince(copyStart);
    this->UpdateProgress(1.0f);
  }
}

template <typename TInputImage, typename TOutputMesh>
bool
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::IsNegligible(
  std::uint32_t                           component,
  const DelaunayRefinementLatticeOracle & oracle) const
{
  return oracle.IsNegligible(m_Components[component], this->GetDeltaOf(m_Components[component]));
}

template <typename TInputImage, typename TOutputMesh>
std::vector<std::uint32_t>
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::LeaveOutNegligibleComponents(
  DelaunayRefinementLatticeOracle & oracle) const
{
  std::vector<std::uint32_t> withVolume;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < m_Components.size(); ++i)
  {
    if (oracle.HasVolume(m_Components[i]))
    {
      withVolume.push_back(i);
      // Small ones of several labels may have others around them, and leave no hole there. Bounds on distance
      // and topology hold for all.
      if (m_RegionLabels.size() > 1 || m_HausdorffBound > 0.0 || m_PreserveTopology || !this->IsNegligible(i, oracle))
      {
        kept.push_back(i);
      }
    }
  }
  if (withVolume.empty())
  {
    if (!m_IsoValueIsSet)
    {
      itkExceptionMacro(
        "There is no object to mesh: it has no volume once it is smoothed; set a smaller Smoothing than " << m_Smoothing
                                                                                                          << " mm");
    }
    itkExceptionMacro("There is no object to mesh: it has no volume, as no pixel value rises above IsoValue "
                      << m_IsoValue << " by much; set a lower IsoValue");
  }
  if (kept.empty())
  {
    // Small as they are, they are all there is.
    kept = withVolume;
  }
  if (kept.size() < m_Components.size())
  {
    std::vector<bool> isLeftOut(m_Components.size(), true);
    for (const std::uint32_t component : kept)
    {
      isLeftOut[component] = false;
    }
    oracle.RemoveComponents(isLeftOut);
  }
  return kept;
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::RenumberComponents(
  const std::vector<std::uint32_t> &   kept,
  const DelaunayRefinementParameters & parameters)
{
  std::vector<bool> isMissing(m_Components.size(), true);
  for (const std::uint32_t component : kept)
  {
    isMissing[component] = false;
  }
  for (const std::uint32_t number : m_Statistics.missingComponents)
  {
    isMissing[kept[number]] = true;
  }
  m_Statistics.missingComponents.clear();
  for (std::uint32_t i = 0; i < isMissing.size(); ++i)
  {
    if (isMissing[i])
    {
      m_Statistics.missingComponents.push_back(i);
    }
  }
  // The engine's own delta may be lower than the user's, too.
  std::vector<double> deltas = parameters.componentDelta;
  for (const auto & lowered : m_Statistics.loweredDeltas)
  {
    deltas[lowered.first] = lowered.second;
  }
  m_Statistics.loweredDeltas.clear();
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    if (deltas[i] < this->GetDeltaOf(m_Components[kept[i]]))
    {
      m_Statistics.loweredDeltas.emplace_back(kept[i], deltas[i]);
    }
  }
}

template <typename TInputImage, typename TOutputMesh>
double
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::GetDeltaOf(const DelaunayRefinementComponent & component) const
{
  const auto place = m_LabelDeltas.find(m_RegionLabels[component.region - 1]);
  return place != m_LabelDeltas.end() ? place->second : m_EffectiveDelta;
}

template <typename TInputImage, typename TOutputMesh>
unsigned int
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::ComputeNumberOfThreads()
{
  return std::min<unsigned int>(this->GetNumberOfWorkUnits(), this->GetMultiThreader()->GetMaximumNumberOfThreads());
}

template <typename TInputImage, typename TOutputMesh>
DelaunayRefinementParameters
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::MakeParameters(const DelaunayRefinementLatticeOracle & oracle,
                                                                       const std::vector<std::uint32_t> &      kept,
                                                                       double leastSize)
{
  DelaunayRefinementParameters parameters;
  parameters.radiusEdgeRatioBound = m_RadiusEdgeRatioBound;
  parameters.cellSize = m_CellSize;
  parameters.refineOutside = m_RefineOutside;
  parameters.manifold = m_Manifold;
  if (m_HausdorffBound > 0.0)
  {
    parameters.hausdorffBound = m_HausdorffBound;
  }
  const auto & spacing = this->GetInput()->GetSpacing();
  const double leastSpacing = *std::min_element(spacing.Begin(), spacing.End());
  if (m_PreserveTopology)
  {
    parameters.topologySize = 0.25 * leastSpacing;
  }
  if (m_MinimumDelta > 0.0)
  {
    parameters.leastDelta = m_MinimumDelta;
    // The steps of a mask's voxels are no bends.
    parameters.deviationShare = 0.15;
    parameters.leastDeviation = (m_IsoValueIsSet || m_Smoothing > 0.0 ? 0.25 : 1.0) * leastSpacing;
  }
  if (this->GetSizeField() != nullptr)
  {
    SetSizes(this->GetSizeField(), leastSize, parameters);
  }
  parameters.minimumDihedralAngle = m_MinimumDihedralAngle;
  parameters.paperSlivers = m_PaperSlivers;
  parameters.maximumNumberOfVertices = m_MaximumNumberOfVertices;
  parameters.numberOfThreads = this->ComputeNumberOfThreads();
  parameters.roundToFloat = sizeof(typename OutputMeshType::CoordRepType) < sizeof(double);
  parameters.progress = [this](double progress) {
    this->UpdateProgress(static_cast<float>(progress));
    return !this->GetAbortGenerateData();
  };
  const auto isNegligible = [&](std::uint32_t component) { return this->IsNegligible(component, oracle); };
  // If all are, they are all there is.
  const bool mayLeaveOut = !std::all_of(kept.begin(), kept.end(), isNegligible);
  for (const std::uint32_t component : kept)
  {
    const double delta = this->GetDeltaOf(m_Components[component]);
    const bool   isDispensable = mayLeaveOut && isNegligible(component);
    parameters.isDispensable.push_back(isDispensable);
    parameters.componentDelta.push_back(isDispensable && m_RegionLabels.size() > 1
                                          ? delta
                                          : oracle.ComputeComponentDelta(m_Components[component], delta));
  }
  // No component needs more; a box that is far too large for the object would cost precision.
  parameters.delta = *std::max_element(parameters.componentDelta.begin(), parameters.componentDelta.end());
  return parameters;
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::SetSizes(const SizeFieldType *          field,
                                                                 double                         leastSize,
                                                                 DelaunayRefinementParameters & parameters)
{
  // What is interpolated is no less than the least of the pixels around.
  const auto toIndex = field->GetInverseDirection();
  parameters.sizeField = [field, toIndex](const DelaunayRefinementPoint & point, double reach) {
    const auto center = field->template TransformPhysicalPointToContinuousIndex<double>(Point<double, 3>(point.data()));
    const auto &                      region = field->GetBufferedRegion();
    typename SizeFieldType::IndexType first;
    typename SizeFieldType::IndexType last;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double extent =
        reach / field->GetSpacing()[i] * (std::abs(toIndex[i][0]) + std::abs(toIndex[i][1]) + std::abs(toIndex[i][2]));
      const double low = static_cast<double>(region.GetIndex(i));
      const double high = low + static_cast<double>(region.GetSize(i)) - 1.0;
      if (!(center[i] + extent >= low - 0.5 && center[i] - extent <= high + 0.5))
      {
        return std::numeric_limits<double>::infinity();
      }
      first[i] = static_cast<IndexValueType>(std::clamp(std::floor(center[i] - extent), low, high));
      last[i] = static_cast<IndexValueType>(std::clamp(std::ceil(center[i] + extent), low, high));
    }
    double least = std::numeric_limits<double>::infinity();
    for (auto index = first; index[2] <= last[2]; ++index[2])
    {
      for (index[1] = first[1]; index[1] <= last[1]; ++index[1])
      {
        for (index[0] = first[0]; index[0] <= last[0]; ++index[0])
        {
          least = std::min<double>(least, field->GetPixel(index));
        }
      }
    }
    return least;
  };
  const auto & spacing = field->GetSpacing();
  parameters.sizeFieldStep = std::max(*std::min_element(spacing.Begin(), spacing.End()), 0.5 * leastSize);
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::CopyResult(const DelaunayRefinementResult & result,
                                                                   DelaunayRefinementThreads &      threads)
{
  try
  {
    CopyPoints(
      result.points, result.points.size(), [](std::uint32_t point) { return point; }, threads, this->GetOutput());
    this->CopyCells<TetrahedronCell<typename OutputMeshType::CellType>>(
      result.tetrahedra,
      [&result](std::size_t cell) { return result.regions[cell]; },
      [](std::uint32_t point) { return point; },
      threads,
      this->GetOutput());

    // The boundary's own points, numbered as they come.
    const DelaunayRefinementFirstUses uses(
      result.boundaryTriangles.front().data(), 3 * result.boundaryTriangles.size(), result.points.size(), &threads);
    const auto numberOf = [&uses](std::uint32_t point) { return uses.GetNumber(point); };
    CopyPoints(result.points, uses.GetNumberOfUsed(), numberOf, threads, this->GetBoundaryOutput());
    this->CopyCells<TriangleCell<typename OutputMeshType::CellType>>(
      result.boundaryTriangles,
      [&result](std::size_t cell) { return result.boundaryRegions[cell][0]; },
      numberOf,
      threads,
      this->GetBoundaryOutput());
    m_BoundaryOtherLabels->Reserve(static_cast<IdentifierType>(result.boundaryRegions.size()));
    std::transform(result.boundaryRegions.begin(),
                   result.boundaryRegions.end(),
                   m_BoundaryOtherLabels->CastToSTLContainer().begin(),
                   [this](const std::array<std::uint32_t, 2> & regions) {
                     return ToCellData(regions[1] == 0 ? InputPixelType{ 0 } : m_RegionLabels[regions[1] - 1]);
                   });
  }
  catch (...)
  {
    // Half a mesh is none.
    this->GetOutput()->Initialize();
    this->GetBoundaryOutput()->Initialize();
    m_BoundaryOtherLabels = CellDataType::New();
    throw;
  }
}

template <typename TInputImage, typename TOutputMesh>
template <typename TNumbering>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::CopyPoints(
  const DelaunayRefinementArray<DelaunayRefinementPoint> & from,
  std::size_t                                              number,
  const TNumbering &                                       numberOf,
  DelaunayRefinementThreads &                              threads,
  OutputMeshType *                                         to)
{
  auto container = OutputMeshType::PointsContainer::New();
  container->Reserve(static_cast<IdentifierType>(number));
  auto &                points = container->CastToSTLContainer();
  constexpr std::size_t length = 8192;
  DelaunayRefinementThreads::RunPieces(
    &threads, from.size(), length, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::uint32_t at = numberOf(static_cast<std::uint32_t>(i));
        if (at != DelaunayRefinementFirstUses::None)
        {
          for (unsigned int j = 0; j < 3; ++j)
          {
            points[at][j] = static_cast<typename OutputMeshType::CoordRepType>(from[i][j]);
          }
        }
      }
    });
  to->SetPoints(container);
}

template <typename TInputImage, typename TOutputMesh>
template <typename TCell, typename TCellPoints, typename TRegionOf, typename TNumbering>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::CopyCells(const DelaunayRefinementArray<TCellPoints> & from,
                                                                  const TRegionOf &                            regionOf,
                                                                  const TNumbering &                           numberOf,
                                                                  DelaunayRefinementThreads &                  threads,
                                                                  OutputMeshType *                             to)
{
  // The mesh owns the cells, null or not, from the start: nothing is lost or deleted twice.
  to->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  const auto cells = DelaunayRefinementCellsContainer<OutputMeshType>::New();
  cells->template Allocate<TCell>(from.size());
  to->SetCells(cells);
  to->SetCellData(OutputMeshType::CellDataContainer::New());
  to->GetCellData()->Reserve(static_cast<IdentifierType>(from.size()));
  auto & data = to->GetCellData()->CastToSTLContainer();

  constexpr std::size_t length = 8192;
  std::atomic<bool>     isAborted{ false };
  threads.Run(DelaunayRefinementThreads::CountPieces(from.size(), length), [&](std::size_t piece, unsigned int thread) {
    if (thread == 0 && this->GetAbortGenerateData())
    {
      isAborted.store(true, std::memory_order_relaxed);
    }
    const std::size_t end = std::min(from.size(), (piece + 1) * length);
    for (std::size_t i = piece * length; i < end && !isAborted.load(std::memory_order_relaxed); ++i)
    {
      TCell * const cell = cells->template MakeCell<TCell>(i);
      data[i] = ToCellData(m_RegionLabels[regionOf(i) - 1]);
      for (unsigned int j = 0; j < from[i].size(); ++j)
      {
        cell->SetPointId(static_cast<int>(j), static_cast<IdentifierType>(numberOf(from[i][j])));
      }
    }
  });
  if (isAborted)
  {
    this->ThrowUnlessCompleted(DelaunayRefinementEnums::TerminationReason::STOPPED_BY_CALLER);
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  using PrintType = typename NumericTraits<InputPixelType>::PrintType;
  const auto onOff = [](bool value) { return value ? "On" : "Off"; };
  os << indent << "Delta: " << m_Delta << '\n';
  os << indent << "DeltaIsSet: " << onOff(m_DeltaIsSet) << '\n';
  os << indent << "LabelDeltas:";
  for (const auto & labelDelta : m_LabelDeltas)
  {
    os << ' ' << static_cast<PrintType>(labelDelta.first) << ": " << labelDelta.second;
  }
  os << '\n';
  os << indent << "RadiusEdgeRatioBound: " << m_RadiusEdgeRatioBound << '\n';
  os << indent << "CellSize: " << m_CellSize << '\n';
  os << indent << "MinimumDihedralAngle: " << m_MinimumDihedralAngle << '\n';
  os << indent << "PaperSlivers: " << onOff(m_PaperSlivers) << '\n';
  os << indent << "RefineOutside: " << onOff(m_RefineOutside) << '\n';
  os << indent << "Manifold: " << onOff(m_Manifold) << '\n';
  os << indent << "HausdorffBound: " << m_HausdorffBound << '\n';
  os << indent << "PreserveTopology: " << onOff(m_PreserveTopology) << '\n';
  os << indent << "MinimumDelta: " << m_MinimumDelta << '\n';
  os << indent << "MaximumNumberOfVertices: " << m_MaximumNumberOfVertices << '\n';
  os << indent << "IsoValue: " << m_IsoValue << '\n';
  os << indent << "IsoValueIsSet: " << onOff(m_IsoValueIsSet) << '\n';
  os << indent << "LowerThreshold: " << m_LowerThreshold << '\n';
  os << indent << "LowerThresholdIsSet: " << onOff(m_LowerThresholdIsSet) << '\n';
  os << indent << "UpperThreshold: " << m_UpperThreshold << '\n';
  os << indent << "UpperThresholdIsSet: " << onOff(m_UpperThresholdIsSet) << '\n';
  const auto printLabels = [&](const char * name, const LabelsType & labels) {
    os << indent << name << ':';
    for (const InputPixelType label : labels)
    {
      os << ' ' << static_cast<PrintType>(label);
    }
    os << '\n';
  };
  printLabels("Labels", m_Labels);
  os << indent << "MergeLabels: " << onOff(m_MergeLabels) << '\n';
  os << indent << "LargestComponentOnly: " << onOff(m_LargestComponentOnly) << '\n';
  os << indent << "Smoothing: " << m_Smoothing << '\n';
  os << indent << "MinimumComponentSize: " << m_MinimumComponentSize << '\n';
  os << indent << "Strict: " << onOff(m_Strict) << '\n';
  itkPrintSelfObjectMacro(Interpolator);
  os << indent << "EffectiveDelta: " << m_EffectiveDelta << '\n';
  os << indent << "Statistics: " << m_Statistics << '\n';
  os << indent << "Components: " << m_Components.size() << '\n';
  os << indent << "Cavities: " << m_Cavities.size() << '\n';
  os << indent << "LoweredSmoothings: " << m_LoweredSmoothings.size() << '\n';
  printLabels("RegionLabels", m_RegionLabels);
  printLabels("MissingLabels", m_MissingLabels);
  os << indent << "BoundaryOtherLabels: " << m_BoundaryOtherLabels->Size() << '\n';
  os << indent << "Warnings:\n";
  for (const std::string & warning : m_Warnings)
  {
    os << indent.GetNextIndent() << warning << '\n';
  }
  os << indent << "PreparationSeconds: " << m_PreparationSeconds << '\n';
  os << indent << "CopySeconds: " << m_CopySeconds << '\n';
}
} // end namespace itk

#include "itkDelaunayRefinementMeshFilterChecks.hxx"
#include "itkDelaunayRefinementMeshFilterWarnings.hxx"

#endif
