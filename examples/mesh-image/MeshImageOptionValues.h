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
#ifndef MeshImageOptionValues_h
#define MeshImageOptionValues_h

#include "MeshImageOptions.h"

namespace meshimage
{
/** Each takes the name of an option and the text that was given for it, and throws a UsageError if that is no such
 * value or out of range. */
double
ParseFinite(const std::string & name, const std::string & text);
double
ParsePositive(const std::string & name, const std::string & text);
double
ParseRadiusEdgeBound(const std::string & name, const std::string & text);
double
ParseDihedralAngle(const std::string & name, const std::string & text);
double
ParseSmoothing(const std::string & name, const std::string & text);
std::uint64_t
ParseCount(const std::string & name, const std::string & text);
std::vector<std::uint64_t>
ParseLabels(const std::string & name, const std::string & text);
std::pair<std::uint64_t, double>
ParseLabelDelta(const std::string & name, const std::string & text);
void
ParseThreshold(const std::string & name, const std::string & text, Options & options);
Interpolator
ParseInterpolator(const std::string & name, const std::string & text);
std::string
ParseOutputName(const std::string & name, const std::string & text);
std::string
ParseSurfaceName(const std::string & name, const std::string & text);

/** Two outputs in one file, or an output in place of the image, are bad usage. */
void
RejectSharedNames(const Options & options);
} // namespace meshimage

#endif
