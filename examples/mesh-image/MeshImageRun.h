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
#ifndef MeshImageRun_h
#define MeshImageRun_h

#include "MeshImageOptions.h"
#include "MeshImageTypes.h"

#include "itkDelaunayRefinementComponent.h"
#include "itkDelaunayRefinementTypes.h"
#include "itkImageIOBase.h"

#include <functional>
#include <string>
#include <vector>

namespace meshimage
{
/** What a run of the filter made and what it tells about itself. */
struct Run
{
  MeshType::Pointer mesh;
  MeshType::Pointer boundary;

  double                                                           delta{ 0.0 };
  itk::DelaunayRefinementStatistics                                statistics;
  std::vector<itk::DelaunayRefinementComponent>                    components;
  std::vector<itk::DelaunayRefinementCavity>                       cavities;
  std::vector<std::uint64_t>                                       labels;
  std::vector<std::pair<itk::DelaunayRefinementComponent, double>> loweredSmoothings;
  std::vector<std::uint64_t>                                       missingLabels;
  std::vector<std::string>                                         warnings;

  double readingSeconds{ 0.0 };
  double filterSeconds{ 0.0 };
  double preparationSeconds{ 0.0 };
  double copySeconds{ 0.0 };
};

/** Takes the name of what is being done and its share done, in [0, 1]. */
using ProgressFunction = std::function<void(const char *, double)>;

/** Reads the image that \c io has opened, in the pixel type of the file, and meshes it. */
Run
RunFilter(const Options & options, itk::ImageIOBase * io, const ProgressFunction & progress);

/** RunFilter for one pixel type; instantiated in several files, as each takes a while to compile. */
template <typename TPixel>
Run
RunFilterOnPixels(const Options & options, itk::ImageIOBase * io, const ProgressFunction & progress);
} // namespace meshimage

#endif
