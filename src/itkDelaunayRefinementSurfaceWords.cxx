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
#include "itkDelaunayRefinementSurfaceWords.h"

#include "itkDelaunayRefinementBits.h"
#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementWideLoops.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
} // namespace

void
DelaunayRefinementSurfaceWords::Start(const PointType & origin, const AxesType & axes, std::size_t numberOfWords)
{
  m_Axes = axes;
  m_InverseAxes = Geometry::Invert(axes);
  m_Origin = {};
  m_Origin = this->ToAxes(origin);
  m_Words.clear();
  m_Words.reserve(numberOfWords);
}

DelaunayRefinementSurfaceWords::PointType
DelaunayRefinementSurfaceWords::ToAxes(const PointType & point) const
{
  return { Geometry::Dot(m_Axes[0], point) - m_Origin[0],
           Geometry::Dot(m_Axes[1], point) - m_Origin[1],
           Geometry::Dot(m_Axes[2], point) - m_Origin[2] };
}

void
DelaunayRefinementSurfaceWords::Add(const CellsType & cells, const DelaunayRefinementLocalDelta::RangeType & delta)
{
  WordType word{ cells.bits, cells.bits, cells.first, {}, {}, 0.0f, delta.least == delta.greatest, delta.greatest };
  for (unsigned int i = 0; i < 3; ++i)
  {
    word.corner[i] = static_cast<float>(cells.corner[i] - m_Origin[i]);
    word.edges[i] = static_cast<float>(cells.edges[i]);
  }
  // Coordinates of vertices that cover any of it are no greater than its own and delta.
  const double reach = delta.least - GetRounding(word) - Roundings * delta.least - cells.margin;
  word.squaredReach = static_cast<float>(reach * std::abs(reach));
  m_Words.push_back(word);
}

DelaunayRefinementSurfaceWords::PlaceType
DelaunayRefinementSurfaceWords::FindPlace(const PointType & point) const
{
  const PointType place = this->ToAxes(point);
  return { static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2]) };
}

void
DelaunayRefinementSurfaceWords::FindWithinReach(const PlaceType & vertex,
                                                std::size_t       begin,
                                                std::size_t       end,
                                                NumbersType &     found) const
{
  // Which ones are no processor foresees: each is written down, and kept by counting.
  std::size_t number = found.size();
  found.resize(number + end - begin);
  for (std::size_t i = begin; i < end; ++i)
  {
    const WordType & word = m_Words[i];
    float            squaredDistance = 0.0f;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const float half = 0.5f * CellsType::CellsPerSide * word.edges[axis];
      const float beyond = std::abs(vertex[axis] - word.corner[axis] - half) - half;
      const float positive = 0.5f * (beyond + std::abs(beyond));
      squaredDistance += positive * positive;
    }
    found[number] = static_cast<std::uint32_t>(i);
    const bool isOpen = (word.uncovered | word.hopeful) != 0;
    number += (isOpen ? 1 : 0) & (squaredDistance <= word.squaredReach ? 1 : 0);
  }
  found.resize(number);
}

ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
void
DelaunayRefinementSurfaceWords::CoverFrom(const PlaceType & vertex, const NumbersType & numbers)
{
  constexpr std::int32_t side = CellsType::CellsPerSide;
  for (const std::uint32_t number : numbers)
  {
    WordType & word = m_Words[number];
    // Along each axis, to the centers and to the furthest points.
    float squares[3][side];
    float furthests[3][side];
    for (unsigned int i = 0; i < 3; ++i)
    {
      const float offset = vertex[i] - word.corner[i];
      for (std::int32_t j = 0; j < side; ++j)
      {
        const float distance = std::abs(offset - (static_cast<float>(j) + 0.5f) * word.edges[i]);
        const float furthest = distance + 0.5f * word.edges[i];
        squares[i][j] = distance * distance;
        furthests[i][j] = furthest * furthest;
      }
    }
    // For each row of cells along z, what is left of the reach.
    float rows[side * side];
    float furthestRows[side * side];
    for (std::int32_t i = 0; i < side * side; ++i)
    {
      rows[i] = word.squaredReach - (squares[0][i % side] + squares[1][i / side]);
      furthestRows[i] = word.squaredReach - (furthests[0][i % side] + furthests[1][i / side]);
    }
    std::uint64_t within = 0;
    std::uint64_t covered = 0;
    for (std::int32_t i = 0; i < side; ++i)
    {
      within |= std::uint64_t{ FindDelaunayRefinementNumbersFrom(squares[2][i], rows) } << (side * side * i);
      covered |= std::uint64_t{ FindDelaunayRefinementNumbersFrom(furthests[2][i], furthestRows) } << (side * side * i);
    }
    word.hopeful &= ~within;
    word.uncovered &= ~covered;
  }
}

double
DelaunayRefinementSurfaceWords::GetRounding(const WordType & word)
{
  double extent = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    extent += std::abs(word.corner[i]) + CellsType::CellsPerSide * word.edges[i];
  }
  return Roundings * extent;
}

double
DelaunayRefinementSurfaceWords::GetCellRadius(const CellsType & cells)
{
  return 0.5 * std::sqrt(Geometry::Dot(cells.edges, cells.edges));
}

DelaunayRefinementSurfaceWords::CellsType
DelaunayRefinementSurfaceWords::GetCells(const WordType & word, std::uint64_t cells) const
{
  CellsType result{ cells, word.first, {}, {}, GetRounding(word) };
  for (unsigned int i = 0; i < 3; ++i)
  {
    result.corner[i] = m_Origin[i] + word.corner[i];
    result.edges[i] = word.edges[i];
  }
  return result;
}

void
DelaunayRefinementSurfaceWords::GetBox(const WordType & word,
                                       std::uint64_t    cells,
                                       PointType &      center,
                                       PointType &      halfExtents) const
{
  center.fill(0.0);
  halfExtents.fill(0.0);
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int layers = GetDelaunayRefinementLayers(cells, i);
    const double       first = FindDelaunayRefinementBit(layers);
    const double       end = layers >= 8 ? 4.0 : layers >= 4 ? 3.0 : layers >= 2 ? 2.0 : 1.0;
    const double       middle = m_Origin[i] + word.corner[i] + 0.5 * (first + end) * word.edges[i];
    const double       half = 0.5 * (end - first) * word.edges[i];
    for (unsigned int j = 0; j < 3; ++j)
    {
      center[j] += middle * m_InverseAxes[i][j];
      halfExtents[j] += std::abs(half * m_InverseAxes[i][j]);
    }
  }
}
} // end namespace itk
