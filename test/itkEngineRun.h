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
#ifndef itkEngineRun_h
#define itkEngineRun_h

#include "itkDelaunayRefinementEngine.h"
#include "itkMeshExpectations.h"
#include "itkOracleChecks.h"

namespace itk::DelaunayRefinementTest
{
using RefinementRule = DelaunayRefinementEnums::RefinementRule;
using EncroachmentCase = DelaunayRefinementEnums::EncroachmentCase;
using TerminationReason = DelaunayRefinementEnums::TerminationReason;
using VertexKind = DelaunayRefinementEnums::VertexKind;

/** \class EngineRun
 * \brief What one run of the engine leaves behind.
 */
struct EngineRun
{
  TerminationReason            reason;
  DelaunayRefinementResult     result;
  DelaunayRefinementStatistics statistics;

  /** By RefinementRule; of the final triangulation. */
  std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules> numbersOfFiringRules;

  std::size_t
  GetInsertions(RefinementRule rule) const
  {
    return statistics.insertions[static_cast<std::size_t>(rule)];
  }

  std::size_t
  GetEncroachments(EncroachmentCase which) const
  {
    return statistics.encroachments[static_cast<std::size_t>(which)];
  }
};

inline EngineRun
RunEngine(const DelaunayRefinementOracle & oracle, const DelaunayRefinementParameters & parameters)
{
  DelaunayRefinementEngine engine(oracle, parameters);
  EngineRun                run;
  run.reason = engine.Run();
  run.result = engine.TakeResult();
  run.statistics = engine.GetStatistics();
  run.numbersOfFiringRules = engine.CountFiringRules();
  EXPECT_EQ(run.statistics.terminationReason, run.reason);
  return run;
}

/** Stops the test's function if the run does not end with a mesh. No rule may fire any more. */
inline void
ExpectCompleted(const EngineRun & run)
{
  ASSERT_EQ(run.reason, TerminationReason::COMPLETED);
  for (std::size_t rule = 0; rule < run.numbersOfFiringRules.size(); ++rule)
  {
    EXPECT_EQ(run.numbersOfFiringRules[rule], 0u) << static_cast<RefinementRule>(rule);
  }
  ASSERT_FALSE(run.result.tetrahedra.empty());
  EXPECT_EQ(run.result.pointKinds.size(), run.result.points.size());
  EXPECT_EQ(run.result.regions.size(), run.result.tetrahedra.size());
  EXPECT_EQ(run.result.boundaryRegions.size(), run.result.boundaryTriangles.size());
}

inline DelaunayRefinementParameters
MakeParameters(double delta)
{
  DelaunayRefinementParameters parameters;
  parameters.delta = delta;
  return parameters;
}

inline std::vector<PointType>
GetFeaturePoints(const DelaunayRefinementResult & result)
{
  std::vector<PointType> features;
  for (std::size_t i = 0; i < result.points.size(); ++i)
  {
    if (result.pointKinds[i] == VertexKind::FEATURE)
    {
      features.push_back(result.points[i]);
    }
  }
  return features;
}

/** Rule R1 for the whole surface: the largest distance from a surface point to a feature vertex, but for \c reach. */
inline double
ComputeCoverage(const DelaunayRefinementOracle & oracle, const DelaunayRefinementResult & result, double reach)
{
  const PointLocator features(GetFeaturePoints(result));
  return ComputeMaximumDistance(SampleSurface(oracle, reach),
                                [&features](const PointType & sample) { return features.FindDistance(sample); });
}

/** The length of the shortest edge of the tetrahedra. */
inline double
ComputeShortestEdge(const DelaunayRefinementResult & result)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto & tetrahedron : result.tetrahedra)
  {
    for (unsigned int i = 0; i < 4; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
      {
        shortest = std::min(shortest, Distance(result.points[tetrahedron[i]], result.points[tetrahedron[j]]));
      }
    }
  }
  return shortest;
}

/** FNV-1a over all that a result holds. */
inline std::uint64_t
ComputeHash(const DelaunayRefinementResult & result)
{
  std::uint64_t hash = 14695981039346656037u;
  const auto    add = [&hash](const auto & values) {
    const auto * bytes = reinterpret_cast<const unsigned char *>(values.data());
    for (std::size_t i = 0; i < values.size() * sizeof(values[0]); ++i)
    {
      hash = (hash ^ bytes[i]) * 1099511628211u;
    }
  };
  add(result.points);
  add(result.pointKinds);
  add(result.tetrahedra);
  add(result.regions);
  add(result.boundaryTriangles);
  add(result.boundaryRegions);
  return hash;
}
} // end namespace itk::DelaunayRefinementTest

#endif
