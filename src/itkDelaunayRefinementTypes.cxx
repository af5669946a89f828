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
#include "itkDelaunayRefinementTypes.h"

namespace itk
{
std::ostream &
operator<<(std::ostream & out, const DelaunayRefinementTopology & topology)
{
  if (!topology.isKnown)
  {
    return out << "not counted";
  }
  return out << topology.components << " components, " << topology.cavities << " cavities, genus "
             << topology.GetGenus();
}

std::ostream &
operator<<(std::ostream & out, const DelaunayRefinementStatistics & statistics)
{
  out << statistics.terminationReason << "; insertions";
  for (unsigned int i = 0; i < statistics.insertions.size(); ++i)
  {
    out << ' ' << static_cast<DelaunayRefinementEnums::RefinementRule>(i) << ' ' << statistics.insertions[i];
  }
  out << "; seeds " << statistics.seeds << "; encroachments";
  for (unsigned int i = 1; i < statistics.encroachments.size(); ++i)
  {
    out << ' ' << static_cast<DelaunayRefinementEnums::EncroachmentCase>(i) << ' ' << statistics.encroachments[i];
  }
  out << "; removals " << statistics.removals << ", by encroachment " << statistics.encroachmentRemovals
      << "; vertices";
  for (unsigned int i = 0; i < statistics.vertices.size(); ++i)
  {
    out << ' ' << static_cast<DelaunayRefinementEnums::VertexKind>(i) << ' ' << statistics.vertices[i];
  }
  return out << "; seconds of sampling " << statistics.samplingSeconds << ", of insertion "
             << statistics.insertionSeconds << ", of refinement " << statistics.refinementSeconds << ", of extraction "
             << statistics.extractionSeconds << "; missing components " << statistics.missingComponents.size()
             << "; missing cavities " << statistics.missingCavities.size() << "; lowered deltas "
             << statistics.loweredDeltas.size() << "; changed tetrahedra " << statistics.changedTetrahedra
             << "; moved vertices " << statistics.movedVertices << ", slivers left " << statistics.slivers.size()
             << ", seconds against slivers " << statistics.sliverSeconds << "; non-manifold vertices "
             << statistics.nonManifoldVertices << "; mesh to surface " << statistics.meshToSurface.distance
             << ", surface to mesh " << statistics.surfaceToMesh.distance << "; topology of the image "
             << statistics.imageTopology << ", of the mesh " << statistics.meshTopology;
}
} // end namespace itk
