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
#include "MeshImageOptions.h"

#include "MeshImageOptionValues.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace meshimage
{
namespace
{
/** Adds an option whose value goes through a function of MeshImageOptionValues.h. */
template <typename TTarget, typename TParse>
CLI::Option *
AddValue(CLI::App &          app,
         const std::string & name,
         const std::string & type,
         TTarget &           target,
         TParse              parse,
         const std::string & help)
{
  const auto store = [name, parse, &target](const std::string & text) { target = parse(name, text); };
  return app.add_option_function<std::string>(name, store, help)->type_name(type);
}

void
AddObjectOptions(CLI::App & app, Options & options)
{
  const std::string group = "What is the object (default: all labels but 0)";
  AddValue(app, "--iso-value", "V", options.isoValue, ParseFinite, "grey image: interpolated value at or above V")
    ->group(group);
  app
    .add_option_function<std::string>(
      "--threshold",
      [&options](const std::string & text) { ParseThreshold("--threshold", text, options); },
      "voxels with values from LOWER to UPPER, both included")
    ->type_name("LOWER[,UPPER]")
    ->group(group);
  AddValue(app, "--labels", "A,B,...", options.labels, ParseLabels, "only these labels")->group(group);
  app
    .add_flag(
      "--merge-labels", options.mergeLabels, "several labels as one object; default: as tissues that share interfaces")
    ->group(group);
}

void
AddSizeOptions(CLI::App & app, Options & options)
{
  const std::string group = "How fine";
  AddValue(app,
           "--delta",
           "MM",
           options.delta,
           ParsePositive,
           "sampling density of the surface; chosen from the image if not given")
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--delta-for",
      [&options](const std::vector<std::string> & texts) {
        for (const std::string & text : texts)
        {
          options.labelDeltas.push_back(ParseLabelDelta("--delta-for", text));
        }
      },
      "another delta for a label; may be given several times")
    ->type_name("LABEL=MM")
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
    ->group(group);
  AddValue(app, "--delta-max", "MM", options.delta, ParsePositive, "the same as --delta, beside --delta-min")
    ->group(group);
  AddValue(app,
           "--delta-min",
           "MM",
           options.minimumDelta,
           ParsePositive,
           "lower delta down to this where the surface is bent or parts are thin; default: nowhere")
    ->group(group);
  app
    .add_option("--size-field",
                options.sizeField,
                "an image of lengths in mm with a grid of its own: delta is no larger at any point")
    ->type_name("FILE")
    ->group(group);
  AddValue(
    app, "--cell-size", "MM", options.cellSize, ParsePositive, "upper bound on circumradii inside; default: none")
    ->group(group);
  AddValue(app,
           "--radius-edge-bound",
           "R",
           options.radiusEdgeBound,
           ParseRadiusEdgeBound,
           "upper bound on circumradius over shortest edge, at least 1; default 2")
    ->group(group);
  AddValue(app,
           "--min-dihedral",
           "DEG",
           options.minimumDihedralAngle,
           ParseDihedralAngle,
           "lower bound on dihedral angles, 10 to 15 being a good one; default: none")
    ->group(group);
  app
    .add_flag(
      "--paper-slivers", options.paperSlivers, "against --min-dihedral, split tetrahedra by rule R4' of the paper")
    ->group(group);
  AddValue(app,
           "--hausdorff-bound",
           "MM",
           options.hausdorffBound,
           ParsePositive,
           "upper bound on the distance between boundary and surface, both ways; default: none")
    ->group(group);
  app
    .add_flag(
      "--topology", options.topology, "lower delta until the mesh has the image's components, cavities and handles")
    ->group(group);
  app.add_flag("--allow-non-manifold", options.allowNonManifold, "leave the boundary as the rules make it")
    ->group(group);
  app.add_flag("--refine-outside", options.refineOutside, "rule R2 for all intersecting tetrahedra, as in the paper")
    ->group(group);
  AddValue(app,
           "--max-vertices",
           "N",
           options.maximumNumberOfVertices,
           ParseCount,
           "give up before there are more vertices; default: no limit")
    ->group(group);
}

void
AddRemainingOptions(CLI::App & app, Options & options)
{
  const std::string keep = "What to keep";
  app.add_flag("--largest-component", options.largestComponent, "only the component with the most voxels")->group(keep);
  AddValue(app,
           "--min-component",
           "VOXELS",
           options.minimumComponentSize,
           ParseCount,
           "leave smaller components out; default 1: none")
    ->group(keep);
  app
    .add_flag("--strict",
              options.strict,
              "fail if a label, a component or a cavity is missing in the mesh, or a bound or topology is not kept")
    ->group(keep);

  AddValue(app,
           "--smoothing",
           "MM",
           options.smoothing,
           ParseSmoothing,
           "smooth the steps of labels' voxels by this width; default: not at all");
  AddValue(app,
           "--interpolator",
           "linear|nearest|bspline",
           options.interpolator,
           ParseInterpolator,
           "between the voxels; default linear");
  AddValue(app,
           "--surface",
           "FILE",
           options.surface,
           ParseSurfaceName,
           "also write boundary and interface triangles: .vtp, .vtk, .stl or .ply");
  app.add_option("--report", options.report, "also write counts, times and quality as JSON")->type_name("FILE");
  AddValue(app, "--threads", "N", options.threads, ParseCount, "threads to use; default: all cores");
  app.add_flag("--quiet", options.quiet, "no progress bar, no report on standard output");
}

void
RejectContradictions(const CLI::App & app)
{
  const std::vector<std::pair<std::string, std::string>> contradictions{ { "--iso-value", "--threshold" },
                                                                         { "--iso-value", "--labels" },
                                                                         { "--iso-value", "--merge-labels" },
                                                                         { "--threshold", "--labels" },
                                                                         { "--threshold", "--merge-labels" } };
  if (app.count("--delta") > 0 && app.count("--delta-max") > 0)
  {
    throw UsageError("--delta and --delta-max mean the same: give one of them");
  }
  for (const auto & [first, second] : contradictions)
  {
    if (app.count(first) > 0 && app.count(second) > 0)
    {
      throw UsageError(first + " and " + second + " contradict each other: each says what the object is; choose one");
    }
  }
}
} // namespace

std::optional<Options>
ParseOptions(int argc, char * argv[])
{
  Options  options;
  CLI::App app("Turns a segmented 3D image into a tetrahedral mesh with guaranteed quality.\n", "mesh-image");
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::Throw);
  app.set_version_flag("--version", std::string("mesh-image ") + DelaunayRefinement_VERSION, "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.add_option("IMAGE", options.image, "any 3D scalar image that ITK reads")->required()->type_name("");
  AddValue(app, "OUTPUT", "", options.output, ParseOutputName, "the mesh: .vtu or .vtk")->required();
  AddObjectOptions(app, options);
  AddSizeOptions(app, options);
  AddRemainingOptions(app, options);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success & success)
  {
    app.exit(success, std::cout, std::cerr);
    return std::nullopt;
  }
  catch (const CLI::ParseError & error)
  {
    throw UsageError(error.what());
  }
  RejectContradictions(app);
  RejectSharedNames(options);
  return options;
}
} // namespace meshimage
