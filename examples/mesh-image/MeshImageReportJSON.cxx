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
#include "MeshImageReport.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace meshimage
{
namespace
{
// Keys in the order of their insertion; numbers that are infinite or none become null.
using Json = nlohmann::ordered_json;

template <typename TValue>
Json
OrNull(const std::optional<TValue> & value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json
Parameters(const Options & options)
{
  constexpr const char * interpolators[] = { "linear", "nearest", "bspline" };
  return { { "iso_value", OrNull(options.isoValue) },
           { "lower_threshold", OrNull(options.lowerThreshold) },
           { "upper_threshold", OrNull(options.upperThreshold) },
           { "labels", options.labels },
           { "merge_labels", options.mergeLabels },
           { "delta", OrNull(options.delta) },
           { "delta_for", options.labelDeltas },
           { "cell_size", OrNull(options.cellSize) },
           { "radius_edge_bound", OrNull(options.radiusEdgeBound) },
           { "min_dihedral", OrNull(options.minimumDihedralAngle) },
           { "paper_slivers", options.paperSlivers },
           { "hausdorff_bound", OrNull(options.hausdorffBound) },
           { "topology", options.topology },
           { "delta_min", OrNull(options.minimumDelta) },
           { "size_field", options.sizeField.empty() ? Json() : Json(options.sizeField) },
           { "allow_non_manifold", options.allowNonManifold },
           { "refine_outside", options.refineOutside },
           { "max_vertices", OrNull(options.maximumNumberOfVertices) },
           { "largest_component", options.largestComponent },
           { "min_component", OrNull(options.minimumComponentSize) },
           { "strict", options.strict },
           { "smoothing", OrNull(options.smoothing) },
           { "interpolator", interpolators[static_cast<int>(options.interpolator)] },
           { "threads", options.threads } };
}

/** Which of the phases were shared by threads. */
Json
ParallelPhases(const Options & options)
{
  return options.threads > 1 ? Json{ "preparation", "sampling", "insertion", "refinement", "extraction", "copy" }
                             : Json::array();
}

Json
Seconds(const Report & report)
{
  const Run & run = report.run;
  return { { "reading", run.readingSeconds },
           { "preparation", run.preparationSeconds },
           { "sampling", run.statistics.samplingSeconds },
           { "insertion", run.statistics.insertionSeconds },
           { "refinement", run.statistics.refinementSeconds },
           { "slivers", run.statistics.sliverSeconds },
           { "extraction", run.statistics.extractionSeconds },
           { "copy", run.copySeconds },
           { "measuring", report.measuringSeconds },
           { "writing", report.writingSeconds } };
}

Json
Rules(const itk::DelaunayRefinementStatistics & statistics)
{
  using Rule = itk::DelaunayRefinementEnums::RefinementRule;
  using Case = itk::DelaunayRefinementEnums::EncroachmentCase;
  const auto insertions = [&statistics](Rule rule) { return statistics.insertions[static_cast<std::size_t>(rule)]; };
  const auto encroachments = [&statistics](Case kind) {
    return statistics.encroachments[static_cast<std::size_t>(kind)];
  };
  return { { "R1", insertions(Rule::R1) },
           { "R2", insertions(Rule::R2) },
           { "R3", insertions(Rule::R3) },
           { "R4", insertions(Rule::R4) },
           { "R4'", insertions(Rule::R4_PRIME) },
           { "cell_size", insertions(Rule::CELL_SIZE) },
           { "shape", insertions(Rule::SHAPE) },
           { "junction", insertions(Rule::JUNCTION) },
           { "manifold", insertions(Rule::MANIFOLD) },
           { "sliver", insertions(Rule::SLIVER) },
           { "E1", encroachments(Case::E1) },
           { "E2", encroachments(Case::E2) },
           { "E3", encroachments(Case::E3) },
           { "seeds", statistics.seeds },
           { "removals", statistics.removals },
           { "moves", statistics.movedVertices },
           { "encroachment_removals", statistics.encroachmentRemovals } };
}

Json
Vertices(const itk::DelaunayRefinementStatistics & statistics)
{
  using Kind = itk::DelaunayRefinementEnums::VertexKind;
  const auto vertices = [&statistics](Kind kind) { return statistics.vertices[static_cast<std::size_t>(kind)]; };
  return { { "box_edge", vertices(Kind::BOX_EDGE) },
           { "box", vertices(Kind::BOX) },
           { "free", vertices(Kind::FREE) },
           { "feature", vertices(Kind::FEATURE) } };
}

Json
QualityFigures(const Quality & quality)
{
  return { { "radius_edge_ratio_max", quality.radiusEdgeRatioMaximum },
           { "dihedral_angle_min", quality.dihedralAngleMinimum },
           { "dihedral_angle_max", quality.dihedralAngleMaximum },
           { "boundary_angle_min", quality.boundaryAngleMinimum },
           { "edge_min", quality.edgeMinimum },
           { "edge_max", quality.edgeMaximum },
           { "dihedral_angle_histogram",
             { { "bin_width", Quality::binWidth }, { "counts", quality.dihedralAngleHistogram } } } };
}

Json
Describe(const Run & run, const itk::DelaunayRefinementComponent & component)
{
  return { { "label", run.labels.at(component.region - 1) },
           { "voxels", component.numberOfVoxels },
           { "volume", component.volume },
           { "place", component.firstVoxel } };
}

Json
MissingComponents(const Run & run)
{
  Json list = Json::array();
  for (const std::size_t number : run.statistics.missingComponents)
  {
    list.push_back(Describe(run, run.components.at(number)));
  }
  return list;
}

Json
MissingCavities(const Run & run)
{
  Json list = Json::array();
  for (const std::size_t number : run.statistics.missingCavities)
  {
    const itk::DelaunayRefinementCavity & cavity = run.cavities.at(number);
    list.push_back(
      { { "voxels", cavity.numberOfVoxels }, { "volume", cavity.volume }, { "place", cavity.firstVoxel } });
  }
  return list;
}

/** Null if it was not measured. */
Json
Distance(const itk::DelaunayRefinementDistance & distance)
{
  return distance.distance < 0.0 ? Json() : Json{ { "distance", distance.distance }, { "place", distance.place } };
}

/** Null if it was not counted. */
Json
Topology(const itk::DelaunayRefinementTopology & topology)
{
  return topology.isKnown ? Json{ { "components", topology.components },
                                  { "cavities", topology.cavities },
                                  { "genus", topology.GetGenus() },
                                  { "euler_characteristic", topology.eulerCharacteristic } }
                          : Json();
}

Json
LoweredDeltas(const Run & run)
{
  Json list = Json::array();
  for (const auto & [number, delta] : run.statistics.loweredDeltas)
  {
    Json entry = Describe(run, run.components.at(number));
    entry["delta"] = delta;
    list.push_back(entry);
  }
  return list;
}

Json
LoweredSmoothings(const Run & run)
{
  Json list = Json::array();
  for (const auto & [component, width] : run.loweredSmoothings)
  {
    Json entry = Describe(run, component);
    entry["smoothing"] = width;
    list.push_back(entry);
  }
  return list;
}

/** The worst come first. */
Json
Slivers(const Run & run)
{
  Json slivers = Json::array();
  for (const itk::DelaunayRefinementSliver & sliver : run.statistics.slivers)
  {
    slivers.push_back({ { "dihedral_angle", sliver.dihedralAngle }, { "place", sliver.place } });
  }
  return slivers;
}

std::string
Name(itk::DelaunayRefinementEnums::TerminationReason reason)
{
  std::ostringstream text;
  text << reason;
  const std::string name = text.str();
  return name.substr(name.rfind(':') + 1);
}

Json
Compose(const Report & report)
{
  const Run & run = report.run;
  return { { "version", DelaunayRefinement_VERSION },
           { "image", report.options.image },
           { "output", report.options.output },
           { "parameters", Parameters(report.options) },
           { "points", run.mesh->GetNumberOfPoints() },
           { "tetrahedra", run.mesh->GetNumberOfCells() },
           { "boundary_triangles", run.boundary->GetNumberOfCells() },
           { "delta", run.delta },
           { "filter_seconds", run.filterSeconds },
           { "seconds", Seconds(report) },
           { "parallel", ParallelPhases(report.options) },
           { "rules", Rules(run.statistics) },
           { "vertices", Vertices(run.statistics) },
           { "quality", QualityFigures(report.quality) },
           { "labels", run.labels },
           { "components", run.components.size() },
           { "missing_components", MissingComponents(run) },
           { "cavities", run.cavities.size() },
           { "missing_cavities", MissingCavities(run) },
           { "missing_labels", run.missingLabels },
           { "lowered_deltas", LoweredDeltas(run) },
           { "slivers", Slivers(run) },
           { "changed_tetrahedra", run.statistics.changedTetrahedra },
           { "non_manifold_vertices", run.statistics.nonManifoldVertices },
           { "mesh_to_surface", Distance(run.statistics.meshToSurface) },
           { "surface_to_mesh", Distance(run.statistics.surfaceToMesh) },
           { "image_topology", Topology(run.statistics.imageTopology) },
           { "mesh_topology", Topology(run.statistics.meshTopology) },
           { "lowered_smoothings", LoweredSmoothings(run) },
           { "warnings", run.warnings },
           { "termination", Name(run.statistics.terminationReason) } };
}
} // namespace

void
WriteReport(const std::string & fileName, const Report & report)
{
  // Names of files need not be UTF-8.
  const std::string text = Compose(report).dump(2, ' ', false, Json::error_handler_t::replace);
  std::ofstream     file(fileName, std::ios::binary);
  file << text << '\n';
  file.close();
  if (!file)
  {
    throw RunError("The file " + fileName + " cannot be written: make room or choose another folder");
  }
}
} // namespace meshimage
