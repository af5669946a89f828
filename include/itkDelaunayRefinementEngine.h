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
#ifndef itkDelaunayRefinementEngine_h
#define itkDelaunayRefinementEngine_h

#include "itkDelaunayRefinementOracle.h"

#include <memory>

namespace itk
{
/** \class DelaunayRefinementEngine
 * \brief Delaunay refinement of an object given by an oracle: rules R1 to R4, R4', E1 to E3 of the paper.
 *
 * The engine knows points, regions and lengths; it knows no image and no pipeline, and throws nothing of its own: why a
 * run ended stands in its statistics. One engine makes one mesh. On one thread the mesh depends on oracle and
 * parameters alone, bit for bit.
 *
 * \par References
 * P. Foteinos, A. Chernikov, N. Chrisochoides, "Guaranteed Quality Tetrahedral Delaunay Meshing for Medical Images",
 * sections III to VI.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementEngine
{
public:
  /** The oracle must outlive the engine. Parameters are taken as they are: finite and in the ranges that
   * DelaunayRefinementParameters states. */
  DelaunayRefinementEngine(const DelaunayRefinementOracle & oracle, const DelaunayRefinementParameters & parameters);
  ~DelaunayRefinementEngine();

  DelaunayRefinementEngine(const DelaunayRefinementEngine &) = delete;
  DelaunayRefinementEngine &
  operator=(const DelaunayRefinementEngine &) = delete;

  /** Refines until no rule applies, or until stopped. */
  DelaunayRefinementEnums::TerminationReason
  Run();

  /** The mesh; empty unless Run() returned COMPLETED. */
  DelaunayRefinementResult
  TakeResult();

  /** Counts and times of Run(); its reason is NO_SURFACE_FOUND before. */
  const DelaunayRefinementStatistics &
  GetStatistics() const;

  /** After Run(): by RefinementRule, for how many cells of the final triangulation, or facets, the rule would still
   * fire, all asked anew. All 0 if Run() returned COMPLETED; slow, for tests. */
  std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules>
  CountFiringRules() const;

private:
  class Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // end namespace itk

#endif
