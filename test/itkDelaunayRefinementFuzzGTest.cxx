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
#include "itkFuzzCase.h"

#include <cstdlib>
#include <iostream>
#include <random>

using namespace itk::DelaunayRefinementTest;

namespace
{
/** A number from the environment, for longer runs than the usual one. */
unsigned int
GetNumber(const char * name, unsigned int usual)
{
  const char * const text = std::getenv(name);
  return text == nullptr ? usual : static_cast<unsigned int>(std::strtoul(text, nullptr, 10));
}

/** Meshes the image of a seed. */
void
MeshSeed(unsigned int seed, FuzzOutcomes & outcomes)
{
  SCOPED_TRACE("Seed " + std::to_string(seed));
  std::mt19937              random(seed);
  std::vector<std::uint8_t> bytes(512);
  for (std::uint8_t & byte : bytes)
  {
    byte = static_cast<std::uint8_t>(random());
  }
  MeshFuzzInput(bytes.data(), bytes.size(), outcomes);
}
} // namespace

TEST(DelaunayRefinementFuzz, SeedsThatFoundDefects)
{
  // 53, 195: surface that was in no patch. 441: a grey component that was taken for flat. 1178, 1432, 1614, 2109:
  // surface of a B-spline that R1 did not see, and R3 did not look for.
  FuzzOutcomes outcomes;
  for (const unsigned int seed : { 53u, 195u, 441u, 1178u, 1432u, 1614u, 2109u })
  {
    MeshSeed(seed, outcomes);
  }
  EXPECT_EQ(outcomes.meshed, 7u);
}

// DELAUNAY_REFINEMENT_FUZZ_IMAGES=10000 DELAUNAY_REFINEMENT_FUZZ_SEED=1 make a long run; a failure tells its seed.
TEST(DelaunayRefinementFuzz, RandomImagesKeepTheGuarantees)
{
  const unsigned int first = GetNumber("DELAUNAY_REFINEMENT_FUZZ_SEED", 0);
  const unsigned int count = GetNumber("DELAUNAY_REFINEMENT_FUZZ_IMAGES", 200);
  FuzzOutcomes       outcomes;
  for (unsigned int seed = first; seed < first + count; ++seed)
  {
    MeshSeed(seed, outcomes);
  }
  std::cout << count << " images: " << outcomes.meshed << " meshes of " << outcomes.tetrahedra << " tetrahedra, "
            << outcomes.refusedParameters << " refused parameters, " << outcomes.refusedObjects << " refused objects\n";
  EXPECT_GT(outcomes.meshed, count / 2);
}
