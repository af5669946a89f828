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
#ifndef itkDelaunayRefinementPatchCover_h
#define itkDelaunayRefinementPatchCover_h

#include "itkDelaunayRefinementGeometry.h"
#include "itkDelaunayRefinementSurfaceWords.h"

namespace itk
{
/** \class DelaunayRefinementPatchCover
 * \brief All words of a surface, in a grid, so that a vertex finds those that it covers.
 *
 * Words come in groups, those of one patch each, and groups in blocks: boxes of cubes of the grid. Blocks are so large
 * that vertices in two of one color never cover words of the same cube, so threads can work at them at the same time:
 * each reads and writes the words of its own block, and clears cells of those around it.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPatchCover
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchesType = DelaunayRefinementSurfacePatches;
  using CubeType = std::array<std::int32_t, 3>;

  static constexpr std::size_t NumberOfColors = 8;

  /** The words of a patch: \c begin to \c end (not included) of its block's. */
  struct GroupType
  {
    std::uint32_t begin;
    std::uint32_t end;
  };

  struct BlockType
  {
    // Of its cubes; the last ones belong to it.
    CubeType first;
    CubeType last;

    // Its groups, and a box around them.
    std::uint32_t begin;
    std::uint32_t end;
    PointType     minimum;
    PointType     maximum;

    DelaunayRefinementSurfaceWords words;
    double                         greatestDelta{ 0.0 }; // of the words
    double                         sumOfDeltas{ 0.0 };
  };

  /** The larger patches, and the greatest delta there is. */
  DelaunayRefinementPatchCover(const PatchesType & roots, double greatestDelta);

  /** Some blocks may be empty. */
  std::size_t
  GetNumberOfBlocks() const
  {
    return m_Blocks.size();
  }

  BlockType &
  GetBlock(std::size_t number)
  {
    return m_Blocks[number];
  }

  /** The blocks with words, those with most of them first, by color. */
  std::array<std::vector<std::uint32_t>, NumberOfColors>
  GetColors() const;

  /** The number of the root that a group comes from. */
  std::uint32_t
  GetRoot(std::uint32_t group) const
  {
    return m_Roots[group];
  }

  GroupType &
  GetGroup(std::uint32_t number)
  {
    return m_Groups[number];
  }

  /** Room for the numbers of words, which calls leave anything in. */
  using NumbersType = DelaunayRefinementSurfaceWords::NumbersType;

  /** Clears all cells that a vertex covers. */
  void
  CoverFrom(const PointType & vertex, NumbersType & scratch);

  /** The same for a vertex in a block; safe while other threads, each with scratch of its own, do it for other blocks
   * of this color. */
  void
  CoverFrom(const PointType & vertex, std::size_t block, NumbersType & scratch);

private:
  struct RangeType
  {
    CubeType first;
    CubeType last; // included
  };

  /** The cubes of all groups that a vertex may cover. */
  RangeType
  FindReach(const PointType & vertex) const
  {
    return { this->FindCube(vertex, -m_GreatestReach), this->FindCube(vertex, m_GreatestReach) };
  }

  /** Points beyond the grid belong to the cubes at its border. */
  CubeType
  FindCube(const PointType & point, double offset) const;

  /** Blocks of at least so many cubes along each axis. */
  void
  MakeBlocks(double leastSize);

  /** Sorts the groups by blocks, and by cubes within these. */
  void
  SortGroups(const PatchesType & roots);

  /** Clears cells of one block, in some cubes. */
  void
  Cover(const DelaunayRefinementSurfaceWords::PlaceType & vertex,
        const RangeType &                                 cubes,
        std::size_t                                       block,
        NumbersType &                                     scratch);

  /** Of a block among the blocks. */
  CubeType
  GetPlace(std::size_t block) const
  {
    const auto row = block / m_BlocksPerAxis[0];
    return { static_cast<std::int32_t>(block % m_BlocksPerAxis[0]),
             static_cast<std::int32_t>(row % m_BlocksPerAxis[1]),
             static_cast<std::int32_t>(row / m_BlocksPerAxis[1]) };
  }

  std::size_t
  ToBlock(const CubeType & place) const
  {
    return (static_cast<std::size_t>(place[2]) * m_BlocksPerAxis[1] + place[1]) * m_BlocksPerAxis[0] + place[0];
  }

  /** Of a cube of a block among all cubes: those of a block follow each other, row by row. */
  std::size_t
  ToOffset(std::size_t block, const CubeType & cube) const
  {
    const CubeType & first = m_Blocks[block].first;
    return block * m_CubesPerBlock +
           (static_cast<std::size_t>(cube[2] - first[2]) * m_BlockSize[1] + cube[1] - first[1]) * m_BlockSize[0] +
           cube[0] - first[0];
  }

  double                     m_GreatestReach{ 0.0 };
  double                     m_CubesPerLength{ 1.0 };
  PointType                  m_Minimum{};
  CubeType                   m_Size{};
  CubeType                   m_BlockSize{};
  CubeType                   m_BlocksPerAxis{};
  std::size_t                m_CubesPerBlock{ 0 };
  std::vector<BlockType>     m_Blocks{};
  std::vector<std::uint32_t> m_Starts{}; // of each cube's groups, and the end
  std::vector<std::uint32_t> m_Roots{};
  std::vector<GroupType>     m_Groups{};
};
} // end namespace itk

#endif
