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
#ifndef itkDelaunayRefinementSliverRemoval_h
#define itkDelaunayRefinementSliverRemoval_h

#include "itkDelaunayRefinementSurfaceSample.h"
#include "itkDelaunayRefinementVertexTrial.h"

#include <random>

namespace itk
{
/** \class DelaunayRefinementSliverRemoval
 * \brief Inserts and moves vertices until no tetrahedron inside has a dihedral angle below the user's bound.
 *
 * Points are tried, a few for each sliver and a fixed number of times, and the good ones are taken
 * (DelaunayRefinementVertexTrial). The tetrahedra stay those of a Delaunay triangulation, and all guarantees stay what
 * they were but for R1, which has to be asked again where feature vertices were moved. The same mesh gives the same
 * changes.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementSliverRemoval
{
public:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementComplex::IndexType;

  DelaunayRefinementSliverRemoval(const DelaunayRefinementParameters & parameters,
                                  const DelaunayRefinementOracle &     oracle,
                                  const DelaunayRefinementLocalDelta & localDelta,
                                  const DelaunayRefinementRules &      rules,
                                  DelaunayRefinementManifoldRepair &   repair,
                                  DelaunayRefinementSurfaceSample &    sample,
                                  DelaunayRefinementComplex &          complex,
                                  DelaunayRefinementThreads &          threads);

  /** To be called when no rule fires. True if something was changed. Ends early if \c keepGoing, asked now and then,
   * said so. */
  bool
  Run(const std::function<bool()> & keepGoing);

  /** Inserts the points that R1 asks for where feature vertices were moved, as far as they do no harm: what it gives
   * back is left for the rules. */
  std::vector<PointType>
  Cover(const std::vector<PointType> & points);

  /** The tetrahedra inside with a smaller angle, ascending. */
  std::vector<IndexType>
  FindSlivers() const;

  /** Slivers that the last run left. */
  std::size_t
  GetNumberOfLeft() const
  {
    return m_NumberOfLeft;
  }

  /** Of all runs. */
  /** @ITKStartGrouping */
  std::size_t
  GetNumberOfInsertions() const
  {
    return m_NumberOfInsertions;
  }
  std::size_t
  GetNumberOfMoves() const
  {
    return m_NumberOfMoves;
  }
  /** @ITKEndGrouping */

private:
  using VertexKind = DelaunayRefinementEnums::VertexKind;

  /** A sliver for as long as it exists. */
  struct SliverType
  {
    IndexType     cell;
    std::uint32_t generation;
  };

  /** A place for a vertex, and what it would change. */
  struct PlaceType
  {
    PointType point;
    double    change;
  };

  // What is tried, the cheapest first.
  enum class PassEnum : uint8_t
  {
    INSERT,
    MOVE,
    LAST // all that is left to try
  };

  bool
  IsThere(const SliverType & sliver) const
  {
    return m_Complex.GetTriangulation().GetGeneration(sliver.cell) == sliver.generation;
  }

  /** Tries to change something at a sliver. */
  bool
  Mend(PassEnum pass, const SliverType & sliver);

  /** Inserts a free vertex near the circumcenter. */
  bool
  InsertFree(IndexType cell);

  /** Inserts a feature vertex nearby, closer to others than in the first place. */
  bool
  InsertFeature(IndexType cell);

  bool
  Insert(const PointType & point, VertexKind kind, double delta, double spacing, IndexType cell);

  /** Moves one of the vertices. */
  bool
  Move(IndexType cell, PassEnum pass);

  bool
  MoveVertex(IndexType vertex, PassEnum pass);

  /** A place for a vertex that was taken out, and the spacing that it has to keep there. */
  bool
  ProposePlace(IndexType vertex, const PointType & old, double step, PointType & place, double & spacing);

  /** Tetrahedra that came wait for the next pass if they are slivers. */
  void
  QueueSlivers();

  /** Spacings of free vertices are shares of it. */
  double
  GetFreeLength(const PointType & point) const
  {
    return std::min(m_LocalDelta.GetAt(point), m_Parameters.cellSize);
  }

  PointType
  MoveAtRandom(const PointType & from, double distance);

  const DelaunayRefinementParameters & m_Parameters;
  const DelaunayRefinementOracle &     m_Oracle;
  const DelaunayRefinementLocalDelta & m_LocalDelta;
  DelaunayRefinementSurfaceSample &    m_Sample;
  DelaunayRefinementComplex &          m_Complex;
  DelaunayRefinementThreads &          m_Threads;
  DelaunayRefinementVertexTrial        m_Trial;
  std::vector<SliverType>              m_Next{};
  std::vector<PlaceType>               m_Places{};
  std::mt19937_64                      m_Random{};
  std::size_t                          m_NumberOfLeft{ 0 };
  std::size_t                          m_NumberOfInsertions{ 0 };
  std::size_t                          m_NumberOfMoves{ 0 };
};
} // end namespace itk

#endif
