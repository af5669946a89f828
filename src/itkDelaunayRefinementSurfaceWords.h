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
#ifndef itkDelaunayRefinementSurfaceWords_h
#define itkDelaunayRefinementSurfaceWords_h

#include "itkDelaunayRefinementLocalDelta.h"

namespace itk
{
/** \class DelaunayRefinementSurfaceWords
 * \brief Pieces of a surface, 64 cells each at most: the bits of words, cleared once vertices cover them.
 *
 * Compared in single precision; a little less is covered than could be.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementSurfaceWords
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchesType = DelaunayRefinementSurfacePatches;
  using CellsType = DelaunayRefinementOracle::SurfaceCells;
  using AxesType = DelaunayRefinementOracle::SurfaceCells::AxesType;

  struct WordType
  {
    std::uint64_t               uncovered;
    std::uint64_t               hopeful; // whose centers are beyond the reach of all vertices
    PatchesType::IdentifierType first;
    std::array<float, 3>        corner; // along the axes, from the origin
    std::array<float, 3>        edges;
    float                       squaredReach; // of vertices, less what is lost to rounding
    bool                        isUniform;
    double                      delta; // all over it if that is uniform, else the greatest
  };

  /** Forgets all words, and makes room for some. The nearer they are to \c origin, the less is lost to rounding. */
  void
  Start(const PointType & origin, const AxesType & axes, std::size_t numberOfWords = 0);

  /** A word of cells that vertices within the least delta cover; none is covered as yet. */
  void
  Add(const CellsType & cells, const DelaunayRefinementLocalDelta::RangeType & delta);

  /** A place along the axes, from the origin. */
  using PlaceType = std::array<float, 3>;

  /** That of a point; the same for all words with one origin and axes. */
  PlaceType
  FindPlace(const PointType & point) const;

  using NumbersType = DelaunayRefinementArray<std::uint32_t>;

  /** Appends those of the words \c begin to \c end (not included) of which a vertex may cover some cells. */
  void
  FindWithinReach(const PlaceType & vertex, std::size_t begin, std::size_t end, NumbersType & found) const;

  /** Clears the cells that a vertex covers in some words. */
  void
  CoverFrom(const PlaceType & vertex, const NumbersType & numbers);

  std::size_t
  GetSize() const
  {
    return m_Words.size();
  }

  WordType &
  GetWord(std::size_t number)
  {
    return m_Words[number];
  }

  /** Half the greatest distance within a cell, or a little more. */
  static double
  GetCellRadius(const CellsType & cells);

  /** Some cells of a word, for its oracle. */
  CellsType
  GetCells(const WordType & word, std::uint64_t cells) const;

  /** A box around some cells of a word. */
  void
  GetBox(const WordType & word, std::uint64_t cells, PointType & center, PointType & halfExtents) const;

private:
  /** More than is lost to any rounding here. */
  static constexpr float Roundings = 8.0f * std::numeric_limits<float>::epsilon();

  /** No less than what rounding does to the coordinates of a word, and of points in it. */
  static double
  GetRounding(const WordType & word);

  PointType
  ToAxes(const PointType & point) const;

  AxesType                          m_Axes{};
  AxesType                          m_InverseAxes{}; // what it is in space to go one along an axis
  PointType                         m_Origin{};      // along the axes
  DelaunayRefinementArray<WordType> m_Words{};
};
} // end namespace itk

#endif
