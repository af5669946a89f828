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
#include "itkDelaunayRefinementMissingComponents.h"

#include <algorithm>
#include <atomic>

namespace itk
{
namespace
{
using PointType = DelaunayRefinementPoint;
using BoundsType = DelaunayRefinementOracle::BoundsType;
using IndexType = DelaunayRefinementComplex::IndexType;

constexpr std::size_t CellsPerPiece = 16384;

/** \class MissingParts
 * \brief Components or cavities that are sought, as the bits of words.
 *
 * Most points are far from most parts: slabs of space along each axis tell which may be near. */
class MissingParts
{
public:
  /** \c boundsOf gives a box around a part. */
  template <typename TBoundsOf>
  MissingParts(const BoundsType & bounds, std::uint32_t numberOfParts, const TBoundsOf & boundsOf)
    : m_Bounds(bounds)
    , m_NumberOfParts(numberOfParts)
    , m_Missing((numberOfParts + BitsPerWord - 1) / BitsPerWord)
    , m_Near(m_Missing.size())
    , m_NumberMissing(numberOfParts)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_SlabsPerLength[axis] = NumberOfSlabs / (m_Bounds.maximum[axis] - m_Bounds.minimum[axis]);
    }
    for (std::uint32_t part = 0; part < numberOfParts; ++part)
    {
      const BoundsType    around = boundsOf(part);
      const std::uint64_t bit = std::uint64_t{ 1 } << part % BitsPerWord;
      m_Missing[part / BitsPerWord] |= bit;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        // One more on either side for what rounding does.
        const std::size_t first = this->FindSlab(around.minimum, axis);
        const std::size_t last = this->FindSlab(around.maximum, axis) + 1;
        for (std::size_t slab = first - std::min<std::size_t>(first, 1); slab <= std::min(last, NumberOfSlabs - 1);
             ++slab)
        {
          m_Near[part / BitsPerWord][axis][slab] |= bit;
        }
      }
    }
  }

  bool
  IsAnyMissing() const
  {
    return m_NumberMissing.load(std::memory_order_relaxed) > 0;
  }

  /** There is a tetrahedron with its circumcenter at a point; \c find gives the number of the part there, or one that
   * is none. */
  template <typename TFind>
  void
  Visit(const PointType & point, const TFind & find)
  {
    const std::array<std::size_t, 3> slabs{ this->FindSlab(point, 0),
                                            this->FindSlab(point, 1),
                                            this->FindSlab(point, 2) };
    for (std::size_t word = 0; word < m_Missing.size(); ++word)
    {
      const auto & near = m_Near[word];
      if ((near[0][slabs[0]] & near[1][slabs[1]] & near[2][slabs[2]] &
           m_Missing[word].load(std::memory_order_relaxed)) != 0)
      {
        const std::uint32_t part = find(point);
        const std::uint64_t bit = std::uint64_t{ 1 } << part % BitsPerWord;
        if (part < m_NumberOfParts &&
            (m_Missing[part / BitsPerWord].fetch_and(~bit, std::memory_order_relaxed) & bit) != 0)
        {
          m_NumberMissing.fetch_sub(1, std::memory_order_relaxed);
        }
        return;
      }
    }
  }

  std::vector<std::uint32_t>
  List() const
  {
    std::vector<std::uint32_t> missing;
    for (std::uint32_t part = 0; part < m_NumberOfParts; ++part)
    {
      if (m_Missing[part / BitsPerWord].load() >> part % BitsPerWord & 1u)
      {
        missing.push_back(part);
      }
    }
    return missing;
  }

private:
  static constexpr std::size_t  NumberOfSlabs = 64;
  static constexpr unsigned int BitsPerWord = 64;

  std::size_t
  FindSlab(const PointType & point, unsigned int axis) const
  {
    const double slab = (point[axis] - m_Bounds.minimum[axis]) * m_SlabsPerLength[axis];
    return static_cast<std::size_t>(std::clamp(slab, 0.0, NumberOfSlabs - 1.0));
  }

  BoundsType                                                           m_Bounds;
  std::uint32_t                                                        m_NumberOfParts;
  PointType                                                            m_SlabsPerLength{};
  std::vector<std::atomic<std::uint64_t>>                              m_Missing;
  std::vector<std::array<std::array<std::uint64_t, NumberOfSlabs>, 3>> m_Near;
  std::atomic<std::size_t>                                             m_NumberMissing;
};

/** The parts without a finite cell, inside or outside as they are, with its circumcenter there. */
template <typename TFind>
std::vector<std::uint32_t>
FindMissing(MissingParts &                    missing,
            bool                              isInside,
            const DelaunayRefinementComplex & complex,
            DelaunayRefinementThreads &       threads,
            const TFind &                     find)
{
  const auto & triangulation = complex.GetTriangulation();
  const auto   visitPiece = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (auto cell = static_cast<IndexType>(begin); cell < end && missing.IsAnyMissing(); ++cell)
    {
      if (triangulation.IsAlive(cell) && (complex.GetRegion(cell) != 0) == isInside && !triangulation.IsInfinite(cell))
      {
        missing.Visit(complex.GetCircumcenter(cell), find);
      }
    }
  };
  DelaunayRefinementThreads::RunPieces(&threads, triangulation.GetNumberOfCellIndexes(), CellsPerPiece, visitPiece);
  return missing.List();
}
} // namespace

std::vector<std::uint32_t>
FindMissingDelaunayRefinementComponents(const DelaunayRefinementOracle &  oracle,
                                        const DelaunayRefinementComplex & complex,
                                        DelaunayRefinementThreads &       threads)
{
  MissingParts missing(oracle.GetSurfaceBounds(), oracle.GetNumberOfComponents(), [&oracle](std::uint32_t component) {
    return oracle.GetComponentBounds(component);
  });
  return FindMissing(
    missing, true, complex, threads, [&oracle](const PointType & point) { return oracle.FindComponent(point); });
}

std::vector<std::uint32_t>
FindMissingDelaunayRefinementCavities(const DelaunayRefinementOracle &  oracle,
                                      const DelaunayRefinementComplex & complex,
                                      DelaunayRefinementThreads &       threads)
{
  MissingParts missing(oracle.GetSurfaceBounds(), oracle.GetNumberOfCavities(), [&oracle](std::uint32_t cavity) {
    return oracle.GetCavityBounds(cavity);
  });
  return FindMissing(
    missing, false, complex, threads, [&oracle](const PointType & point) { return oracle.FindCavity(point); });
}
} // end namespace itk
