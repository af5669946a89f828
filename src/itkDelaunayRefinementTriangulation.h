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

#include <memory>
#include <utility>

namespace itk
{
class DelaunayRefinementThreads;

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

  /** A facet on the boundary of a cavity: facet \c slot of a cell in it, the cell beyond it, and that one's facet. */
  struct BoundaryType
  {
    std::array<IndexType, 4> vertices;
    IndexType                beyond;
    std::uint8_t             slot;
    std::uint8_t             mirror;
  };

  /** A vertex and what its insertion changes: the cells that go, and those that come, one for each facet of the
   * boundary. */
  struct StarType
  {
    IndexType                                    vertex{ None };
    PointType                                    point{};
    std::vector<IndexType>                       cavity{};
    std::vector<BoundaryType>                    boundary{};
    std::vector<IndexType>                       cells{};
    std::vector<std::pair<IndexType, IndexType>> cellsOfVertices{}; // of the vertices around
  };

  DelaunayRefinementTriangulation();
  ~DelaunayRefinementTriangulation();

  /** Inserts the first points, at least four that are not coplanar and none twice, in an order of its own. Point i
   * becomes vertex i + 1. The cells are the same on any number of threads; all is done on the calling one if
   * \c threads is null. Quickest if the first eight points are the corners of a box around the others. False if
   * \c keepGoing, asked now and then on the calling thread, said so; the triangulation is of no use then. */
  bool
  InsertMany(const std::vector<PointType> & points,
             const std::function<bool()> &  keepGoing,
             DelaunayRefinementThreads *    threads = nullptr);

  /** Inserts a point near the cell \c hint; at once if it lies within the hint's circumsphere. Returns the new vertex,
   * None if the point is a vertex already. */
  IndexType
  Insert(const PointType & point, IndexType hint);

  /** Inserts a removed vertex again, at any point near the cell \c hint; false if the point is a vertex already. */
  bool
  Reinsert(IndexType vertex, const PointType & point, IndexType hint);

  /** Makes room for threads that work on stars, by numbers below this one; InsertMany() does. */
  void
  SetNumberOfThreads(unsigned int numberOfThreads);

  /** Insertion step by step, for several points at a time. Finds what an insertion near \c hint would change; false if
   * the point is a vertex already. Other threads may do the same. The star's vertex is up to the caller. */
  bool
  FindStar(const PointType & point, IndexType hint, StarType & star, unsigned int thread) const;

  /** Stars reserved from here on are apart from each other. */
  void
  StartBatch();

  /** Takes cells for a star, and a vertex if it has None; false if it is not apart from others of the batch, and
   * nothing was taken. */
  bool
  Reserve(StarType & star);

  /** Makes the cells of a reserved star. Other threads may make those of others. */
  void
  Fill(StarType & star, unsigned int thread);

  /** The end of an insertion, once all stars of the batch are filled. */
  void
  Finish(const StarType & star);

  /** Makes the circumball of a new cell as good as can be; InsertMany(), Insert() and Remove() do. */
  void
  MendBall(IndexType cell);

  /** Removes a vertex that is no corner of the convex hull; its index is used again by Reinsert() alone. */
  void
  Remove(IndexType vertex);

  /** The cells that the last call of InsertMany(), Insert() or Remove() made. */
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

  class ScratchType;
  class BulkType;

  /** Everything may be seen and changed. */
  struct WholeType
  {
    static bool
    MaySeeBeyond(const CellType &, unsigned int)
    {
      return true;
    }

    static bool
    MayChange(const CellType &)
    {
      return true;
    }
  };

  class PartType;

  /** FindStar() with what a domain lets it see and change; false also if that is not enough. The cavity begins with a
   * cell near the point even then. */
  template <typename TDomain>
  bool
  FindStarIn(const TDomain & domain, const PointType & point, IndexType hint, StarType & star, ScratchType & scratch)
    const;

  /** A cell in whose circumball a point lies, None if the point is a vertex. */
  template <typename TDomain>
  IndexType
  FindConflict(const TDomain & domain, const PointType & point, IndexType hint) const;

  /** The finite cell that contains a point, or an infinite one beyond whose facet it is; None if it is out of sight. */
  template <typename TDomain>
  IndexType
  Locate(const TDomain & domain, const PointType & point, IndexType start) const;

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

  /** The cells in conflict with a star's point, \c start among them, and the facets around them; false if not all may
   * be changed, and what the star has then is of no use but for the first cell. */
  template <typename TDomain>
  bool
  FindCavity(const TDomain & domain, IndexType start, StarType & star, ScratchType & scratch) const;

  /** All steps of a single insertion, of m_Star; false if the point is a vertex already. */
  bool
  MakeStar(const PointType & point, IndexType hint);

  /** Of an insertion that is done. */
  void
  CollectNewCells();

  /** Takes cells for a star, and a vertex if it has none. */
  void
  Take(StarType & star);

  /** Takes those of a star's cavity first, then what \c takeCell gives; those too many go to \c freeCells. */
  template <typename TTakeCell, typename TFreeCells>
  void
  TakeCells(StarType & star, const TTakeCell & takeCell, TFreeCells & freeCells);

  void
  LinkStar(StarType & star, ScratchType & scratch);
  void
  LinkLargeStar(const StarType & star, ScratchType & scratch);

  /** The cells of a vertex. */
  void
  FindCellsOfVertex(IndexType vertex, StarType & star);

  /** Makes the cells of the hole that a removed vertex has left within m_Star's boundary, with the vertices \c around
   * it. */
  void
  FillHole(const std::vector<IndexType> & around);

  /** The same where the infinite vertex is one of them. */
  void
  FillHoleAtHull(const std::vector<IndexType> & around);

  /** The facets of a star's cavity to cells that are marked as beyond it. */
  void
  FindBoundary(StarType & star, ScratchType & scratch) const;

  BoundaryType
  MakeBoundary(IndexType cell, unsigned int slot) const;

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

  /** ComputeBall() of the cells of a star. */
  void
  ComputeBallsOfStar(const StarType & star);

  /** The vertices of the facet opposite to each vertex, counterclockwise as seen from that vertex. */
  static constexpr unsigned int FacetVertices[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };

  /** Relative difference of squared distances that decides against a circumball known well enough. */
  static constexpr double DecidingShare = 1e-7;

  DelaunayRefinementArray<PointType>     m_Points{};
  DelaunayRefinementArray<IndexType>     m_CellOfVertex{};
  DelaunayRefinementArray<CellType>      m_Cells{};
  DelaunayRefinementArray<std::uint32_t> m_Generations{};
  DelaunayRefinementArray<IndexType>     m_FreeCells{};
  DelaunayRefinementArray<IndexType>     m_NewCells{};

  /** The number of the last batch that replaced each cell, or one beside it. */
  DelaunayRefinementArray<std::uint32_t> m_Batches{};
  std::uint32_t                          m_NumberOfBatches{ 0 };

  StarType                                  m_Star{}; // of single insertions
  std::vector<std::unique_ptr<ScratchType>> m_Scratches{};
};
} // end namespace itk

#endif
