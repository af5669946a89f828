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
bool
IsWithin(const DelaunayRefinementOracle::BoundsType & bounds, const DelaunayRefinementPoint & point, double margin)
{
  for (int i = 0; i < 3; ++i)
  {
    if (point[i] < bounds.minimum[i] - margin || point[i] > bounds.maximum[i] + margin)
    {
      return false;
    }
  }
  return true;
}
} // namespace

DelaunayRefinementLocalDelta::DelaunayRefinementLocalDelta(const DelaunayRefinementOracle &     oracle,
                                                           const DelaunayRefinementParameters & parameters)
  : m_Oracle(oracle)
  , m_Delta(parameters.delta)
  , m_Minimum(parameters.delta)
{
  for (std::size_t i = 0; i < parameters.componentDelta.size(); ++i)
  {
    this->Lower(static_cast<ComponentType>(i), parameters.componentDelta[i]);
  }
}

double
DelaunayRefinementLocalDelta::GetAt(const PointType & point) const
{
  for (const LoweredType & lowered : m_Lowered)
  {
    if (IsWithin(lowered.bounds, point, 0.0))
    {
      return this->GetOfComponent(m_Oracle.FindComponent(point));
    }
  }
  return m_Delta;
}

double
DelaunayRefinementLocalDelta::GetMinimumWithin(const PointType & point, double radius) const
{
  double minimum = m_Delta;
  for (const LoweredType & lowered : m_Lowered)
  {
    if (lowered.delta < minimum && IsWithin(lowered.bounds, point, radius))
    {
      minimum = lowered.delta;
    }
  }
  return minimum;
}

double
DelaunayRefinementLocalDelta::GetOfComponent(ComponentType component) const
{
  const auto found = std::lower_bound(m_Lowered.begin(),
                                      m_Lowered.end(),
                                      component,
                                      [](const LoweredType & a, ComponentType b) { return a.component < b; });
  return found != m_Lowered.end() && found->component == component ? found->delta : m_Delta;
}

void
DelaunayRefinementLocalDelta::Lower(ComponentType component, double delta)
{
  if (!(delta < this->GetOfComponent(component)))
  {
    return;
  }
  const auto place = std::lower_bound(m_Lowered.begin(),
                                      m_Lowered.end(),
                                      component,
                                      [](const LoweredType & a, ComponentType b) { return a.component < b; });
  if (place != m_Lowered.end() && place->component == component)
  {
    place->delta = delta;
  }
  else
  {
    m_Lowered.insert(place, { component, delta, m_Oracle.GetComponentBounds(component) });
  }
  m_Minimum = std::min(m_Minimum, delta);
}

std::vector<std::pair<DelaunayRefinementLocalDelta::ComponentType, double>>
DelaunayRefinementLocalDelta::GetLowered() const
{
  std::vector<std::pair<ComponentType, double>> lowered;
  for (const LoweredType & entry : m_Lowered)
  {
    lowered.emplace_back(entry.component, entry.delta);
  }
  return lowered;
}
} // end namespace itk
