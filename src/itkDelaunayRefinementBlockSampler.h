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
#ifndef itkDelaunayRefinementBlockSampler_h
#define itkDelaunayRefinementBlockSampler_h

#include "itkDelaunayRefinementLocalDelta.h"
#include "itkDelaunayRefinementNearbyPoints.h"
#include "itkDelaunayRefinementPatchCover.h"
#include "itkDelaunayRefinementPointGrid.h"

#include <random>

namespace itk
{
/** \class DelaunayRefinementBlockSampler
 * \brief Rule R1 in blocks of the surface, one after the other: the work of one thread.
 *
 * What it inserts depends on the block's words and on the vertices there were when it started with the block, not on
 * what other threads do meanwhile in blocks of the same color.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementBlockSampler
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchesType = DelaunayRefinementSurfacePatches;

  /** Asked before as many patches as it is told are visited; work stops once it returns false. */
  using MayVisitType = std::function<bool(std::size_t)>;

  /** Points are rounded to floats if \c roundToFloat is set. \c vertices are those there are already; the caller adds
   * the new ones, while no thread is at work in a block. */
  DelaunayRefinementBlockSampler(const DelaunayRefinementOracle &     oracle,
                                 const DelaunayRefinementLocalDelta & localDelta,
                                 bool                                 roundToFloat,
                                 const DelaunayRefinementPointGrid &  vertices,
                                 DelaunayRefinementPatchCover &       cover,
                                 const MayVisitType &                 mayVisit);

  /** Splits a block's part of the surface until its cells are small against delta; \c roots are the oracle's. */
  void
  Collect(const PatchesType & roots, std::size_t block);

  /** Inserts points of cells in a random order, which keeps the sample sparse, and returns them. */
  std::vector<PointType>
  Sample(std::size_t block);

  /** Covers all cells that are not yet, and returns the points it inserts for that. */
  std::vector<PointType>
  Cover(std::size_t block);

private:
  using PatchType = PatchesType::PatchType;
  using WordType = DelaunayRefinementSurfaceWords::WordType;
  using AnswerEnum = DelaunayRefinementNearbyPoints::AnswerEnum;

  /** The least delta that holds in a patch within a word. */
  double
  GetLeastDelta(const WordType & word, const PatchesType & patches, std::size_t number) const
  {
    return word.isUniform ? word.delta : m_LocalDelta.GetRange(patches.Get(number)).least;
  }

  enum class OutcomeEnum : uint8_t
  {
    TOO_NEAR,
    INSERTED,
    EMPTY // the patch holds no surface
  };

  /** The least delta in some cells of a word. */
  double
  GetLeastDelta(const WordType & word, std::uint64_t cells);

  /** Inserts a point of a patch unless one of \c vertices is too near for a delta. */
  template <typename TVertices>
  OutcomeEnum
  SamplePatch(const PatchesType::IdentifierType & patch, double delta, const TVertices & vertices);

  /** Covers all cells of a word that are not yet. */
  bool
  CoverWord(const WordType & word);

  /** Covers some cells of a word, by splitting them again and again. */
  bool
  CoverCells(const WordType & word, std::uint64_t cells);

  /** The feature vertices that may cover some cells of a word. */
  void
  FindNearby(const WordType & word, std::uint64_t cells);

  void
  AddVertex(const PointType & vertex);

  /** Starts with the vertices around a block. */
  void
  Enter(std::size_t block);

  /** Only there m_Vertices has all that are near. */
  bool
  IsInBlock(const PointType & point) const;

  /** The points inserted since. */
  std::vector<PointType>
  Leave() const;

  void
  MakeRandomOrder(std::size_t length, std::mt19937_64 & random);

  const DelaunayRefinementOracle &     m_Oracle;
  const DelaunayRefinementLocalDelta & m_LocalDelta;
  bool                                 m_RoundToFloat;
  const DelaunayRefinementPointGrid &  m_AllVertices;
  DelaunayRefinementPatchCover &       m_Cover;
  MayVisitType                         m_MayVisit;

  // Of the block.
  std::size_t                      m_Block{ 0 };
  DelaunayRefinementSurfaceWords * m_Words{ nullptr };
  DelaunayRefinementPointGrid      m_Vertices{}; // those around it first
  std::size_t                      m_NumberOfOldVertices{ 0 };
  DelaunayRefinementNearbyPoints   m_FewVertices{}; // the same in the same order, as long as they are few

  // Scratch of single calls.
  std::vector<std::uint32_t>                m_Order{};
  PatchesType                               m_Wholes{};
  PatchesType                               m_Parts{};
  PointType                                 m_Center{}; // of the box around which m_Found was
  PointType                                 m_HalfExtents{};
  DelaunayRefinementArray<PointType>        m_Found{};
  std::vector<std::uint32_t>                m_FoundFew{};
  DelaunayRefinementNearbyPoints            m_Nearby{};
  DelaunayRefinementPatchCover::NumbersType m_Reached{};
};
} // end namespace itk

#endif
