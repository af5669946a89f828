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
constexpr std::uint32_t NotLowered = std::numeric_limits<std::uint32_t>::max();

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
  , m_Bounds(oracle.GetSurfaceBounds())
  , m_Delta(parameters.delta)
  , m_Minimum(parameters.delta)
  , m_Places(oracle.GetNumberOfComponents(), NotLowered)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_BoxesPerLength[i] = BoxesPerAxis / (m_Bounds.maximum[i] - m_Bounds.minimum[i]);
  }
  for (std::size_t i = 0; i < parameters.componentDelta.size(); ++i)
  {
    this->Lower(static_cast<ComponentType>(i), parameters.componentDelta[i]);
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

double
DelaunayRefinementLocalDelta::GetAt(const PointType & point) const
{
  if (!m_Boxes.empty())
  {
    const BoxIndexType box = this->FindBox(point, 0.0);
    for (const std::uint32_t place : m_Boxes[ToOffset(box[0], box[1], box[2])])
    {
      if (IsWithin(m_Lowered[place].bounds, point, 0.0))
      {
        double delta = m_Delta;
        for (const ComponentType component : m_Oracle.FindComponentsAt(point))
        {
          delta = std::min(delta, this->GetOfComponent(component));
        }
        return delta;
      }
    }
  }
  return m_Delta;
}

double
DelaunayRefinementLocalDelta::GetMinimumWithin(const PointType & point, double radius) const
{
  double minimum = m_Delta;
  if (!m_Boxes.empty())
  {
    const BoxIndexType first = this->FindBox(point, -radius);
    const BoxIndexType last = this->FindBox(point, radius);
    for (std::int32_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::int32_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::int32_t x = first[0]; x <= last[0]; ++x)
        {
          for (const std::uint32_t place : m_Boxes[ToOffset(x, y, z)])
          {
            const LoweredType & lowered = m_Lowered[place];
            if (lowered.delta < minimum && IsWithin(lowered.bounds, point, radius))
            {
              minimum = lowered.delta;
            }
          }
        }
      }
    }
  }
  return minimum;
}

double
DelaunayRefinementLocalDelta::GetOfComponent(ComponentType component) const
{
  return m_Places[component] == NotLowered ? m_Delta : m_Lowered[m_Places[component]].delta;
}

void
DelaunayRefinementLocalDelta::Lower(ComponentType component, double delta)
{
  if (!(delta < this->GetOfComponent(component)))
  {
    return;
  }
  m_Minimum = std::min(m_Minimum, delta);
  if (m_Places[component] != NotLowered)
  {
    m_Lowered[m_Places[component]].delta = delta;
    return;
  }
  const auto place = static_cast<std::uint32_t>(m_Lowered.size());
  m_Places[component] = place;
  m_Lowered.push_back({ component, delta, m_Oracle.GetComponentBounds(component) });
  m_Boxes.resize(ToOffset(BoxesPerAxis - 1, BoxesPerAxis - 1, BoxesPerAxis - 1) + 1);
  const BoxIndexType first = this->FindBox(m_Lowered.back().bounds.minimum, 0.0);
  const BoxIndexType last = this->FindBox(m_Lowered.back().bounds.maximum, 0.0);
  for (std::int32_t z = first[2]; z <= last[2]; ++z)
  {
    for (std::int32_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::int32_t x = first[0]; x <= last[0]; ++x)
      {
        m_Boxes[ToOffset(x, y, z)].push_back(place);
      }
    }
  }
}

std::vector<std::pair<DelaunayRefinementLocalDelta::ComponentType, double>>
DelaunayRefinementLocalDelta::GetLowered() const
{
  std::vector<std::pair<ComponentType, double>> lowered;
  for (ComponentType component = 0; component < m_Places.size(); ++component)
  {
    if (m_Places[component] != NotLowered)
    {
      lowered.emplace_back(component, this->GetOfComponent(component));
    }
  }
  return lowered;
}
} // end namespace itk
