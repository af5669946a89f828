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
#include "itkDelaunayRefinementAudit.h"

#include <cmath>

namespace itk
{
std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules>
CountFiringDelaunayRefinementRules(const DelaunayRefinementOracle &        oracle,
                                   const DelaunayRefinementLocalDelta &    localDelta,
                                   const DelaunayRefinementSurfaceSample & sample,
                                   const DelaunayRefinementComplex &       complex,
                                   const DelaunayRefinementRules &         rules)
{
  using RefinementRule = DelaunayRefinementEnums::RefinementRule;
  using IndexType = DelaunayRefinementComplex::IndexType;
  std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules> counts{};
  const auto count = [&counts](RefinementRule rule, bool fires) {
    counts[static_cast<std::size_t>(rule)] += fires ? 1 : 0;
  };
  const auto & triangulation = complex.GetTriangulation();
  for (IndexType cell = 0; cell < triangulation.GetNumberOfCellIndexes(); ++cell)
  {
    if (!triangulation.IsAlive(cell) || triangulation.IsInfinite(cell))
    {
      continue;
    }
    const auto              ball = complex.GetBall(cell);
    DelaunayRefinementPoint closest;
    count(RefinementRule::R1,
          oracle.FindClosestSurfacePoint(ball.center, std::sqrt(ball.squaredRadius), closest) &&
            !sample.HasVertexWithin(closest, localDelta.GetAt(closest)));
    count(RefinementRule::R2, rules.FiresR2(cell));
    count(RefinementRule::R4, rules.FiresR4(cell));
    count(RefinementRule::CELL_SIZE, rules.FiresCellSize(cell));
    count(RefinementRule::R4_PRIME, rules.FiresR4Prime(cell));
    for (unsigned int i = 0; i < 4; ++i)
    {
      DelaunayRefinementPoint center;
      count(RefinementRule::R3, cell < triangulation.GetCell(cell).neighbors[i] && rules.FiresR3(cell, i, center));
    }
  }
  return counts;
}
} // end namespace itk
