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
#ifndef itkDelaunayRefinementTriangulation_h
#define itkDelaunayRefinementTriangulation_h

#include "itkDelaunayRefinementTypes.h"

#include <memory>

namespace itk
{
/** \class DelaunayRefinementTriangulation
 * \brief A Delaunay triangulation of points, in arrays of indexes.
 *
 * Cells are finite tetrahedra, or infinite ones that join a facet of the convex hull to the infinite vertex. All
 * decisions are exact. Indexes of cells are used again after the cell is gone; a generation tells its uses apart.
 * The same calls give the same indexes and orders.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementTriangulation
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = std::uint32_t;

  static constexpr IndexType None = std::numeric_limits<IndexType>::max();
  static constexpr IndexType InfiniteVertex = 0;

  /** Vertices positively oriented (VTK's order) if finite; neighbor i is opposite to vertex i. */
  struct CellType
  {
    std::array<IndexType, 4> vertices;
    std::array<IndexType, 4> neighbors;
  };

  DelaunayRefinementTriangulation();
  ~DelaunayRefinementTriangulation();

  /** Inserts the first points, none of which is twice in the list, in an order of its own. Point i becomes vertex
   * i + 1. False if \c keepGoing, asked now and then, said so; the triangulation is of no use then. */
  bool
  InsertMany(const std::vector<PointType> & points, const std::function<bool()> & keepGoing);

  /** Inserts a point near the cell \c hint; at once if it lies within the hint's circumsphere. Returns the new vertex,
   * None if the point is a vertex already. */
  IndexType
  Insert(const PointType & point, IndexType hint);

  /** Removes a vertex; its index is not used again. */
  void
  Remove(IndexType vertex);

  /** The cells that the last Insert or Remove made. */
  const std::vector<IndexType> &
  GetNewCells() const
  {
    return m_NewCells;
  }

  /** One more than the largest index of a cell. */
  IndexType
  GetNumberOfCellIndexes() const
  {
    return static_cast<IndexType>(m_Cells.size());
  }

  /** One more than the largest index of a vertex. */
  IndexType
  GetNumberOfVertexIndexes() const
  {
    return static_cast<IndexType>(m_Points.size());
  }

  const CellType &
  GetCell(IndexType cell) const
  {
    return m_Cells[cell];
  }

  const PointType &
  GetPoint(IndexType vertex) const
  {
    return m_Points[vertex];
  }

  /** Some cell of a vertex, None if the vertex was removed. */
  IndexType
  GetCellOfVertex(IndexType vertex) const
  {
    return m_CellOfVertex[vertex];
  }

  /** Odd while the cell exists. */
  std::uint32_t
  GetGeneration(IndexType cell) const
  {
    return m_Generations[cell];
  }

  bool
  IsAlive(IndexType cell) const
  {
    return m_Generations[cell] & 1u;
  }

  bool
  IsInfinite(IndexType cell) const
  {
    const auto & v = m_Cells[cell].vertices;
    return v[0] == InfiniteVertex || v[1] == InfiniteVertex || v[2] == InfiniteVertex || v[3] == InfiniteVertex;
  }

  /** Checks structure and the Delaunay property of everything; slow. */
  bool
  IsValid() const;

private:
  class Kernel;

  void
  ReleaseCell(IndexType cell);

  std::unique_ptr<Kernel>    m_Kernel;
  std::vector<PointType>     m_Points{};
  std::vector<IndexType>     m_CellOfVertex{};
  std::vector<CellType>      m_Cells{};
  std::vector<std::uint32_t> m_Generations{};
  std::vector<IndexType>     m_FreeCells{};
  std::vector<IndexType>     m_NewCells{};
};
} // end namespace itk

#endif
