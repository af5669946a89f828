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
#include "MeshImageMessages.h"

#include <regex>
#include <vector>

namespace meshimage
{
std::string
PlainMessage(const itk::ExceptionObject & error)
{
  // "itk::ERROR: Class(0x1234): Sentence", with "ITK ERROR" in later versions.
  static const std::regex prefix(R"(^\s*(itk::ERROR:\s*|ITK ERROR:\s*)*(\w+\(0x[0-9a-f]+\):\s*)?)", std::regex::icase);
  // Readers add the last error of the system, which need not be theirs.
  static const std::regex reason(R"(\s+Reason:.*)");
  static const std::regex space(R"(\s+)");
  std::string             message = std::regex_replace(std::string(error.GetDescription()), prefix, "");
  message = std::regex_replace(message, space, " ");
  message = std::regex_replace(message, reason, "");
  while (!message.empty() && (message.back() == ' ' || message.back() == '.'))
  {
    message.pop_back();
  }
  return message;
}

std::string
InWordsOfOptions(const std::string & message)
{
  static const std::vector<std::pair<std::regex, std::string>> words{
    { std::regex(R"(\bLowerThreshold\b((,| or| and|/) ?UpperThreshold\b)?|\bUpperThreshold\b)"), "--threshold" },
    { std::regex(R"(\bIsoValue\b)"), "--iso-value" },
    { std::regex(R"(\bMergeLabels(On)?\b)"), "--merge-labels" },
    { std::regex(R"(\bLabels\b)"), "--labels" },
    { std::regex(R"(\bLabelDelta\b)"), "--delta-for" },
    { std::regex(R"(\bDelta\b)"), "--delta" },
    { std::regex(R"(\bMinimumDelta\b)"), "--delta-min" },
    { std::regex(R"(\bSizeField\b)"), "--size-field" },
    { std::regex(R"(\bHausdorffBound\b)"), "--hausdorff-bound" },
    { std::regex(R"(\bPreserveTopology\b)"), "--topology" },
    { std::regex(R"(\bset Manifold on\b)"), "leave out --allow-non-manifold" },
    { std::regex(R"(\bCellSize\b)"), "--cell-size" },
    { std::regex(R"(\bRadiusEdgeRatioBound\b)"), "--radius-edge-bound" },
    { std::regex(R"(\bMinimumDihedralAngle\b)"), "--min-dihedral" },
    { std::regex(R"(\bPaperSlivers\b)"), "--paper-slivers" },
    { std::regex(R"(\bMaximumNumberOfVertices\b)"), "--max-vertices" },
    { std::regex(R"(\bLargestComponentOnly\b)"), "--largest-component" },
    { std::regex(R"(\bMinimumComponentSize\b)"), "--min-component" },
    { std::regex(R"(\bInterpolator\b)"), "--interpolator" },
    { std::regex(R"(\bStrict\b)"), "--strict" },
    { std::regex(R"(\bSmoothing\b)"), "--smoothing" },
    { std::regex(R"(\bNumberOfWorkUnits\b)"), "--threads" }
  };
  std::string translated = message;
  for (const auto & [word, option] : words)
  {
    translated = std::regex_replace(translated, word, option);
  }
  return translated;
}
} // namespace meshimage
