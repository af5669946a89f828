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
#include "itkDelaunayRefinementJunctionSample.h"

#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementPointGrid.h"

#include <algorithm>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using PatchesType = DelaunayRefinementSurfacePatches;

/** Vertices are at least this share of delta apart, and gaps in a line less than twice as long: R1's own vertices, a
 * whole delta away from both ends of a gap, come no nearer to its middle than half of delta. */
constexpr double Separation = 0.8;

/** Patches larger than this share of the separation are split. */
constexpr double LargestPatch = 0.5;

constexpr std::size_t PatchesBetweenQuestions = 4096;
} // namespace

std::vector<DelaunayRefinementPoint>
SampleDelaunayRefinementJunctions(const DelaunayRefinementOracle &     oracle,
                                  const DelaunayRefinementLocalDelta & localDelta,
                                  bool                                 roundToFloat,
                                  const std::function<bool()> &        keepGoing)
{
  auto patches = oracle.GetJunctionPatches();
  if (patches.ends.GetSize() == 0 && patches.lines.GetSize() == 0)
  {
    return {};
  }
  const auto                  bounds = oracle.GetSurfaceBounds();
  DelaunayRefinementPointGrid vertices(bounds.minimum, bounds.maximum, localDelta.GetMaximum());
  PatchesType                 parts(bounds.minimum);
  std::size_t                 numberOfVisits = 0;

  // The ends of lines first: gaps there would leave them loose.
  for (const unsigned int leastRegions : { 4u, 3u })
  {
    PatchesType & wholes = leastRegions == 4 ? patches.ends : patches.lines;
    while (wholes.GetSize() > 0)
    {
      parts.Clear(bounds.minimum);
      for (std::size_t i = 0; i < wholes.GetSize(); ++i)
      {
        if (++numberOfVisits % PatchesBetweenQuestions == 0 && !keepGoing())
        {
          return vertices.GetPoints();
        }
        const auto   patch = wholes.Get(i);
        const double least = Separation * localDelta.GetRange(patch).least;
        if (patch.radius < least && vertices.HasPointWithin(patch.center, least - patch.radius))
        {
          continue;
        }
        if (patch.radius > LargestPatch * least)
        {
          oracle.SplitJunctionPatch(patch.identifier, leastRegions, parts);
          continue;
        }
        DelaunayRefinementPoint point;
        if (oracle.FindJunctionInPatch(patch.identifier, leastRegions, point) &&
            !vertices.HasPointWithin(point, Separation * localDelta.GetAt(point)))
        {
          if (roundToFloat)
          {
            point = Geometry::RoundPointToFloat(point);
          }
          vertices.Add(point);
        }
      }
      std::swap(wholes, parts);
    }
  }
  return vertices.GetPoints();
}
} // end namespace itk
