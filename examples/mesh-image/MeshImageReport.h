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
#ifndef MeshImageReport_h
#define MeshImageReport_h

#include "MeshImageQuality.h"
#include "MeshImageRun.h"

#include <iosfwd>

namespace meshimage
{
/** All that is known at the end of a run. */
struct Report
{
  const Options & options;
  const Run &     run;
  const Quality & quality;
  double          measuringSeconds;
  double          writingSeconds;
};

/** For people: sizes, seconds, angles, a histogram. */
void
PrintReport(std::ostream & out, const Report & report);

/** For programs: JSON. Throws a RunError if the file cannot be written. */
void
WriteReport(const std::string & fileName, const Report & report);
} // namespace meshimage

#endif
