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
#ifndef itkDelaunayRefinementComponent_h
#define itkDelaunayRefinementComponent_h

#include "itkDelaunayRefinementTypes.h"

namespace itk
{
/** \class DelaunayRefinementComponent
 * \brief An 18-connected component of the object's voxels, or of those of one of its regions.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementComponent
{
  /** Number of voxels. */
  std::size_t numberOfVoxels{ 0 };

  /** The region that it is a part of. */
  DelaunayRefinementRegion region{ 1 };

  /** Volume of its voxels, in physical units (mm^3). */
  double volume{ 0.0 };

  /** Physical position of the center of its first voxel. */
  DelaunayRefinementPoint firstVoxel{};

  /** Radius of a large ball within the component, in physical units (mm). */
  double inscribedRadius{ 0.0 };
};

/** \class DelaunayRefinementCavity
 * \brief Voxels outside the object that share faces, all surrounded by it.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementCavity
{
  /** Number of voxels. */
  std::size_t numberOfVoxels{ 0 };

  /** Volume of its voxels, in physical units (mm^3). */
  double volume{ 0.0 };

  /** Physical position of the center of its first voxel. */
  DelaunayRefinementPoint firstVoxel{};
};
} // end namespace itk

#endif
