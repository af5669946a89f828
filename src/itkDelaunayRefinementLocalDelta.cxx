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

DelaunayRefinementLocalDelta::BoxesType
DelaunayRefinementLocalDelta::FindBoxes(const PointType & minimum, const PointType & maximum) const
{
  BoxesType boxes;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto find = [&](double coordinate) {
      return static_cast<std::int32_t>(
        std::clamp((coordinate - m_Bounds.minimum[i]) * m_BoxesPerLength[i], 0.0, BoxesPerAxis - 1.0));
    };
    boxes.first[i] = find(minimum[i]);
    boxes.last[i] = find(maximum[i]);
  }
  boxes.rowBits = static_cast<std::uint16_t>((2u << boxes.last[0]) - (1u << boxes.first[0]));
  return boxes;
}

bool
DelaunayRefinementLocalDelta::MayBeLoweredWithin(const PointType & point, double radius) const
{
  if (m_MayBeLowered.empty())
  {
    return false;
  }
  const BoxesType boxes = this->FindBoxes({ point[0] - radius, point[1] - radius, point[2] - radius },
                                          { point[0] + radius, point[1] + radius, point[2] + radius });
  for (std::int32_t z = boxes.first[2]; z <= boxes.last[2]; ++z)
  {
    for (std::int32_t y = boxes.first[1]; y <= boxes.last[1]; ++y)
    {
      if ((m_MayBeLowered[ToRow(y, z)] & boxes.rowBits) != 0)
      {
        return true;
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
  m_MayBeLowered.resize(ToRow(BoxesPerAxis - 1, BoxesPerAxis - 1) + 1);
  const auto      bounds = m_Oracle.GetComponentBounds(component);
  const BoxesType boxes = this->FindBoxes(bounds.minimum, bounds.maximum);
  for (std::int32_t z = boxes.first[2]; z <= boxes.last[2]; ++z)
  {
    for (std::int32_t y = boxes.first[1]; y <= boxes.last[1]; ++y)
    {
      m_MayBeLowered[ToRow(y, z)] |= boxes.rowBits;
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
