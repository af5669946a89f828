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
#include "MeshImageReport.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace meshimage
{
namespace
{
void
PrintHistogram(std::ostream & out, const Quality & quality)
{
  constexpr std::size_t width = 50;
  const auto &          counts = quality.dihedralAngleHistogram;
  const std::size_t     largest = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    // A bin that is not empty shows.
    const std::size_t length = (counts[i] * width + largest - 1) / largest;
    out << std::setw(7) << i * Quality::binWidth << " to " << std::setw(3) << (i + 1) * Quality::binWidth << " "
        << std::setw(10) << counts[i] << " " << std::string(length, '#') << "\n";
  }
}
} // namespace

void
PrintReport(std::ostream & out, const Report & report)
{
  const Run &     run = report.run;
  const Quality & quality = report.quality;
  const auto &    statistics = run.statistics;

  std::ostringstream text;
  text << report.options.output << ": " << run.mesh->GetNumberOfCells() << " tetrahedra, "
       << run.mesh->GetNumberOfPoints() << " points, " << run.boundary->GetNumberOfCells() << " boundary triangles\n"
       << "delta " << run.delta << " mm" << (report.options.delta ? "" : " (chosen from the image)") << "; components "
       << run.components.size() << ", not in the mesh " << statistics.missingComponents.size() << "; cavities "
       << run.cavities.size() << ", not in the mesh " << statistics.missingCavities.size() << "\n";
  if (statistics.meshTopology.isKnown)
  {
    text << "topology of the mesh: " << statistics.meshTopology << "; in the image: " << statistics.imageTopology
         << "\n";
  }
  if (statistics.meshToSurface.distance >= 0.0)
  {
    text << "from the mesh to the surface at most " << statistics.meshToSurface.distance
         << " mm, from there to the mesh " << statistics.surfaceToMesh.distance << " mm\n";
  }

  text << std::fixed << std::setprecision(3) << "seconds: reading " << run.readingSeconds << ", preparation "
       << run.preparationSeconds << ", sampling " << statistics.samplingSeconds << ", insertion "
       << statistics.insertionSeconds << ", refinement " << statistics.refinementSeconds << ", extraction "
       << statistics.extractionSeconds << ", copy " << run.copySeconds << ", measuring " << report.measuringSeconds
       << ", writing " << report.writingSeconds << "\n"
       << "image to mesh: " << run.filterSeconds << " s\n";

  text << "radius-edge ratio at most " << quality.radiusEdgeRatioMaximum << "; edges from " << quality.edgeMinimum
       << " to " << quality.edgeMaximum << " mm\n"
       << std::setprecision(2) << "boundary angles from " << quality.boundaryAngleMinimum
       << " degrees; dihedral angles from " << quality.dihedralAngleMinimum << " to " << quality.dihedralAngleMaximum
       << " degrees:\n"
       << std::setprecision(0);
  PrintHistogram(text, quality);
  out << text.str() << std::flush;
}
} // namespace meshimage
