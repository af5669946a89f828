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

/** \class MissingComponents
 * \brief Components that are sought, as the bits of words.
 *
 * Most points are far from most components: slabs of space along each axis tell which may be near. */
class MissingComponents
{
public:
  explicit MissingComponents(const DelaunayRefinementOracle & oracle)
    : m_Oracle(oracle)
    , m_Bounds(oracle.GetSurfaceBounds())
    , m_Missing((oracle.GetNumberOfComponents() + BitsPerWord - 1) / BitsPerWord)
    , m_Near(m_Missing.size())
    , m_NumberMissing(oracle.GetNumberOfComponents())
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_SlabsPerLength[axis] = NumberOfSlabs / (m_Bounds.maximum[axis] - m_Bounds.minimum[axis]);
    }
    for (std::uint32_t component = 0; component < oracle.GetNumberOfComponents(); ++component)
    {
      const BoundsType    bounds = oracle.GetComponentBounds(component);
      const std::uint64_t bit = std::uint64_t{ 1 } << component % BitsPerWord;
      m_Missing[component / BitsPerWord] |= bit;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        // One more on either side for what rounding does.
        const std::size_t first = this->FindSlab(bounds.minimum, axis);
        const std::size_t last = this->FindSlab(bounds.maximum, axis) + 1;
        for (std::size_t slab = first - std::min<std::size_t>(first, 1); slab <= std::min(last, NumberOfSlabs - 1);
             ++slab)
        {
          m_Near[component / BitsPerWord][axis][slab] |= bit;
        }
      }
    }
  }

  bool
  IsAnyMissing() const
  {
    return m_NumberMissing.load(std::memory_order_relaxed) > 0;
  }

  /** A point inside is in a tetrahedron of the mesh. */
  void
  Visit(const PointType & point)
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
        const std::uint32_t component = m_Oracle.FindComponent(point);
        const std::uint64_t bit = std::uint64_t{ 1 } << component % BitsPerWord;
        if ((m_Missing[component / BitsPerWord].fetch_and(~bit, std::memory_order_relaxed) & bit) != 0)
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
    for (std::uint32_t component = 0; component < m_Oracle.GetNumberOfComponents(); ++component)
    {
      if (m_Missing[component / BitsPerWord].load() >> component % BitsPerWord & 1u)
      {
        missing.push_back(component);
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

  const DelaunayRefinementOracle &                                     m_Oracle;
  BoundsType                                                           m_Bounds;
  PointType                                                            m_SlabsPerLength{};
  std::vector<std::atomic<std::uint64_t>>                              m_Missing;
  std::vector<std::array<std::array<std::uint64_t, NumberOfSlabs>, 3>> m_Near;
  std::atomic<std::size_t>                                             m_NumberMissing;
};
} // namespace

std::vector<std::uint32_t>
FindMissingDelaunayRefinementComponents(const DelaunayRefinementOracle &  oracle,
                                        const DelaunayRefinementComplex & complex,
                                        DelaunayRefinementThreads &       threads)
{
  const auto &      triangulation = complex.GetTriangulation();
  MissingComponents missing(oracle);
  const auto        visitPiece = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (auto cell = static_cast<IndexType>(begin); cell < end && missing.IsAnyMissing(); ++cell)
    {
      if (triangulation.IsAlive(cell) && complex.GetRegion(cell) != 0)
      {
        missing.Visit(complex.GetCircumcenter(cell));
      }
    }
  };
  DelaunayRefinementThreads::RunPieces(&threads, triangulation.GetNumberOfCellIndexes(), CellsPerPiece, visitPiece);
  return missing.List();
}

std::vector<std::uint32_t>
FindMissingDelaunayRefinementCavities(const DelaunayRefinementOracle &  oracle,
                                      const DelaunayRefinementComplex & complex,
                                      DelaunayRefinementThreads &       threads)
{
  const auto &                   triangulation = complex.GetTriangulation();
  std::vector<std::atomic<bool>> isFound(oracle.GetNumberOfCavities());
  const auto                     visitPiece = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (auto cell = static_cast<IndexType>(begin); cell < end && !isFound.empty(); ++cell)
    {
      if (triangulation.IsAlive(cell) && !triangulation.IsInfinite(cell) && complex.GetRegion(cell) == 0)
      {
        const std::uint32_t cavity = oracle.FindCavity(complex.GetCircumcenter(cell));
        if (cavity < isFound.size())
        {
          isFound[cavity].store(true, std::memory_order_relaxed);
        }
      }
    }
  };
  DelaunayRefinementThreads::RunPieces(&threads, triangulation.GetNumberOfCellIndexes(), CellsPerPiece, visitPiece);
  std::vector<std::uint32_t> missing;
  for (std::uint32_t cavity = 0; cavity < isFound.size(); ++cavity)
  {
    if (!isFound[cavity])
    {
      missing.push_back(cavity);
    }
  }
  return missing;
}
} // end namespace itk
