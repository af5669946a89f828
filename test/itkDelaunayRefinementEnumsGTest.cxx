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
#include "itkDelaunayRefinementEnums.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

using itk::DelaunayRefinementEnums;

namespace
{
template <typename TEnum>
std::string
Print(TEnum value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/** Each value has a name of its own, that begins as given, and whatever follows is called invalid. */
template <typename TEnum>
void
ExpectNames(const std::string & start, unsigned int numberOfValues)
{
  std::set<std::string> names;
  for (unsigned int value = 0; value < numberOfValues; ++value)
  {
    const std::string name = Print(static_cast<TEnum>(value));
    EXPECT_EQ(name.rfind("itk::DelaunayRefinementEnums::" + start + "::", 0), 0u) << name;
    names.insert(name);
  }
  EXPECT_EQ(names.size(), numberOfValues);
  EXPECT_NE(Print(static_cast<TEnum>(numberOfValues)).find("INVALID"), std::string::npos);
}
} // namespace

TEST(DelaunayRefinementEnums, HaveNames)
{
  ExpectNames<DelaunayRefinementEnums::VertexKind>("VertexKind", 4);
  ExpectNames<DelaunayRefinementEnums::RefinementRule>("RefinementRule",
                                                       DelaunayRefinementEnums::NumberOfRefinementRules);
  ExpectNames<DelaunayRefinementEnums::EncroachmentCase>("EncroachmentCase",
                                                         DelaunayRefinementEnums::NumberOfEncroachmentCases);
  ExpectNames<DelaunayRefinementEnums::TerminationReason>("TerminationReason", 4);
  EXPECT_EQ(Print(DelaunayRefinementEnums::RefinementRule::R4_PRIME),
            "itk::DelaunayRefinementEnums::RefinementRule::R4_PRIME");
}
