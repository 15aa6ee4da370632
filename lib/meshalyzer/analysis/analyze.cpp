#include "meshalyzer/analysis/analyze.h"

#include "meshalyzer/analysis/curvature_statistics.h"
#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/analysis/internal/attributes.h"
#include "meshalyzer/analysis/internal/complex_topology.h"
#include "meshalyzer/analysis/internal/describe_components.h"
#include "meshalyzer/analysis/internal/integrity.h"
#include "meshalyzer/analysis/internal/measures.h"
#include "meshalyzer/analysis/internal/volume.h"
#include "meshalyzer/base/require.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace meshalyzer {
namespace {

/// Moves into the analysis the parts of the file that reports need, the ids or all of it, and frees
/// the rest.
void keep_what_reports_need(std::shared_ptr<Soup> soup, const AnalysisOptions& options,
                            PreparedMesh& mesh, Analysis& analysis) {
  if (options.keep_soup || options.keep_mesh == MeshKept::Everything) {
    analysis.vertex_ids = soup->vertex_ids;
    analysis.face_ids = soup->face_ids;
  } else {
    analysis.vertex_ids = std::move(soup->vertex_ids);
    analysis.face_ids = std::move(soup->face_ids);
  }
  if (options.keep_mesh != MeshKept::Everything) {
    mesh.release_soup();
  }
  if (options.keep_soup) {
    analysis.soup = std::move(soup);
  }
}

void count_pairs(const PreparedMesh& mesh, Analysis& analysis) {
  const IntersectionCounts& counts = mesh.intersection_counts();
  Characteristics& c = analysis.characteristics;
  c.intersecting_pairs = counts.kinds.total();
  c.unwelded_pairs = counts.kinds.of(ContactKind::Unwelded);
  c.intersecting_faces = static_cast<std::size_t>(
      std::count(counts.intersects.begin(), counts.intersects.end(), std::uint8_t{1}));
}

/// Takes over what the mesh knows of its components and pairs; if the mesh is not to be kept, it is
/// freed, before the components are described.
void describe_parts(std::shared_ptr<PreparedMesh> mesh, const AnalysisOptions& options,
                    ComponentFindings found, Analysis& analysis) {
  static_cast<void>(mesh->shells());
  analysis.characteristics.is_search_stopped = mesh->was_intersection_search_cut();
  const bool has_pairs = options.scope == Scope::Everything;
  std::vector<IntersectingPair>& pairs = analysis.offenders.intersecting_pairs;
  if (options.keep_mesh == MeshKept::Nothing) {
    found.boxes = std::move(*mesh).component_boxes();
    found.shells = std::move(*mesh).shells();
    if (has_pairs) pairs = std::move(*mesh).intersecting_pairs();
    mesh.reset();
  } else {
    const bool keeps_pairs = options.keep_mesh == MeshKept::Everything;
    found.boxes = mesh->component_boxes();
    found.shells = mesh->shells();
    if (has_pairs) {
      pairs = keeps_pairs ? mesh->intersecting_pairs() : std::move(*mesh).intersecting_pairs();
    }
    analysis.mesh = std::move(mesh);
  }
  for (const Box3& box : found.boxes) analysis.characteristics.bounding_box.extend(box);
  analysis.components = describe_components(found);
}

/// Completes an analysis whose counts and measures are known: answers the attributes and judges the
/// mesh.
void conclude(const AnalysisOptions& options, bool is_orientable, Analysis& analysis) {
  analysis.attributes = answer_attributes(analysis, is_orientable);
  analysis.characteristics.volume = total_volume(analysis);
  answer_genus(analysis);
  if (options.scope == Scope::Everything || options.judge_fitness) {
    analysis.fitness = judge_fitness(analysis);
  }
  if (options.goodness) {
    analysis.goodness = judge(analysis, *options.goodness);
  }
}

void require_valid(const MeshRequest& request) {
  if (request.goodness) {
    require_number("the threshold of the aspect ratio", request.goodness->aspect_ratio);
    require_number("the threshold of the edge angle", request.goodness->edge_angle_degrees);
    require_number("the threshold of the edge length", request.goodness->edge_length);
  }
  require_number("the length below which edges are listed", request.shorter_than);
  require_number("the length above which edges are listed", request.longer_than);
  require_number("the angle below which edges are listed", request.angle_below_degrees);
  require_number("the angle above which edges are listed", request.angle_above_degrees);
  require_number("the aspect ratio above which faces are listed", request.aspect_above);
}

}  // namespace

PairLimits pair_limits(const MeshRequest& request, StopQuery wants_to_stop) {
  return {.max_listed = request.max_list == 0 ? kAllPairs : request.max_list,
          .wants_to_stop = std::move(wants_to_stop)};
}

Analysis analyze(Soup soup, std::string path, const AnalysisOptions& options) {
  require_valid(options);
  require_finite_positions(soup);
  const auto phase = [&](std::string_view name) {
    if (options.on_phase) {
      options.on_phase(name);
    }
  };
  const bool everything = options.scope == Scope::Everything;
  Analysis analysis;
  analysis.path = std::move(path);
  analysis.format = soup.format;
  analysis.n_merged_points = soup.n_merged_points;
  analysis.n_polygons = soup.n_polygons;
  analysis.has_characteristics = everything;

  phase("half-edges");
  auto file = std::make_shared<Soup>(std::move(soup));
  auto mesh = std::make_shared<PreparedMesh>(file, pair_limits(options, options.wants_to_stop));
  phase("integrity");
  analysis.integrity = check_integrity(*file, analysis.offenders);
  count_records(*file, analysis.characteristics);
  keep_what_reports_need(std::exchange(file, nullptr), options, *mesh, analysis);
  phase("topology");
  ComplexTopology topology = analyze_topology(*mesh, analysis.offenders);
  count_elements(topology, analysis);

  ComponentFindings found{.counts = std::move(topology.counts)};
  if (everything) {
    phase("measures");
    found.measures = measure(mesh->cut(), mesh->components(), options, analysis);
  }
  if (everything && options.curvature) {
    phase("curvature");
    analysis.curvature = curvature_statistics(mesh->cut(), *options.curvature);
  }
  // The volume of a single component does not depend on the tree, so that they need not be in
  // memory together.
  if (mesh->components().count == 1) static_cast<void>(mesh->shells());
  if (everything || options.judge_fitness) {
    phase("face tree");
    static_cast<void>(mesh->tree());
    phase("self-intersection");
    count_pairs(*mesh, analysis);
    found.intersecting_pairs = mesh->intersection_counts().of_component;
  }
  phase("solids");
  describe_parts(std::move(mesh), options, std::move(found), analysis);
  conclude(options, topology.orientable, analysis);
  return analysis;
}

}  // namespace meshalyzer
