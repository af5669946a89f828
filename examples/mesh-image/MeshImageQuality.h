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
#ifndef MeshImageQuality_h
#define MeshImageQuality_h

#include "MeshImageTypes.h"

#include <array>
#include <cstddef>

namespace meshimage
{
/** Shape of tetrahedra and boundary triangles, measured on the mesh as it is stored. Angles in degrees. */
struct Quality
{
  static constexpr std::size_t numberOfBins = 18;
  static constexpr double      binWidth = 180.0 / numberOfBins;

  double radiusEdgeRatioMaximum{ 0.0 };
  double dihedralAngleMinimum{ 180.0 };
  double dihedralAngleMaximum{ 0.0 };
  double boundaryAngleMinimum{ 180.0 };
  double edgeMinimum{ 0.0 };
  double edgeMaximum{ 0.0 };

  /** How many dihedral angles are from i to i + 1 times \c binWidth. */
  std::array<std::size_t, numberOfBins> dihedralAngleHistogram{};
};

Quality
MeasureQuality(const MeshType & mesh, const MeshType & boundary);
} // namespace meshimage

#endif
