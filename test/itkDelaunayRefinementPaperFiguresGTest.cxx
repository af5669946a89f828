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
#include "itkAnalyticOracles.h"
#include "itkEngineRun.h"

#include <iostream>

using namespace itk::DelaunayRefinementTest;

// Figure 4 of the paper: a sphere of some 750 boundary triangles has 1285 tetrahedra.
TEST(DelaunayRefinementPaperFigures, SphereOf750Triangles)
{
  const BallOracle ball({ 0.0, 0.0, 0.0 }, 20.0);
  const EngineRun  run = RunEngine(ball, MakeParameters(3.1));
  ExpectCompleted(run);
  const auto triangles = static_cast<double>(run.result.boundaryTriangles.size());
  const auto tetrahedra = static_cast<double>(run.result.tetrahedra.size());
  std::cout << "A ball of radius 20 at delta 3.1: " << triangles << " boundary triangles, " << tetrahedra
            << " tetrahedra\n";
  EXPECT_NEAR(triangles, 750.0, 75.0);
  EXPECT_NEAR(tetrahedra, 1285.0, 250.0);
}
