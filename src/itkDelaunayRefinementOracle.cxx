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
#include "itkDelaunayRefinementOracle.h"

namespace itk
{
DelaunayRefinementOracle::~DelaunayRefinementOracle() = default;

bool
DelaunayRefinementOracle::IsSurfaceWithin(const PointType & point, double distance) const
{
  PointType closest;
  return this->FindClosestSurfacePoint(point, distance, closest);
}

DelaunayRefinementOracle::SurfacePatches
DelaunayRefinementOracle::GetJunctionPatches(unsigned int) const
{
  return SurfacePatches();
}

bool
DelaunayRefinementOracle::FindJunctionInPatch(const SurfacePatchIdentifier &, unsigned int, PointType &) const
{
  return false;
}

std::vector<DelaunayRefinementOracle::ComponentType>
DelaunayRefinementOracle::FindComponentsAt(const PointType & point) const
{
  return { this->FindComponent(point) };
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementOracle::GetComponentBounds(ComponentType) const
{
  return this->GetSurfaceBounds();
}
} // end namespace itk
