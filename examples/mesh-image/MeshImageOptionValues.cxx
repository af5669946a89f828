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
#include "MeshImageOptionValues.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace meshimage
{
namespace
{
[[noreturn]] void
Refuse(const std::string & name, const std::string & text, const std::string & wanted)
{
  throw UsageError(name + " must be " + wanted + ", not '" + text + "'");
}

/** Any number, infinite and NaN ones included. */
double
ParseNumber(const std::string & name, const std::string & text)
{
  char *       end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || std::isspace(static_cast<unsigned char>(text.front())) != 0 || end != text.c_str() + text.size())
  {
    Refuse(name, text, "a number");
  }
  return value;
}

/** Splits at commas; "a,,b" has an empty part. */
std::vector<std::string>
Split(const std::string & text)
{
  std::vector<std::string> parts(1);
  for (const char letter : text)
  {
    if (letter == ',')
    {
      parts.emplace_back();
    }
    else
    {
      parts.back().push_back(letter);
    }
  }
  return parts;
}

/** A whole number from 1 on. */
std::uint64_t
ParsePositiveInteger(const std::string & name, const std::string & text, const std::string & wanted)
{
  std::uint64_t value = 0;
  const char *  end = text.data() + text.size();
  const auto    result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || value == 0)
  {
    Refuse(name, text, wanted);
  }
  return value;
}

std::string
LowerCaseExtension(const std::string & text)
{
  std::string extension = std::filesystem::path(text).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return extension;
}
} // namespace

double
ParseFinite(const std::string & name, const std::string & text)
{
  const double value = ParseNumber(name, text);
  if (!std::isfinite(value))
  {
    Refuse(name, text, "a finite number");
  }
  return value;
}

double
ParsePositive(const std::string & name, const std::string & text)
{
  const double value = ParseNumber(name, text);
  if (!std::isfinite(value) || value <= 0.0)
  {
    Refuse(name, text, "a positive, finite number of millimetres");
  }
  return value;
}

double
ParseRadiusEdgeBound(const std::string & name, const std::string & text)
{
  const double value = ParseNumber(name, text);
  if (!std::isfinite(value) || value < 1.0)
  {
    Refuse(name, text, "a finite number of at least 1");
  }
  return value;
}

double
ParseDihedralAngle(const std::string & name, const std::string & text)
{
  const double value = ParseNumber(name, text);
  if (!(value >= 0.0 && value < 60.0))
  {
    Refuse(name, text, "an angle of at least 0 and less than 60 degrees");
  }
  return value;
}

double
ParseSmoothing(const std::string & name, const std::string & text)
{
  const double value = ParseNumber(name, text);
  if (!(value >= 0.0 && std::isfinite(value)))
  {
    Refuse(name, text, "a width of at least 0");
  }
  return value;
}

std::uint64_t
ParseCount(const std::string & name, const std::string & text)
{
  return ParsePositiveInteger(name, text, "a whole number of at least 1");
}

std::vector<std::uint64_t>
ParseLabels(const std::string & name, const std::string & text)
{
  std::vector<std::uint64_t> labels;
  for (const std::string & part : Split(text))
  {
    labels.push_back(
      ParsePositiveInteger(name, part, "positive whole numbers with commas between them (0 is the background)"));
  }
  return labels;
}

std::pair<std::uint64_t, double>
ParseLabelDelta(const std::string & name, const std::string & text)
{
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
  {
    Refuse(name, text, "LABEL=MM");
  }
  return { ParsePositiveInteger(name, text.substr(0, equals), "LABEL=MM with a positive whole number for LABEL"),
           ParsePositive(name, text.substr(equals + 1)) };
}

void
ParseThreshold(const std::string & name, const std::string & text, Options & options)
{
  const std::vector<std::string> parts = Split(text);
  if (parts.size() > 2)
  {
    Refuse(name, text, "one number, or two with a comma between them");
  }
  const double lower = ParseNumber(name, parts.front());
  const double upper = parts.size() == 2 ? ParseNumber(name, parts.back()) : HUGE_VAL;
  if (!(lower <= upper))
  {
    Refuse(name, text, "LOWER[,UPPER] with LOWER not above UPPER");
  }
  // An infinite end is no end.
  if (std::isfinite(lower))
  {
    options.lowerThreshold = lower;
  }
  if (std::isfinite(upper))
  {
    options.upperThreshold = upper;
  }
  if (!options.lowerThreshold && !options.upperThreshold)
  {
    Refuse(name, text, "LOWER[,UPPER] with at least one finite number");
  }
}

Interpolator
ParseInterpolator(const std::string & name, const std::string & text)
{
  if (text == "linear")
  {
    return Interpolator::Linear;
  }
  if (text == "nearest")
  {
    return Interpolator::Nearest;
  }
  if (text == "bspline")
  {
    return Interpolator::BSpline;
  }
  Refuse(name, text, "linear, nearest or bspline");
}

std::string
ParseOutputName(const std::string & name, const std::string & text)
{
  const std::string extension = LowerCaseExtension(text);
  if (extension != ".vtu" && extension != ".vtk")
  {
    Refuse(name, text, "a file name that ends in .vtu or .vtk");
  }
  return text;
}

std::string
ParseSurfaceName(const std::string & name, const std::string & text)
{
  const std::string extension = LowerCaseExtension(text);
  if (extension != ".vtp" && extension != ".vtk" && extension != ".stl" && extension != ".ply")
  {
    Refuse(name, text, "a file name that ends in .vtp, .vtk, .stl or .ply");
  }
  return text;
}

void
RejectSharedNames(const Options & options)
{
  const std::vector<std::pair<std::string, std::string>> files{ { "IMAGE", options.image },
                                                                { "OUTPUT", options.output },
                                                                { "--surface", options.surface },
                                                                { "--report", options.report } };
  for (auto first = files.begin(); first != files.end(); ++first)
  {
    for (auto second = first + 1; second != files.end(); ++second)
    {
      std::error_code ignored;
      if (!first->second.empty() && !second->second.empty() &&
          std::filesystem::absolute(first->second, ignored).lexically_normal() ==
            std::filesystem::absolute(second->second, ignored).lexically_normal())
      {
        throw UsageError(first->first + " and " + second->first + " are the same file, " + second->second +
                         ": give each a name of its own");
      }
    }
  }
}
} // namespace meshimage
