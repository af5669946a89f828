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
#ifndef itkDelaunayRefinementVertexTrial_h
#define itkDelaunayRefinementVertexTrial_h

#include "itkDelaunayRefinementDihedralAngles.h"
#include "itkDelaunayRefinementLocalTopology.h"
#include "itkDelaunayRefinementManifoldRepair.h"

namespace itk
{
/** \class DelaunayRefinementVertexTrial
 * \brief Tells what tetrahedra there would be if a vertex were put at a point, and puts it there if that helps against
 * slivers and harms nothing.
 *
 * It helps if the badness of all tetrahedra together becomes less (DelaunayRefinementDihedralAngles). It does no harm
 * if no rule fires for any of the tetrahedra that come, the facets that would part regions may do so, and the
 * boundaries of regions keep their topology (DelaunayRefinementLocalTopology). Tetrahedra that were given to another
 * region than that of their circumcenter (DelaunayRefinementManifoldRepair) stay with it if one of their vertices is
 * moved, and keep others from being inserted in their place.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementVertexTrial
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementComplex::IndexType;
  using RegionType = DelaunayRefinementComplex::RegionType;
  using VertexKind = DelaunayRefinementEnums::VertexKind;

  DelaunayRefinementVertexTrial(const DelaunayRefinementParameters & parameters,
                                const DelaunayRefinementOracle &     oracle,
                                const DelaunayRefinementRules &      rules,
                                DelaunayRefinementManifoldRepair &   repair,
                                DelaunayRefinementComplex &          complex);

  /** 0 for tetrahedra without a small angle, and outside. */
  double
  ComputeBadness(IndexType cell) const;

  /** Whether a new vertex, FREE or FEATURE, would help at a point near \c hint, as far as can be told beforehand. Free
   * vertices keep \c spacing to all others, feature vertices to those of their kind. */
  bool
  MayInsert(const PointType & point, VertexKind kind, IndexType hint, double spacing);

  /** The same for a feature vertex that need not help, but do no harm. */
  bool
  MayInsertFeature(const PointType & point, IndexType hint);

  /** Inserts what the last call of MayInsert() or MayInsertFeature() was about; None if that does harm, and nothing was
   * changed then. */
  IndexType
  Insert(const PointType & point, VertexKind kind, double delta, IndexType hint);

  /** Takes a vertex out, to be put somewhere else; false if it has to stay. Its tetrahedra stay with their regions
   * where that is possible if \c keepRegions is set; else only those that were given to them. */
  bool
  TakeOut(IndexType vertex, bool keepRegions);

  /** Of the vertex that was taken out: its shortest edge, the one to the nearest feature vertex, and the normal of the
   * boundary, 0 if it is not on one. */
  /** @ITKStartGrouping */
  double
  GetShortestEdge() const
  {
    return m_ShortestEdge;
  }
  double
  GetNearestFeature() const
  {
    return m_NearestFeature;
  }
  const PointType &
  GetNormal() const
  {
    return m_Normal;
  }
  /** @ITKEndGrouping */

  /** As MayInsert(), for the vertex that was taken out. */
  bool
  MayPut(const PointType & point, double spacing);

  /** Puts it there; false if that does harm, and it is taken out again then. */
  bool
  Put(const PointType & point, double delta);

  /** Puts it where it was. */
  void
  PutBack();

  /** Leaves a tetrahedron to outside; false if that does harm, and nothing was changed then. */
  bool
  GiveAway(IndexType cell);

  /** By how much the badness would change, if the last call of MayInsert() or MayPut() was answered by yes: negative.
   */
  double
  GetChange() const
  {
    return m_Change;
  }

  /** Whether no angle would be small then. */
  bool
  WouldMendAll() const
  {
    return m_Change + m_BadnessBefore < LeastGain;
  }

  /** The tetrahedra that came with the last vertex that was inserted, put or put back, or when it was taken back. */
  const std::vector<IndexType> &
  GetCells() const
  {
    return m_Cells;
  }

private:
  using FacetsType = DelaunayRefinementLocalTopology::FacetsType;
  using FacetVerticesType = std::array<IndexType, 3>;

  /** A cell that a vertex would make. */
  struct ShapeType
  {
    PointType  center;
    double     squaredRadius;
    RegionType region;
  };

  /** An edge around the facets from which the new cells would be made; two of them share it. */
  struct EdgeType
  {
    std::array<IndexType, 2> ends;
    std::uint32_t            shape;
  };

  /** Forgets the vertex that was taken out. */
  void
  CloseHole();

  bool
  MayBeAt(const PointType & point, VertexKind kind, IndexType hint, double spacing, double mostChange);

