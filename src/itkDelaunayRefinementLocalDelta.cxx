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
#include "itkDelaunayRefinementLocalDelta.h"

#include <algorithm>

namespace itk
{
namespace
{
/** Steps of space in which delta is lowered: over the bound on the distance, and over the least deltas. */
constexpr double BoundResolution = 0.5;
constexpr double DeltaResolution = 1.0;
constexpr double TopologyResolution = 2.0;
} // namespace

DelaunayRefinementLocalDelta::DelaunayRefinementLocalDelta(const DelaunayRefinementOracle &     oracle,
                                                           const DelaunayRefinementParameters & parameters)
  : m_Oracle(oracle)
  , m_Bounds(oracle.GetSurfaceBounds())
  , m_Delta(parameters.delta)
  , m_Minimum(parameters.delta)
  , m_DeltaOfComponents(oracle.GetNumberOfComponents(), parameters.delta)
  , m_Resolution(std::min({ BoundResolution * parameters.hausdorffBound,
                            DeltaResolution * parameters.leastDelta,
                            TopologyResolution * parameters.topologySize }))
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_BoxesPerLength[i] = BoxesPerAxis / (m_Bounds.maximum[i] - m_Bounds.minimum[i]);
  }
  for (std::size_t i = 0; i < parameters.componentDelta.size(); ++i)
  {
    this->Lower(static_cast<ComponentType>(i), parameters.componentDelta[i]);
  }
  if (parameters.sizeField)
  {
    m_Field.Start(m_Bounds, std::min(parameters.sizeFieldStep, m_Resolution), m_Delta);
    m_Minimum = std::min(m_Minimum, m_Field.Lower(parameters.sizeField));
    m_Field.Grade();
  }
}

DelaunayRefinementLocalDelta::BoxIndexType
DelaunayRefinementLocalDelta::FindBox(const PointType & point, double offset) const
{
  BoxIndexType box;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double index = (point[i] + offset - m_Bounds.minimum[i]) * m_BoxesPerLength[i];
    box[i] = static_cast<std::int32_t>(std::clamp(index, 0.0, BoxesPerAxis - 1.0));
  }
  return box;
}

bool
DelaunayRefinementLocalDelta::MayBeLoweredWithin(const PointType & point, double radius) const
{
  if (m_MayBeLowered.empty())
  {
    return false;
  }
  const BoxIndexType first = this->FindBox(point, -radius);
  const BoxIndexType last = this->FindBox(point, radius);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        if (m_MayBeLowered[ToOffset(x, y, z)])
        {
          return true;
        }
      }
    }
  }
  return false;
}

double
DelaunayRefinementLocalDelta::GetAt(const PointType & point) const
{
  const double own = this->MayBeLoweredWithin(point, 0.0) ? m_Oracle.FindLeastAt(point, m_DeltaOfComponents) : m_Delta;
  return m_Field.IsStarted() ? std::min(own, m_Field.GetAt(point)) : own;
}

DelaunayRefinementLocalDelta::RangeType
DelaunayRefinementLocalDelta::GetRange(const PatchType & patch) const
{
  RangeType range = this->MayBeLoweredWithin(patch.center, patch.radius)
                      ? m_Oracle.FindLeastInPatch(patch, m_DeltaOfComponents)
                      : RangeType{ m_Delta, m_Delta };
  if (m_Field.IsStarted())
  {
    const RangeType field = m_Field.GetRange(patch.center, patch.radius);
    range = { std::min(range.least, field.least), std::min(range.greatest, field.greatest) };
  }
  return range;
}

void
DelaunayRefinementLocalDelta::LowerAround(const PointType & point, double radius, double delta)
{
  if (!m_Field.IsStarted())
  {
    m_Field.Start(m_Bounds, m_Resolution, m_Delta);
    m_Field.Settle();
  }
  m_Field.Lower(point, radius, delta);
  m_Minimum = std::min(m_Minimum, delta);
}

void
DelaunayRefinementLocalDelta::Lower(ComponentType component, double delta)
{
  if (!(delta < m_DeltaOfComponents[component]))
  {
    return;
  }
  m_IsSettled = false;
  m_DeltaOfComponents[component] = delta;
  m_Minimum = std::min(m_Minimum, delta);
  m_MayBeLowered.resize(ToOffset(BoxesPerAxis - 1, BoxesPerAxis - 1, BoxesPerAxis - 1) + 1);
  const auto         bounds = m_Oracle.GetComponentBounds(component);
  const BoxIndexType first = this->FindBox(bounds.minimum, 0.0);
  const BoxIndexType last = this->FindBox(bounds.maximum, 0.0);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        m_MayBeLowered[ToOffset(x, y, z)] = true;
      }
    }
  }
}

std::vector<std::pair<DelaunayRefinementLocalDelta::ComponentType, double>>
DelaunayRefinementLocalDelta::GetLowered() const
{
  std::vector<std::pair<ComponentType, double>> lowered;
  for (ComponentType component = 0; component < m_DeltaOfComponents.size(); ++component)
  {
    if (m_DeltaOfComponents[component] < m_Delta)
    {
      lowered.emplace_back(component, m_DeltaOfComponents[component]);
    }
  }
  return lowered;
}
} // end namespace itk
