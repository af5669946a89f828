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
#ifndef itkDelaunayRefinementLocalDelta_h
#define itkDelaunayRefinementLocalDelta_h

#include "itkDelaunayRefinementOracle.h"

namespace itk
{
/** \class DelaunayRefinementLocalDelta
 * \brief The delta that holds at a point of the surface: lower for some components than for the rest.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementLocalDelta
{
public:
  using PointType = DelaunayRefinementPoint;
  using ComponentType = DelaunayRefinementOracle::ComponentType;

  DelaunayRefinementLocalDelta(const DelaunayRefinementOracle & oracle, const DelaunayRefinementParameters & parameters);

  /** Delta at a point of the surface. */
  double
  GetAt(const PointType & point) const;

  /** A lower bound on delta over the part of the surface within \c radius of \c point. */
  double
  GetMinimumWithin(const PointType & point, double radius) const;

  double
  GetOfComponent(ComponentType component) const;

  double
  GetMinimum() const
  {
    return m_Minimum;
  }

  double
  GetMaximum() const
  {
    return m_Delta;
  }

  /** Whether delta is the same everywhere. */
  bool
  IsUniform() const
  {
    return m_Lowered.empty();
  }

  /** Lowers the delta of one component. */
  void
  Lower(ComponentType component, double delta);

  /** The components with a lower delta, and their deltas, ascending. */
  std::vector<std::pair<ComponentType, double>>
  GetLowered() const;

private:
  struct LoweredType
  {
    ComponentType                        component;
    double                               delta;
    DelaunayRefinementOracle::BoundsType bounds;
  };

  const DelaunayRefinementOracle & m_Oracle;
  double                           m_Delta;
  double                           m_Minimum;
  std::vector<LoweredType>         m_Lowered{};
};
} // end namespace itk

#endif
