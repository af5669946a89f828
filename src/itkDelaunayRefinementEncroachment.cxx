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
#include "itkDelaunayRefinementEncroachment.h"

#include <algorithm>
#include <set>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;

/** Twice the signed area of a triangle projected along an axis. */
double
ProjectedArea(const DelaunayRefinementPoint & a,
              const DelaunayRefinementPoint & b,
              const DelaunayRefinementPoint & c,
              unsigned int                    axis)
{
  const unsigned int u = (axis + 1) % 3;
  const unsigned int v = (axis + 2) % 3;
  return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}
} // namespace

DelaunayRefinementEncroachment::DelaunayRefinementEncroachment(const DelaunayRefinementComplex & complex)
  : m_Complex(complex)
{
  for (unsigned int i = 0; i < m_BoxEdges.size(); ++i)
  {
    const unsigned int axis = i / 4;
    m_BoxEdges[i] = { complex.GetBox().minimum[axis], complex.GetBox().maximum[axis] };
  }
}

DelaunayRefinementEncroachment::ProposalType
DelaunayRefinementEncroachment::FindEncroachment(const PointType & circumcenter)
{
  const auto &        box = m_Complex.GetBox();
  PointType           nearest = circumcenter;
  std::array<bool, 3> atMaximum{};
  unsigned int        numberOfBounds = 0;
  unsigned int        boundAxis = 0;
  unsigned int        freeAxis = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    nearest[i] = std::clamp(circumcenter[i], box.minimum[i], box.maximum[i]);
    atMaximum[i] = nearest[i] == box.maximum[i];
    if (atMaximum[i] || nearest[i] == box.minimum[i])
    {
      ++numberOfBounds;
      boundAxis = i;
    }
    else
    {
      freeAxis = i;
    }
  }
  if (numberOfBounds == 0)
  {
    return { EncroachmentCase::NONE, circumcenter, 0.0 };
  }
  if (numberOfBounds > 1)
  {
    return this->SplitBoxEdge(EncroachmentCase::E1, freeAxis, atMaximum, nearest[freeAxis]);
  }

  const IndexType          infiniteCell = this->FindBoxFacet(boundAxis, atMaximum[boundAxis], nearest);
  std::array<PointType, 3> corners;
  unsigned int             number = 0;
  for (const IndexType vertex : m_Complex.GetTriangulation().GetCell(infiniteCell).vertices)
  {
    if (vertex != DelaunayRefinementTriangulation::InfiniteVertex)
    {
      corners[number++] = m_Complex.GetPoint(vertex);
    }
  }
  const auto ball = Geometry::ComputeCircumsphere(corners[0], corners[1], corners[2]);

  // E3: the center is within the diametral ball of a box edge around the face.
  for (unsigned int other = 1; other < 3; ++other)
  {
    const unsigned int across = (boundAxis + other) % 3;
    const unsigned int along = 3 - boundAxis - across;
    for (const bool side : { false, true })
    {
      std::array<bool, 3> sides = atMaximum;
      sides[across] = side;
      const double distance =
        side ? box.maximum[across] - ball.center[across] : ball.center[across] - box.minimum[across];
      const unsigned int  first = along == 0 ? 1 : 0;
      const unsigned int  second = along == 2 ? 1 : 2;
      const BoxEdgeType & edge = this->GetBoxEdge(along, sides[first], sides[second]);
      const double        coordinate = std::clamp(ball.center[along], edge.front(), edge.back());
      const auto          upper = std::upper_bound(edge.begin() + 1, edge.end() - 1, coordinate);
      const double        half = 0.5 * (*upper - *(upper - 1));
      const double        offset = ball.center[along] - 0.5 * (*upper + *(upper - 1));
      if (distance <= 0.0 || distance * distance + offset * offset < half * half)
      {
        return this->SplitBoxEdge(EncroachmentCase::E3, along, sides, coordinate);
      }
    }
  }
  PointType center = m_Complex.Round(ball.center);
  center[boundAxis] = nearest[boundAxis];
  return { EncroachmentCase::E2, center, std::sqrt(ball.squaredRadius) };
}

DelaunayRefinementEncroachment::BoxEdgeType &
DelaunayRefinementEncroachment::GetBoxEdge(unsigned int axis, bool firstAtMaximum, bool secondAtMaximum)
{
  return m_BoxEdges[4 * axis + 2 * (firstAtMaximum ? 1 : 0) + (secondAtMaximum ? 1 : 0)];
}

