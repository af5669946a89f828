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
#ifndef itkDelaunayRefinementAccuracy_h
#define itkDelaunayRefinementAccuracy_h

#include "itkDelaunayRefinementFidelity.h"

namespace itk
{
/** \class DelaunayRefinementAccuracy
 * \brief Lowers delta where the boundary is not what was asked for: in its distance from the surface, or its topology.
 *
 * Both are asked in rounds, when no rule fires and the boundary is a 2-manifold.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementAccuracy
{
public:
  using PointType = DelaunayRefinementPoint;

  DelaunayRefinementAccuracy(const DelaunayRefinementOracle &     oracle,
                             const DelaunayRefinementParameters & parameters,
                             const DelaunayRefinementComplex &    complex,
                             DelaunayRefinementLocalDelta &       localDelta,
                             DelaunayRefinementThreads &          threads);

  /** Lowers delta at some places. False if there are none, and then \c statistics have distances and topologies, as far
   * as there are bounds on them. */
  bool
  Improve(DelaunayRefinementStatistics & statistics);

private:
  using PlaceType = DelaunayRefinementFidelity::PlaceType;

  /** False if boundary and surface are nowhere too far from each other. */
  bool
  ImproveDistance();

  /** False if the boundary has the topology of the object. */
  bool
  ImproveTopology(DelaunayRefinementStatistics & statistics);

  /** Where something is missing in the mesh, is hidden, or too much. */
  std::vector<PlaceType>
  FindPlacesOfOtherTopology(const DelaunayRefinementStatistics & statistics) const;

  bool
  Lower(const std::vector<PlaceType> & places);

  const DelaunayRefinementOracle &            m_Oracle;
  const DelaunayRefinementParameters &        m_Parameters;
  const DelaunayRefinementComplex &           m_Complex;
  DelaunayRefinementLocalDelta &              m_LocalDelta;
  DelaunayRefinementThreads &                 m_Threads;
  double                                      m_Bound; // on the distance: the user's, or one that topology asks for
  std::unique_ptr<DelaunayRefinementFidelity> m_Fidelity{};
  unsigned int                                m_NumberOfRounds{ 0 };
};
} // end namespace itk

#endif
