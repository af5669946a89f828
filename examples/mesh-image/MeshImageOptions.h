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
#ifndef MeshImageOptions_h
#define MeshImageOptions_h

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace meshimage
{
enum class Interpolator
{
  Linear,
  Nearest,
  BSpline
};

/** The command line. What is not set is left to the filter's own defaults. */
struct Options
{
  std::string image;
  std::string output;

  std::optional<double>      isoValue;
  std::optional<double>      lowerThreshold;
  std::optional<double>      upperThreshold;
  std::vector<std::uint64_t> labels;
  bool                       mergeLabels{ false };

  std::optional<double> delta;
  std::optional<double> cellSize;

  /** Labels with a delta of their own. */
  std::vector<std::pair<std::uint64_t, double>> labelDeltas;
  std::optional<double>                         radiusEdgeBound;
  std::optional<double>                         minimumDihedralAngle;
  bool                                          paperSlivers{ false };
  bool                                          refineOutside{ false };
  bool                                          allowNonManifold{ false };
  std::optional<double>                         hausdorffBound;
  bool                                          topology{ false };
  std::optional<double>                         minimumDelta;
  std::string                                   sizeField;
  std::optional<std::uint64_t>                  maximumNumberOfVertices;

  bool                         largestComponent{ false };
  std::optional<std::uint64_t> minimumComponentSize;
  bool                         strict{ false };

  std::optional<double> smoothing;

  Interpolator  interpolator{ Interpolator::Linear };
  std::string   surface;
  std::string   report;
  std::uint64_t threads{ std::max(1u, std::thread::hardware_concurrency()) };
  bool          quiet{ false };
};

/** \class UsageError
 * \brief The command line cannot be used; the sentence names the option. */
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** Reads the command line; nothing if it only asked for the help or the version, which are then printed. */
std::optional<Options>
ParseOptions(int argc, char * argv[]);
} // namespace meshimage

#endif