DelaunayRefinementEncroachment::ProposalType
DelaunayRefinementEncroachment::SplitBoxEdge(EncroachmentCase            which,
                                             unsigned int                axis,
                                             const std::array<bool, 3> & atMaximum,
                                             double                      coordinate)
{
  const auto &       box = m_Complex.GetBox();
  const unsigned int first = axis == 0 ? 1 : 0;
  const unsigned int second = axis == 2 ? 1 : 2;
  BoxEdgeType &      edge = this->GetBoxEdge(axis, atMaximum[first], atMaximum[second]);
  const auto         upper = std::upper_bound(edge.begin() + 1, edge.end() - 1, coordinate);
  const double       low = *(upper - 1);
  const double       high = *upper;
  const double       middle = m_Complex.Round(0.5 * (low + high));
  edge.insert(upper, middle);
  PointType point;
  point[axis] = middle;
  point[first] = atMaximum[first] ? box.maximum[first] : box.minimum[first];
  point[second] = atMaximum[second] ? box.maximum[second] : box.minimum[second];
  return { which, point, std::min(middle - low, high - middle) };
}

DelaunayRefinementEncroachment::IndexType
DelaunayRefinementEncroachment::FindBoxFacet(unsigned int axis, bool atMaximum, const PointType & point) const
{
  const auto & triangulation = m_Complex.GetTriangulation();
  const double position = atMaximum ? m_Complex.GetBox().maximum[axis] : m_Complex.GetBox().minimum[axis];
  IndexType    current = this->FindAnyBoxFacet(axis, atMaximum);

  // A walk in a Delaunay triangulation of the plane ends; the bound is for rounding errors alone.
  for (std::size_t step = 0; step < triangulation.GetNumberOfCellIndexes(); ++step)
  {
    const auto & cell = triangulation.GetCell(current);
    IndexType    next = current;
    for (unsigned int i = 0; i < 4 && next == current; ++i)
    {
      if (cell.vertices[i] == DelaunayRefinementTriangulation::InfiniteVertex)
      {
        continue;
      }
      std::array<PointType, 2> edge;
      unsigned int             number = 0;
      for (unsigned int j = 0; j < 4; ++j)
      {
        if (j != i && cell.vertices[j] != DelaunayRefinementTriangulation::InfiniteVertex)
        {
          edge[number++] = m_Complex.GetPoint(cell.vertices[j]);
        }
      }
      const double own = ProjectedArea(edge[0], edge[1], m_Complex.GetPoint(cell.vertices[i]), axis);
      const double wanted = ProjectedArea(edge[0], edge[1], point, axis);
      if (own * wanted < 0.0 && this->IsOnFace(cell.neighbors[i], axis, position))
      {
        next = cell.neighbors[i];
      }
    }
    if (next == current)
    {
      break;
    }
    current = next;
  }
  return current;
}

DelaunayRefinementEncroachment::IndexType
DelaunayRefinementEncroachment::FindAnyBoxFacet(unsigned int axis, bool atMaximum) const
{
  const auto & triangulation = m_Complex.GetTriangulation();
  const double position = atMaximum ? m_Complex.GetBox().maximum[axis] : m_Complex.GetBox().minimum[axis];
  // The corners of the box are the vertices 1 to 8 and are never removed.
  const IndexType        corner = 1 + (atMaximum ? 1u << axis : 0u);
  std::vector<IndexType> cells{ triangulation.GetCellOfVertex(corner) };
  std::set<IndexType>    seen{ cells.front() };
  while (!cells.empty())
  {
    const IndexType index = cells.back();
    cells.pop_back();
    if (this->IsOnFace(index, axis, position))
    {
      return index;
    }
    const auto & cell = triangulation.GetCell(index);
    for (unsigned int i = 0; i < 4; ++i)
    {
      if (cell.vertices[i] != corner && seen.insert(cell.neighbors[i]).second)
      {
        cells.push_back(cell.neighbors[i]);
      }
    }
  }
  return DelaunayRefinementComplex::None;
}

bool
DelaunayRefinementEncroachment::IsOnFace(IndexType infiniteCell, unsigned int axis, double position) const
{
  const auto & triangulation = m_Complex.GetTriangulation();
  if (!triangulation.IsInfinite(infiniteCell))
  {
    return false;
  }
  for (const IndexType vertex : triangulation.GetCell(infiniteCell).vertices)
  {
    if (vertex != DelaunayRefinementTriangulation::InfiniteVertex && m_Complex.GetPoint(vertex)[axis] != position)
    {
      return false;
    }
  }
  return true;
}
} // end namespace itk
