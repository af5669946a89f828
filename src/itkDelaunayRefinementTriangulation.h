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

#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementMemory.h"

namespace itk
{
/** \class DelaunayRefinementTriangulation
 * \brief A Delaunay triangulation of points, in arrays of indexes.
 *
 * Cells are finite tetrahedra, or infinite ones that join a facet of the convex hull to the infinite vertex. All
 * decisions are exact; points on a common sphere are told apart by a perturbation that depends on their coordinates
 * alone (O. Devillers, M. Teillaud, "Perturbations and vertex removal in a 3D Delaunay triangulation", 2003), so that
 * the triangulation depends on its points and not on their order. Indexes of cells are used again after the cell is
 * gone; a generation tells its uses apart. The same calls give the same indexes and orders.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementTriangulation
{
public:
  using PointType = DelaunayRefinementPoint;
  using SphereType = DelaunayRefinementGeometry::SphereType;
  using IndexType = std::uint32_t;

  static constexpr IndexType None = std::numeric_limits<IndexType>::max();
  static constexpr IndexType InfiniteVertex = 0;

  /** Vertices positively oriented (VTK's order) if finite; neighbor i is opposite to vertex i. */
  struct alignas(64) CellType
  {
    std::array<IndexType, 4> vertices;
    std::array<IndexType, 4> neighbors;
    PointType                center;
    /** Negative if the circumball is not known well enough to decide with; 0 if the cell is infinite. */
    double signedSquaredRadius;
  };

  DelaunayRefinementTriangulation();

  /** Inserts the first points, at least four that are not coplanar and none twice, in an order of its own. Point i
   * becomes vertex i + 1. False if \c keepGoing, asked now and then, said so; the triangulation is of no use then. */
  bool
  InsertMany(const std::vector<PointType> & points, const std::function<bool()> & keepGoing);

  /** Inserts a point near the cell \c hint; at once if it lies within the hint's circumsphere. Returns the new vertex,
   * None if the point is a vertex already. */
  IndexType
  Insert(const PointType & point, IndexType hint);

  /** Removes a vertex that is no corner of the convex hull; its index is not used again. */
  void
  Remove(IndexType vertex);

  /** The cells that the last call made. */
  const DelaunayRefinementArray<IndexType> &
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

  /** The circumball of a finite cell; a radius of 0 for an infinite one. */
  SphereType
  GetBall(IndexType cell) const
  {
    return { m_Cells[cell].center, std::abs(m_Cells[cell].signedSquaredRadius) };
  }

  double
  GetSquaredRadius(IndexType cell) const
  {
    return std::abs(m_Cells[cell].signedSquaredRadius);
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
  /** A facet on the boundary of a cavity: facet \c slot of a cell in it, the cell beyond it, and that one's facet. */
  struct BoundaryType
  {
    std::array<IndexType, 4> vertices;
    IndexType                beyond;
    std::uint8_t             slot;
    std::uint8_t             mirror;
  };

  /** Of cells that the search for a cavity has seen. */
  enum class MarkEnum : uint8_t
  {
    NONE,
    IN,
    OUT
  };

  /** Two cells of a star meet in an edge of the cavity's boundary. */
  struct SharedEdgeType
  {
    std::uint64_t vertices;
    IndexType     cell;
    std::uint8_t  slot;
  };

  /** A facet by its vertices in the order that its cell sees, the smallest first. */
  struct OrientedFacetType
  {
    std::array<IndexType, 3> vertices;
    IndexType                cell;
    std::uint8_t             slot;

    bool
    operator<(const OrientedFacetType & other) const
    {
      return vertices < other.vertices;
    }
  };

  /** The finite cell of four points and the infinite ones around it. */
  void
  MakeFirstCells(std::array<IndexType, 4> vertices);

  /** A cell in whose circumball a point lies, None if the point is a vertex. */
  IndexType
  FindConflict(const PointType & point, IndexType hint) const;

  /** The finite cell that contains a point, or an infinite one beyond whose facet it is. */
  IndexType
  Locate(const PointType & point, IndexType start) const;

  bool
  IsInConflict(IndexType cell, const PointType & point) const
  {
    const CellType & candidate = m_Cells[cell];
    const double     squaredRadius = candidate.signedSquaredRadius;
    const double     x = point[0] - candidate.center[0];
    const double     y = point[1] - candidate.center[1];
    const double     z = point[2] - candidate.center[2];
    const double     excess = x * x + y * y + z * z - squaredRadius;
    if (std::abs(excess) > DecidingShare * squaredRadius && squaredRadius > 0.0)
    {
      return excess < 0.0;
    }
    return this->IsInConflictExactly(cell, point);
  }

  bool
  IsInConflictExactly(IndexType cell, const PointType & point) const;

  /** Replaces all cells in conflict with a vertex, \c start among them, by its star. */
  void
  MakeStar(IndexType vertex, IndexType start);

  void
  FindCavity(const PointType & point, IndexType start);

  void
  ClearMarks();

  void
  LinkStar();
  void
  LinkLargeStar();

  void
  FindStar(IndexType vertex);

  void
  AddBoundary(IndexType cell, unsigned int slot);

  using CornersType = std::array<const PointType *, 4>;

  /** The points of a cell's vertices. Of an infinite cell \c point takes the infinite vertex's place: positively
   * oriented then if it is beyond the facet. Returns the infinite vertex's slot, 4 if there is none. */
  unsigned int
  GetCorners(IndexType cell, const PointType & point, CornersType & corners) const;

  OrientedFacetType
  GetOrientedFacet(IndexType cell, unsigned int slot) const;

  IndexType
  TakeCell();

  void
  ReleaseCell(IndexType cell);

  void
  UpdateCellOfVertices(IndexType cell);

  /** The circumball; what is too flat for floating point is left for MendBall(). */
  void
  ComputeBall(IndexType cell);

  /** ComputeBall() of the cells that MakeStar() made. */
  void
  ComputeBallsOfStar(IndexType vertex);

  /** Exactly where ComputeBall() could not. */
  void
  MendBall(IndexType cell);

  /** Relative difference of squared distances that decides against a circumball known well enough. */
  static constexpr double DecidingShare = 1e-7;

  static constexpr unsigned int MostVerticesOfMatrix = 64;

  DelaunayRefinementArray<PointType>     m_Points{};
  DelaunayRefinementArray<IndexType>     m_CellOfVertex{};
  DelaunayRefinementArray<CellType>      m_Cells{};
  DelaunayRefinementArray<std::uint32_t> m_Generations{};
  DelaunayRefinementArray<IndexType>     m_FreeCells{};
  DelaunayRefinementArray<IndexType>     m_NewCells{};

  // Scratch of single calls.
  std::vector<IndexType>                    m_Cavity{};
  std::vector<BoundaryType>                 m_Boundary{};
  DelaunayRefinementArray<MarkEnum>         m_CellMarks{}; // NONE between calls
  DelaunayRefinementArray<std::uint64_t>    m_VertexPlaces{};
  std::uint32_t                             m_NumberOfStars{ 0 };
  std::vector<IndexType>                    m_Matrix{};
  std::vector<std::array<std::uint32_t, 3>> m_FacetPlaces{};
  std::vector<SharedEdgeType>               m_SharedEdges{};
};
} // end namespace itk

#endif
