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

  DelaunayRefinementLocalDelta(const DelaunayRefinementOracle &     oracle,
                               const DelaunayRefinementParameters & parameters);

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

  /** The components with a lower delta, and their deltas, by component. */
  std::vector<std::pair<ComponentType, double>>
  GetLowered() const;

private:
  struct LoweredType
  {
    ComponentType                        component;
    double                               delta;
    DelaunayRefinementOracle::BoundsType bounds;
  };

  /** Boxes of a coarse grid over the surface, to find the components near a point. */
  using BoxIndexType = std::array<std::int32_t, 3>;
  static constexpr std::int32_t BoxesPerAxis = 16;

  BoxIndexType
  FindBox(const PointType & point, double offset) const;

  static std::size_t
  ToOffset(std::int32_t x, std::int32_t y, std::int32_t z)
  {
    return (static_cast<std::size_t>(z) * BoxesPerAxis + y) * BoxesPerAxis + x;
  }

  const DelaunayRefinementOracle &     m_Oracle;
  DelaunayRefinementOracle::BoundsType m_Bounds;
  PointType                            m_BoxesPerLength{};
  double                               m_Delta;
  double                               m_Minimum;
  /** In the order in which they were lowered first. */
  std::vector<LoweredType> m_Lowered{};

  /** The place of each component in m_Lowered, or one beyond all. */
  std::vector<std::uint32_t> m_Places;

  /** For each box the components that reach into it, by their places in m_Lowered; empty if none is lowered. */
  std::vector<std::vector<std::uint32_t>> m_Boxes{};
};
} // end namespace itk

#endif