  /** Looks at the cells that would go; false if one of them may not. */
  bool
  ExamineCavity(bool isFree);

  bool
  KeepsSpacing(const PointType & point, bool isFree, double spacing) const;

  /** Finds the cells that would come; false if one of them may not, or their badness is above \c most. */
  bool
  FindShapes(const PointType & point, bool isFree, double most);

  /** Whether facets that would part regions may do so, and the boundaries keep their topology. */
  bool
  KeepsBoundary(const PointType & point);

  /** Whether no rule fires for cells that came, and the boundary is a manifold where that is to be asked. */
  bool
  IsHarmless(VertexKind kind);

  /** Any rule, all cells being in the regions of their circumcenters. */
  bool
  FiresAny();

  bool
  IsManifoldWhereAsked();

  /** What is known of a vertex's cells; false if it has to stay. */
  bool
  DescribeStar(bool keepRegions);

  /** Removes the vertex, and lists the cells in its place. */
  void
  OpenHole();

  /** Gives cells of the vertex to the regions that they had. */
  void
  RestoreRegions();

  /** The region that a cell of the vertex had; \c own if it was not to be kept. */
  RegionType
  FindKeptRegion(FacetVerticesType others, RegionType own) const;

  bool
  IsTooLarge(double squaredRadius, double squaredShortestEdge) const;
  bool
  IsTooLarge(IndexType cell) const;

  /** Whether a facet may be part of a boundary: all its vertices are on the surface, and its angles large enough. */
  bool
  MayPartRegions(const PointType & first, IndexType second, IndexType third) const;

  bool
  MayPartRegions(const FacetVerticesType & vertices) const
  {
    return m_Complex.IsFeature(vertices[0]) &&
           this->MayPartRegions(m_Complex.GetPoint(vertices[0]), vertices[1], vertices[2]);
  }

  /** Adds the facets of a cell, but for those beyond which is a cell with a mark; false if they are to be \c areNew and
   * one may not part regions. */
  bool
  AddFacets(IndexType                                      cell,
            const DelaunayRefinementArray<std::uint32_t> & marks,
            std::uint32_t                                  mark,
            FacetsType &                                   facets,
            bool                                           areNew) const;

  static constexpr IndexType None = DelaunayRefinementComplex::None;

  /** Less is no gain. */
  static constexpr double LeastGain = 1e-6;

  const DelaunayRefinementParameters & m_Parameters;
  const DelaunayRefinementOracle &     m_Oracle;
  const DelaunayRefinementRules &      m_Rules;
  DelaunayRefinementManifoldRepair &   m_Repair;
  DelaunayRefinementComplex &          m_Complex;
  DelaunayRefinementDihedralAngles     m_Angles;
  DelaunayRefinementLocalTopology      m_Topology{};
  DelaunayRefinementVertexStar         m_VertexStar{};

  // The last place that was asked for.
  DelaunayRefinementComplex::StarType m_Star{};
  std::vector<ShapeType>              m_Shapes{};
  std::vector<EdgeType>               m_Edges{};
  FacetsType                          m_FacetsBefore{};
  FacetsType                          m_FacetsAfter{};
  RegionType                          m_Region{ 0 }; // that all cells of a free vertex are in
  double                              m_BadnessBefore{ 0.0 };
  double                              m_Change{ 0.0 };

  // The vertex that is out, and the cells that it had.
  IndexType                                             m_Vertex{ None };
  PointType                                             m_OldPoint{};
  double                                                m_OldDelta{ 0.0 };
  double                                                m_ShortestEdge{ 0.0 };
  double                                                m_NearestFeature{ 0.0 };
  PointType                                             m_Normal{};
  double                                                m_StarBadness{ 0.0 };
  bool                                                  m_IsUniform{ false }; // all in m_Region
  FacetsType                                            m_StarFacets{};
  std::vector<std::pair<FacetVerticesType, RegionType>> m_KeptRegions{}; // by the other three vertices

  // The cells in their place, by index and generation.
  std::vector<std::pair<IndexType, std::uint32_t>> m_Hole{};
  double                                           m_HoleBadness{ 0.0 };
  std::size_t                                      m_NumberOfTooLarge{ 0 };

  std::vector<IndexType>                        m_Cells{};
  std::vector<std::pair<IndexType, RegionType>> m_Given{};

  // The last cavity that held a cell, and the last hole.
  DelaunayRefinementArray<std::uint32_t> m_CavityMarks{};
  DelaunayRefinementArray<std::uint32_t> m_HoleMarks{};
  std::uint32_t                          m_CavityMark{ 0 };
  std::uint32_t                          m_HoleMark{ 0 };
};
} // end namespace itk

#endif
