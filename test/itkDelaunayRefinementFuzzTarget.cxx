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

// For libFuzzer: the first expectation that fails ends the run with the input that broke it.
extern "C" int
LLVMFuzzerInitialize(int * argc, char *** argv)
{
  ::testing::InitGoogleTest(argc, *argv);
  ::testing::FLAGS_gtest_throw_on_failure = true;
  return 0;
}

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size)
{
  itk::DelaunayRefinementTest::FuzzOutcomes outcomes;
  itk::DelaunayRefinementTest::MeshFuzzInput(data, size, outcomes);
  return 0;
}
