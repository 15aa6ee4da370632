#include "meshalyzer/analysis/analyze.h"

#include "meshalyzer/analysis/attributes.h"
#include "meshalyzer/analysis/complex_topology.h"
#include "meshalyzer/analysis/curvature_statistics.h"
#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/analysis/integrity.h"
#include "meshalyzer/analysis/measures.h"
#include "meshalyzer/analysis/solids.h"
#include "meshalyzer/geometry/extent.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

/// Frees what only the file needs; ids go into the analysis, and all of it where a report will
/// show places.
void keep_what_reports_need(Soup soup, bool keep_soup, Analysis& analysis) {
  if (keep_soup) {
    analysis.vertex_ids = soup.vertex_ids;
    analysis.face_ids = soup.face_ids;
    analysis.soup = std::make_shared<const Soup>(std::move(soup));
  } else {
    analysis.vertex_ids = std::move(soup.vertex_ids);
    analysis.face_ids = std::move(soup.face_ids);
  }
}

void box_components(const CutMesh& cut, const Components& components, Analysis& analysis) {
  const std::vector<Box3> boxes =
      bounding_boxes(cut.mesh, {.of_face = components.of_face, .count = components.count});
  for (std::size_t c = 0; c < boxes.size(); ++c) {
    analysis.components[c].bounding_box = boxes[c];
    analysis.characteristics.bounding_box.extend(boxes[c]);
  }
}

void count_pairs(const CutMesh& cut, const Components& components,
                 const std::vector<IntersectingPair>& pairs, Analysis& analysis) {
  std::vector<std::uint8_t> intersects(cut.mesh.n_faces(), 0);
  const auto meet = [&](Index file_face) {
    const std::size_t mesh_face = cut.side.mesh_face(file_face);
    intersects[mesh_face] = 1;
    return components.of_face[mesh_face];
  };
  for (const IntersectingPair& pair : pairs) {
    const Index a = meet(pair.face_a);
    const Index b = meet(pair.face_b);
    ++analysis.components[a].intersecting_pairs;
    analysis.components[b].intersecting_pairs += a == b ? 0 : 1;
    analysis.characteristics.unwelded_pairs += pair.kind == ContactKind::Unwelded ? 1 : 0;
  }
  analysis.characteristics.intersecting_pairs = pairs.size();
  analysis.characteristics.intersecting_faces =
      static_cast<std::size_t>(std::count(intersects.begin(), intersects.end(), 1));
}

}  // namespace

Analysis analyze(Soup soup, std::string path, const AnalysisOptions& options) {
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

  phase("integrity");
  analysis.integrity = check_integrity(soup, analysis.offenders);
  phase("half-edges");
  const CutMesh cut = build(soup);
  phase("topology");
  const ComplexTopology topology = analyze_topology(cut, analysis.offenders);
  analysis.components = analyze_components(topology.counts);
  count_elements(soup, topology, analysis);
  keep_what_reports_need(std::exchange(soup, {}), options.keep_soup, analysis);

  box_components(cut, topology.components, analysis);
  if (everything) {
    phase("measures");
    measure(cut, topology.components, options, analysis);
  }
  if (everything && options.curvature) {
    phase("curvature");
    analysis.curvature = curvature_statistics(cut, *options.curvature);
  }
  phase("face tree");
  const FaceTree tree(cut);
  phase("self-intersection");
  // Whether components cross matters also to which encloses which, and so to the attributes.
  const bool wants_pairs = everything || options.judge_fitness;
  std::vector<IntersectingPair> pairs;
  if (wants_pairs || topology.components.count > 1) {
    pairs = find_self_intersections(cut, tree);
  }
  phase("solids");
  analyze_solids({.cut = cut, .tree = tree, .components = topology.components, .pairs = pairs},
                 analysis.components);
  if (wants_pairs) {
    count_pairs(cut, topology.components, pairs, analysis);
  }
  if (everything) {
    analysis.offenders.intersecting_pairs = std::move(pairs);
  }
  analysis.attributes = answer_attributes(analysis, topology.orientable);
  analysis.characteristics.volume = total_volume(analysis);
  answer_genus(analysis);
  if (wants_pairs) {
    analysis.fitness = judge_fitness(analysis);
  }
  if (options.goodness) {
    analysis.goodness = judge(analysis, *options.goodness);
  }
  return analysis;
}

}  // namespace meshalyzer
