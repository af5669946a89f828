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

#include "itkDelaunayRefinementSizeField.h"

namespace itk
{
/** \class DelaunayRefinementLocalDelta
 * \brief The delta that holds at a point of the surface: lower for some components, and around some places, than for
 * the rest.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementLocalDelta
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchType = DelaunayRefinementSurfacePatches::PatchType;
  using ComponentType = DelaunayRefinementOracle::ComponentType;

  using RangeType = DelaunayRefinementOracle::RangeType;

  DelaunayRefinementLocalDelta(const DelaunayRefinementOracle &     oracle,
                               const DelaunayRefinementParameters & parameters);

  /** Delta at a point of the surface: the least of the components that meet there. */
  double
  GetAt(const PointType & point) const;

  /** Bounds on delta over the surface in a patch. */
  RangeType
  GetRange(const PatchType & patch) const;

  double
  GetOfComponent(ComponentType component) const
  {
    return m_DeltaOfComponents[component];
  }

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
    return m_MayBeLowered.empty() && !m_Field.IsStarted();
  }

  /** Lowers the delta of one component. */
  void
  Lower(ComponentType component, double delta);

  /** Lowers delta within \c radius of a point. */
  void
  LowerAround(const PointType & point, double radius, double delta);

  /** After LowerAround(): lowers delta around, so that it changes slowly. */
  void
  Grade()
  {
    m_Field.Grade();
  }

  /** R1 holds with delta as it is. */
  void
  Settle()
  {
    m_IsSettled = true;
    m_Field.Settle();
  }

  /** Whether only the field may have changed since Settle(). */
  bool
  IsSettled() const
  {
    return m_IsSettled;
  }

  /** Whether the field has changed in a patch since Settle(). */
  bool
  HasChanged(const PatchType & patch) const
  {
    return m_Field.IsStarted() && m_Field.HasChanged(patch.center, patch.radius);
  }

  /** The components with a lower delta, and their deltas, by component. */
  std::vector<std::pair<ComponentType, double>>
  GetLowered() const;

private:
  static constexpr std::int32_t BoxesPerAxis = 16;

  /** Boxes of the coarse grid, \c last included; those along x as bits. */
  struct BoxesType
  {
    std::array<std::int32_t, 3> first;
    std::array<std::int32_t, 3> last;
    std::uint16_t               rowBits;
  };

  /** Those that a box meets. */
  BoxesType
  FindBoxes(const PointType & minimum, const PointType & maximum) const;

  /** False if delta is not lowered anywhere within \c radius of \c point. */
  bool
  MayBeLoweredWithin(const PointType & point, double radius) const;

  static std::size_t
  ToRow(std::int32_t y, std::int32_t z)
  {
    return static_cast<std::size_t>(z) * BoxesPerAxis + y;
  }

  const DelaunayRefinementOracle &     m_Oracle;
  DelaunayRefinementOracle::BoundsType m_Bounds;
  PointType                            m_BoxesPerLength{};
  double                               m_Delta;
  double                               m_Minimum;
  std::vector<double>                  m_DeltaOfComponents;

  /** For each row of boxes of a coarse grid over the surface a bit for each box that the bounds of a lowered component
   * reach into; empty if none is lowered. */
  std::vector<std::uint16_t> m_MayBeLowered{};

  double                      m_Resolution; // steps of space in which delta varies
  DelaunayRefinementSizeField m_Field{};
  bool                        m_IsSettled{ false }; // but for the field
};
} // end namespace itk

#endif
