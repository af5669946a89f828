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
#ifndef itkDelaunayRefinementSurfacePatches_h
#define itkDelaunayRefinementSurfacePatches_h

#include "itkDelaunayRefinementMemory.h"
#include "itkDelaunayRefinementTypes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace itk
{
/** \class DelaunayRefinementSurfacePatches
 * \brief Pieces of a surface, each with a box and a ball around it.
 *
 * There may be many: boxes are kept in single precision, relative to an origin nearby, one array for each number. In
 * the arrays centers are off by as much as rounding of their distance from the origin makes them, GetRounding(); Get()
 * gives boxes and balls that are larger by that.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementSurfacePatches
{
public:
  /** A point of physical space (mm). */
  using PointType = DelaunayRefinementPoint;

  /** By this the oracle knows a piece of the surface. */
  struct IdentifierType
  {
    /** Which piece it is. */
    std::array<std::int32_t, 3> index;
    /** How often it was split. */
    std::uint8_t level;
  };

  /** A piece of the surface. */
  struct PatchType
  {
    /** The whole piece lies within \c radius of \c center, and in the box that extends by \c halfExtents from it (mm).
     */
    PointType center;
    /** Of a ball around \c center (mm). */
    double radius;
    /** Of a box around \c center (mm). */
    PointType halfExtents;
    /** Which piece it is. */
    IdentifierType identifier;
  };

  /** Without patches. The nearer they are to \c origin, the less is lost to rounding. */
  explicit DelaunayRefinementSurfacePatches(const PointType & origin = PointType{})
    : m_Origin(origin)
  {}

  /** Leaves none behind. */
  DelaunayRefinementSurfacePatches(DelaunayRefinementSurfacePatches && other) noexcept
    : DelaunayRefinementSurfacePatches(other.m_Origin)
  {
    *this = std::move(other);
  }

  /** Leaves behind what there was here. */
  DelaunayRefinementSurfacePatches &
  operator=(DelaunayRefinementSurfacePatches && other) noexcept
  {
    std::swap(m_Origin, other.m_Origin);
    std::swap(m_Size, other.m_Size);
    std::swap(m_Capacity, other.m_Capacity);
    std::swap(m_Numbers, other.m_Numbers);
    std::swap(m_Identifiers, other.m_Identifiers);
    return *this;
  }

  /** Forgets all patches. */
  void
  Clear(const PointType & origin)
  {
    m_Origin = origin;
    m_Size = 0;
  }

  /** Makes room for as many patches. */
  void
  Reserve(std::size_t numberOfPatches)
  {
    if (numberOfPatches <= m_Capacity)
    {
      return;
    }
    DelaunayRefinementArray<float>          numbers(NumbersPerPatch * numberOfPatches);
    DelaunayRefinementArray<IdentifierType> identifiers(numberOfPatches);
    for (std::size_t i = 0; i < NumbersPerPatch; ++i)
    {
      std::copy_n(m_Numbers.data() + i * m_Capacity, m_Size, numbers.data() + i * numberOfPatches);
    }
    std::copy_n(m_Identifiers.data(), m_Size, identifiers.data());
    m_Numbers.swap(numbers);
    m_Identifiers.swap(identifiers);
    m_Capacity = numberOfPatches;
  }

  /** The box and the ball of a patch, relative to a corner that many patches may share. */
  struct ShapeType
  {
    /** From the corner (mm). */
    std::array<float, 3> center;
    /** Of the box around \c center (mm). */
    std::array<float, 3> halfExtents;
    /** Of the ball around \c center (mm). */
    float radius;
  };

  /** A shape no smaller than a box and a ball, \c center being relative to the corner (mm). */
  static ShapeType
  MakeShape(const PointType & center, const PointType & halfExtents, double radius)
  {
    ShapeType shape;
    float     loss = 0.0f;
    for (unsigned int i = 0; i < 3; ++i)
    {
      shape.center[i] = static_cast<float>(center[i]);
      loss += Rounding * std::abs(shape.center[i]);
    }
    for (unsigned int i = 0; i < 3; ++i)
    {
      shape.halfExtents[i] = static_cast<float>(halfExtents[i]) * (1.0f + Rounding) + loss;
    }
    shape.radius = static_cast<float>(radius) * (1.0f + Rounding) + loss;
    return shape;
  }

  /** From the origin to a corner. */
  std::array<float, 3>
  MakeCorner(const PointType & corner) const
  {
    return { static_cast<float>(corner[0] - m_Origin[0]),
             static_cast<float>(corner[1] - m_Origin[1]),
             static_cast<float>(corner[2] - m_Origin[2]) };
  }

  /** A patch of a shape at a corner, from MakeCorner(). */
  void
  Add(const ShapeType & shape, const std::array<float, 3> & corner, const IdentifierType & identifier)
  {
    if (m_Size == m_Capacity)
    {
      this->Grow();
    }
    float * const     numbers = m_Numbers.data() + m_Size;
    const std::size_t capacity = m_Capacity;
    for (unsigned int i = 0; i < 3; ++i)
    {
      numbers[i * capacity] = corner[i] + shape.center[i];
      numbers[(3 + i) * capacity] = shape.halfExtents[i];
    }
    numbers[6 * capacity] = shape.radius;
    m_Identifiers[m_Size] = identifier;
    ++m_Size;
  }

  /** A patch within a box and a ball (mm). */
  void
  Add(const PointType & center, const PointType & halfExtents, double radius, const IdentifierType & identifier)
  {
    this->Add(MakeShape(PointType{}, halfExtents, radius), this->MakeCorner(center), identifier);
  }

  /** A patch of another list with the same origin. */
  void
  Add(const DelaunayRefinementSurfacePatches & other, std::size_t number)
  {
    if (m_Size == m_Capacity)
    {
      this->Grow();
    }
    for (unsigned int i = 0; i < NumbersPerPatch; ++i)
    {
      m_Numbers[i * m_Capacity + m_Size] = other.m_Numbers[i * other.m_Capacity + number];
    }
    m_Identifiers[m_Size] = other.m_Identifiers[number];
    ++m_Size;
  }

  /** Number of patches. */
  std::size_t
  GetSize() const
  {
    return m_Size;
  }

  /** A bound on what rounding does to centers, and to distances from them, within a distance of the origin. */
  static double
  GetRounding(double distance)
  {
    return Rounding * distance;
  }

  /** What the arrays' coordinates are relative to (mm). */
  const PointType &
  GetOrigin() const
  {
    return m_Origin;
  }

  /** A patch, with room for what rounding did to it. */
  PatchType
  Get(std::size_t number) const
  {
    PatchType patch;
    double    distance = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      patch.center[i] = m_Origin[i] + this->GetCenters(i)[number];
      distance += std::abs(this->GetCenters(i)[number]);
    }
    const double loss = GetRounding(distance + this->GetRadii()[number]);
    for (unsigned int i = 0; i < 3; ++i)
    {
      patch.halfExtents[i] = this->GetHalfExtents(i)[number] + loss;
    }
    patch.radius = this->GetRadii()[number] + loss;
    patch.identifier = m_Identifiers[number];
    return patch;
  }

  /** Of a patch. */
  const IdentifierType &
  GetIdentifier(std::size_t number) const
  {
    return m_Identifiers[number];
  }

  /** Coordinate \c axis of all centers, from the origin (mm). */
  const float *
  GetCenters(unsigned int axis) const
  {
    return m_Numbers.data() + axis * m_Capacity;
  }

  /** Along \c axis, of all boxes (mm). */
  const float *
  GetHalfExtents(unsigned int axis) const
  {
    return m_Numbers.data() + (3 + axis) * m_Capacity;
  }

  /** Of all balls (mm). */
  const float *
  GetRadii() const
  {
    return m_Numbers.data() + 6 * m_Capacity;
  }

private:
  static constexpr std::size_t NumbersPerPatch = 7;

  /** More than is lost to any rounding here. */
  static constexpr float Rounding = 8.0f * std::numeric_limits<float>::epsilon();

  void
  Grow()
  {
    constexpr std::size_t least = 64;
    this->Reserve(m_Capacity == 0 ? least : 2 * m_Capacity);
  }

  PointType   m_Origin;
  std::size_t m_Size{ 0 };
  std::size_t m_Capacity{ 0 };

  // Of numbers as many as there is room for, whatever they are.
  DelaunayRefinementArray<float>          m_Numbers{};
  DelaunayRefinementArray<IdentifierType> m_Identifiers{};
};
} // end namespace itk

#endif
