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
#ifndef itkDelaunayRefinementSpatialOrder_h
#define itkDelaunayRefinementSpatialOrder_h

#include "itkDelaunayRefinementMemory.h"
#include "itkDelaunayRefinementTypes.h"

namespace itk
{
class DelaunayRefinementThreads;

/** \class DelaunayRefinementSpatialOrder
 * \brief An order in which points are quickly inserted into a triangulation.
 *
 * Random rounds, each some times as long as the one before it, and within a round along Hilbert's curve. The first few
 * points are in the first round. Always the same for the same points.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementSpatialOrder
{
public:
  static constexpr unsigned int NumberOfRounds = 4;

  /** On the calling thread if \c threads is null. */
  DelaunayRefinementSpatialOrder(const std::vector<DelaunayRefinementPoint> & points,
                                 DelaunayRefinementThreads *                  threads);

  std::size_t
  GetNumberOfPoints() const
  {
    return m_Entries.size();
  }

  /** The number of the point at a place of the order. */
  std::uint32_t
  operator[](std::size_t place) const
  {
    return m_Entries[place].number;
  }

  /** The first place of a round's points; the next round's begin where they end. */
  std::size_t
  GetBegin(unsigned int round) const;

private:
  static constexpr unsigned int BitsPerAxis = 10;
  static constexpr unsigned int BitsOfCurve = 3 * BitsPerAxis;

  struct EntryType
  {
    std::uint32_t key; // the round, then the position along the curve
    std::uint32_t number;
  };

  DelaunayRefinementArray<EntryType> m_Entries;
};
} // end namespace itk

#endif
