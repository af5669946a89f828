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
#ifndef itkDelaunayRefinementComplex_h
#define itkDelaunayRefinementComplex_h

#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementOracle.h"
#include "itkDelaunayRefinementThreads.h"
#include "itkDelaunayRefinementBlocks.h"
#include "itkDelaunayRefinementPointGrid.h"
#include "itkDelaunayRefinementTriangulation.h"

namespace itk
{
/** \class DelaunayRefinementComplex
 * \brief The triangulation in its bounding box, with what the rules need to know of vertices and cells.
 *
 * Every vertex has a kind and the delta that held where it was put; every finite cell has the region of its
 * circumcenter. All are kept in step with insertion and removal.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementComplex
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementTriangulation::IndexType;
  using VertexKind = DelaunayRefinementEnums::VertexKind;
  using BoundsType = DelaunayRefinementOracle::BoundsType;
  using RegionType = DelaunayRefinementOracle::RegionType;

  static constexpr IndexType None = DelaunayRefinementTriangulation::None;

  /** The vertices of the facet opposite to each vertex, counterclockwise as seen from outside the cell. */
  static constexpr unsigned int OutwardFacets[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

  /** Callers round every point before they insert it. */
  DelaunayRefinementComplex(const DelaunayRefinementOracle & oracle, bool roundToFloat, const BoundsType & box);

  /** Inserts the eight corners of the box, vertices 1 to 8, and, strictly inside it, feature vertices, with a delta for
   * each, and free vertices. False if \c keepGoing, asked now and then, said so; the complex is of no use then. */
  bool
  Start(const std::vector<PointType> & features,
        const std::vector<double> &    deltas,
        const std::vector<PointType> & frees,
        DelaunayRefinementThreads &    threads,
        const std::function<bool()> &  keepGoing);

  /** To the type in which points are stored in the end. */
  double
  Round(double coordinate) const
  {
    return m_RoundToFloat ? DelaunayRefinementGeometry::RoundToFloat(coordinate) : coordinate;
  }

  PointType
  Round(const PointType & point) const
  {
    return { this->Round(point[0]), this->Round(point[1]), this->Round(point[2]) };
  }

  /** Inserts a vertex near \c hint; None if the point is a vertex already. GetNewCells() lists what changed. */
  IndexType
  Insert(const PointType & point, VertexKind kind, double delta, IndexType hint);

  /** Inserts a removed vertex again, at any point, as what it was; false if the point is a vertex already. */
  bool
  Reinsert(IndexType vertex, const PointType & point, double delta, IndexType hint);

  using StarType = DelaunayRefinementTriangulation::StarType;

  /** The steps of an insertion, as in the triangulation. */
  bool
  FindStar(const PointType & point, IndexType hint, StarType & star, unsigned int thread) const
  {
    return m_Triangulation.FindStar(point, hint, star, thread);
  }

  void
  StartBatch()
  {
    m_Triangulation.StartBatch();
  }

  bool
  Reserve(StarType & star, VertexKind kind, double delta);

  void
  Fill(StarType & star, unsigned int thread);

  void
  Finish(const StarType & star)
  {
    m_Triangulation.Finish(star);
  }

  bool
  IsStrictlyInsideBox(const PointType & point) const;

  /** Removes a vertex that is no corner of the box. GetNewCells() lists what changed. */
  void
  Remove(IndexType vertex);

  /** The vertices within \c radius of a vertex, itself left out, nearest links first. */
  void
  FindVerticesWithin(IndexType vertex, double radius, std::vector<IndexType> & found);

  /** The free vertices among them. Fast where there are none. */
  void
  FindFreeVerticesWithin(IndexType vertex, double radius, std::vector<IndexType> & found);

  const DelaunayRefinementArray<IndexType> &
  GetNewCells() const
  {
    return m_Triangulation.GetNewCells();
  }

  const DelaunayRefinementTriangulation &
  GetTriangulation() const
  {
    return m_Triangulation;
  }

  const BoundsType &
  GetBox() const
  {
    return m_Box;
  }

  DelaunayRefinementGeometry::SphereType
  GetBall(IndexType cell) const
  {
    return m_Triangulation.GetBall(cell);
  }

  const PointType &
  GetCircumcenter(IndexType cell) const
  {
    return m_Triangulation.GetCell(cell).center;
  }

  /** The block of its circumcenter. */
  std::uint32_t
  FindBlock(IndexType cell) const
  {
    return m_Blocks.Find(this->GetCircumcenter(cell));
  }

  /** 0 for infinite cells. */
  double
  GetSquaredRadius(IndexType cell) const
  {
    return m_Triangulation.GetSquaredRadius(cell);
  }

  /** Where the circumcenter is, unless it was set; infinite cells are outside. */
  RegionType
  GetRegion(IndexType cell) const
  {
    return m_Regions[cell];
  }

  /** Has a region that will be asked for soon fetched from memory. */
  void
  FetchRegion(IndexType cell) const
  {
    DelaunayRefinementMemory::Fetch(m_Regions.data() + cell);
  }

  /** Gives a finite cell to a region, for as long as the cell exists. */
  void
  SetRegion(IndexType cell, RegionType region)
  {
    m_Regions[cell] = region;
  }

  VertexKind
  GetKind(IndexType vertex) const
  {
    return m_Kinds[vertex];
  }

  bool
  IsFeature(IndexType vertex) const
  {
    return m_Kinds[vertex] == VertexKind::FEATURE;
  }

  double
  GetDelta(IndexType vertex) const
  {
    return m_Deltas[vertex];
  }

  const PointType &
  GetPoint(IndexType vertex) const
  {
    return m_Triangulation.GetPoint(vertex);
  }

  /** The points of a finite cell, in its order. */
  std::array<PointType, 4>
  GetPoints(IndexType cell) const
  {
    const auto & v = m_Triangulation.GetCell(cell).vertices;
    return { this->GetPoint(v[0]), this->GetPoint(v[1]), this->GetPoint(v[2]), this->GetPoint(v[3]) };
  }

  /** Vertices there are now, by kind. */
  std::size_t
  GetNumberOfVertices(VertexKind kind) const
  {
    return m_NumbersOfVertices[static_cast<std::size_t>(kind)];
  }

  std::size_t
  GetNumberOfVertices() const
  {
    return m_NumbersOfVertices[0] + m_NumbersOfVertices[1] + m_NumbersOfVertices[2] + m_NumbersOfVertices[3];
  }

private:
  void
  AddVertex(VertexKind kind, double delta);

  void
  UpdateRegion(IndexType cell)
  {
    m_Regions[cell] = m_Triangulation.IsInfinite(cell) ? 0 : m_Oracle.Classify(this->GetCircumcenter(cell));
  }

  void
  UpdateRegions(const DelaunayRefinementArray<IndexType> & cells);

  const DelaunayRefinementOracle &    m_Oracle;
  bool                                m_RoundToFloat;
  BoundsType                          m_Box;
  DelaunayRefinementBlocks            m_Blocks;
  DelaunayRefinementTriangulation     m_Triangulation{};
  DelaunayRefinementArray<RegionType> m_Regions{};
  DelaunayRefinementArray<VertexKind> m_Kinds{};
  DelaunayRefinementArray<double>     m_Deltas{};
  std::array<std::size_t, 4>          m_NumbersOfVertices{};

  // Of the search within a ball: the last search that saw a vertex, and the last star that held a cell.
  DelaunayRefinementArray<std::uint32_t> m_VertexMarks{};
  DelaunayRefinementArray<std::uint32_t> m_CellMarks{};
  std::uint32_t                          m_NumberOfSearches{ 0 };
  std::uint32_t                          m_NumberOfStars{ 0 };

  // Where free vertices are or were, of the vertices up to a number; made anew once there are too many.
  DelaunayRefinementPointGrid m_PlacesOfFree{};
  std::size_t                 m_MostPlaces{ 0 };
  IndexType                   m_NumberOfPlaced{ 0 };
};
} // end namespace itk

#endif
