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
#ifndef MeshImageRun_hxx
#define MeshImageRun_hxx

#include "MeshImageMessages.h"
#include "MeshImageReading.h"
#include "MeshImageRun.h"
#include "MeshImageStopwatch.h"

#include "itkBSplineInterpolateImageFunction.h"
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkNearestNeighborInterpolateImageFunction.h"

#include <limits>
#include <type_traits>

namespace meshimage
{
/** A label that an option names. */
template <typename TPixel>
TPixel
ToPixel(std::uint64_t label, const std::string & option, const Options & options)
{
  if constexpr (std::is_integral_v<TPixel>)
  {
    if (label > static_cast<std::uint64_t>(std::numeric_limits<TPixel>::max()))
    {
      throw RunError("There is no label " + std::to_string(label) + " in " + options.image +
                     ", whose pixel type ends at " + std::to_string(std::numeric_limits<TPixel>::max()) +
                     ": choose other labels for " + option);
    }
  }
  return static_cast<TPixel>(label);
}

template <typename TFilter>
void
SetObject(TFilter & filter, const Options & options)
{
  if (options.isoValue)
  {
    filter.SetIsoValue(*options.isoValue);
  }
  if (options.lowerThreshold)
  {
    filter.SetLowerThreshold(*options.lowerThreshold);
  }
  if (options.upperThreshold)
  {
    filter.SetUpperThreshold(*options.upperThreshold);
  }
  if (!options.labels.empty())
  {
    typename TFilter::LabelsType labels;
    for (const std::uint64_t label : options.labels)
    {
      labels.push_back(ToPixel<typename TFilter::InputPixelType>(label, "--labels", options));
    }
    filter.SetLabels(labels);
  }
  filter.SetMergeLabels(options.mergeLabels);
  filter.SetLargestComponentOnly(options.largestComponent);
  if (options.minimumComponentSize)
  {
    filter.SetMinimumComponentSize(*options.minimumComponentSize);
  }
  filter.SetStrict(options.strict);
}

template <typename TFilter>
void
SetSizes(TFilter & filter, const Options & options)
{
  if (options.delta)
  {
    filter.SetDelta(*options.delta);
  }
  for (const auto & [label, delta] : options.labelDeltas)
  {
    filter.SetLabelDelta(ToPixel<typename TFilter::InputPixelType>(label, "--delta-for", options), delta);
  }
  if (options.cellSize)
  {
    filter.SetCellSize(*options.cellSize);
  }
  if (options.radiusEdgeBound)
  {
    filter.SetRadiusEdgeRatioBound(*options.radiusEdgeBound);
  }
  if (options.minimumDihedralAngle)
  {
    filter.SetMinimumDihedralAngle(*options.minimumDihedralAngle);
  }
  filter.SetPaperSlivers(options.paperSlivers);
  filter.SetRefineOutside(options.refineOutside);
  filter.SetManifold(!options.allowNonManifold);
  if (options.hausdorffBound)
  {
    filter.SetHausdorffBound(*options.hausdorffBound);
  }
  filter.SetPreserveTopology(options.topology);
  if (options.minimumDelta)
  {
    filter.SetMinimumDelta(*options.minimumDelta);
  }
  if (options.maximumNumberOfVertices)
  {
    filter.SetMaximumNumberOfVertices(*options.maximumNumberOfVertices);
  }
}

template <typename TFilter>
void
SetInterpolator(TFilter & filter, Interpolator interpolator)
{
  using ImageType = typename TFilter::InputImageType;
  switch (interpolator)
  {
    case Interpolator::Linear:
      // The filter's default.
      break;
    case Interpolator::Nearest:
      filter.SetInterpolator(itk::NearestNeighborInterpolateImageFunction<ImageType, double>::New());
      break;
    case Interpolator::BSpline:
      filter.SetInterpolator(itk::BSplineInterpolateImageFunction<ImageType, double>::New());
      break;
  }
}

template <typename TPixel>
Run
RunFilterOnPixels(const Options & options, itk::ImageIOBase * io, const ProgressFunction & progress)
{
  using ImageType = itk::Image<TPixel, 3>;
  using FilterType = itk::DelaunayRefinementMeshFilter<ImageType, MeshType>;

  Run             run;
  const Stopwatch reading;
  progress("Reading", 0.0);
  const auto filter = FilterType::New();
  filter->SetInput(ReadImage<ImageType>(options.image, io));
  if (!options.sizeField.empty())
  {
    filter->SetSizeField(ReadSizeField(options.sizeField));
  }
  run.readingSeconds = reading.GetSeconds();

  SetObject(*filter, options);
  SetSizes(*filter, options);
  SetInterpolator(*filter, options.interpolator);
  filter->SetSmoothing(options.smoothing.value_or(0.0));
  filter->SetNumberOfWorkUnits(static_cast<itk::ThreadIdType>(options.threads));
  filter->AddObserver(itk::ProgressEvent(),
                      [&progress, &filter](const itk::EventObject &) { progress("Meshing", filter->GetProgress()); });

  const Stopwatch meshing;
  try
  {
    filter->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    throw RunError(InWordsOfOptions(PlainMessage(error)));
  }
  run.filterSeconds = meshing.GetSeconds();

  run.mesh = filter->GetOutput();
  run.boundary = filter->GetBoundaryOutput();
  run.mesh->DisconnectPipeline();
  run.boundary->DisconnectPipeline();
  run.delta = filter->GetEffectiveDelta();
  run.statistics = filter->GetStatistics();
  run.components = filter->GetComponents();
  run.cavities = filter->GetCavities();
  run.loweredSmoothings = filter->GetLoweredSmoothings();
  run.labels.assign(filter->GetRegionLabels().begin(), filter->GetRegionLabels().end());
  run.missingLabels.assign(filter->GetMissingLabels().begin(), filter->GetMissingLabels().end());
  for (const std::string & warning : filter->GetWarnings())
  {
    run.warnings.push_back(InWordsOfOptions(warning));
  }
  run.preparationSeconds = filter->GetPreparationSeconds();
  run.copySeconds = filter->GetCopySeconds();
  return run;
}
} // namespace meshimage

#endif
