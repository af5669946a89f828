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
#ifndef itkDelaunayRefinementNearbyPoints_h
#define itkDelaunayRefinementNearbyPoints_h

#include "itkDelaunayRefinementSurfacePatches.h"

namespace itk
{
/** \class DelaunayRefinementNearbyPoints
 * \brief The points around some place, asked whether one of them covers a patch.
 *
 * They are kept in single precision, from the place; a little less is covered than could be.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementNearbyPoints
{
public:
  using PointType = DelaunayRefinementPoint;
  using PatchesType = DelaunayRefinementSurfacePatches;

  enum class AnswerEnum : uint8_t
  {
    COVERED, // all of the patch is within delta of one of the points
    NEAR,    // its center is within delta less a share of the patch's radius
    FAR
  };

  /** Forgets all points. Patches are those with the origin \c origin, and lie within \c extent of it. */
  void
  Start(const PointType & origin, double extent)
  {
    m_Origin = origin;
    m_Extent = extent;
    m_NumberOfPoints = 0;
    m_Blocks.clear();
  }

  void
  Add(const PointType & point)
  {
    const std::size_t place = m_NumberOfPoints % BlockSize;
    if (place == 0)
    {
      m_Blocks.emplace_back();
      for (auto & coordinates : m_Blocks.back())
      {
        // Nowhere near.
        coordinates.fill(std::numeric_limits<float>::infinity());
      }
    }
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Blocks.back()[i][place] = static_cast<float>(point[i] - m_Origin[i]);
    }
    ++m_NumberOfPoints;
  }

  AnswerEnum
  Ask(const PatchesType & patches, std::size_t number, double delta, double nearShare) const;

  /** Whether two of the points cover a patch's box together: a part of it each. */
  bool
  DoTwoCover(const PatchesType::PatchType & patch, double delta) const;

  /** Whether some point lies within \c radius of another, give or take the rounding to single precision. */
  bool
  HasPointWithin(const PointType & point, double radius) const;

  /** Appends the numbers, in the order in which they were added, of the points within \c radius of a box, and of some a
   * little further away. */
  void
  FindWithinOfBox(const PointType &            center,
                  const PointType &            halfExtents,
                  double                       radius,
                  std::vector<std::uint32_t> & found) const;

  std::size_t
  GetSize() const
  {
    return m_NumberOfPoints;
  }

private:
  static constexpr std::size_t BlockSize = 8;

  /** Further blocks are left out where points are to cover together. */
  static constexpr std::size_t MostBlocks = 16;

  /** More than is lost to any rounding here. */
  static constexpr double Roundings = 8.0 * std::numeric_limits<float>::epsilon();

  /** Of delta: by so much less two points together cover. */
  static constexpr double MarginOfTwo = 1e-4;

  /** The coordinates of some points. */
  using BlockType = std::array<std::array<float, BlockSize>, 3>;

  /** A box around the origin of coordinates. */
  using BoxType = std::array<float, 3>;
  using LocalPointType = std::array<float, 3>;

  /** Whether each edge of a box whose ends are nearer to different points is within reach of both of them where they
   * are equally near. */
  static bool
  AreEdgesCovered(const BoxType & box, const LocalPointType & a, const LocalPointType & b, float squaredReach);

  static float
  Square(float length)
  {
    return length > 0.0f ? length * length : -1.0f;
  }

  PointType              m_Origin{};
  double                 m_Extent{ 0.0 };
  std::size_t            m_NumberOfPoints{ 0 };
  std::vector<BlockType> m_Blocks{};
};
} // end namespace itk

#endif
