#include "meshalyzer/analysis/internal/attributes.h"

#include "meshalyzer/analysis/internal/volume.h"

#include <algorithm>
#include <string_view>

namespace meshalyzer {
namespace {

constexpr const char* kNoFaces = "no faces";
constexpr const char* kNotManifold = "the mesh is not manifold";

Answer yes_or_no(bool value) {
  return {.value = value, .reason = {}};
}

Answer none(std::string_view reason) {
  return {.value = std::nullopt, .reason = std::string(reason)};
}

Answer answer_outward(const Analysis& analysis, const Attributes& attributes) {
  if (const std::string reason = reason_of_no_solid(attributes); !reason.empty()) {
    return none(reason);
  }
  if (analysis.characteristics.is_search_stopped && analysis.components.size() > 1) {
    return none("the search for intersecting pairs ended at its time limit");
  }
  bool outward = true;
  std::size_t undecided = 0;
  for (const ComponentAnalysis& c : analysis.components) {
    undecided += c.outward ? 0 : 1;
    outward = outward && c.outward.value_or(true);
  }
  if (outward && undecided != 0) {
    return none(undecided == 1 && analysis.components.size() == 1
                    ? "it encloses no volume"
                    : "components that enclose no volume: " + std::to_string(undecided));
  }
  return yes_or_no(outward);
}

}  // namespace

void count_records(const Soup& soup, Characteristics& characteristics) {
  characteristics.vertices = soup.n_vertices();
  characteristics.faces = soup.n_faces();
}

void count_elements(const ComplexTopology& topology, Analysis& analysis) {
  Characteristics& c = analysis.characteristics;
  const Offenders& offenders = analysis.offenders;
  c.edges = topology.n_edges;
  c.components = topology.counts.size();
  c.edge_components = topology.n_edge_components;
  c.boundaries = topology.n_boundaries;
  c.border_edges = offenders.border_edges.size();
  c.non_manifold_edges = offenders.non_manifold_edges.size();
  c.non_manifold_vertices = offenders.non_manifold_vertices.size();
  c.pinched_vertices = offenders.pinched_vertices.size();
  c.flipped_edges = offenders.flipped_edges.size();
  c.duplicate_faces = offenders.duplicate_faces.size();
}

Attributes answer_attributes(const Analysis& analysis, bool orientable) {
  Attributes attributes;
  const Characteristics& c = analysis.characteristics;
  if (analysis.components.empty()) {
    const Answer unknown = none(kNoFaces);
    return {unknown, unknown, unknown, unknown, unknown};
  }
  attributes.closed = yes_or_no(c.border_edges == 0);
  attributes.manifold = yes_or_no(c.non_manifold_edges == 0 && c.non_manifold_vertices == 0);
  if (*attributes.manifold.value) {
    attributes.orientable = yes_or_no(orientable);
    attributes.consistent = yes_or_no(c.flipped_edges == 0);
  } else {
    attributes.orientable = none(kNotManifold);
    attributes.consistent = none(kNotManifold);
  }
  attributes.outward = answer_outward(analysis, attributes);
  return attributes;
}

void answer_genus(Analysis& analysis) {
  const std::vector<ComponentAnalysis>& components = analysis.components;
  Characteristics& c = analysis.characteristics;
  const bool all_known =
      std::all_of(components.begin(), components.end(),
                  [](const ComponentAnalysis& each) { return each.genus.has_value(); });
  if (all_known && !components.empty()) {
    c.genus_of_components = 0;
    for (const ComponentAnalysis& each : components) {
      *c.genus_of_components += *each.genus;
    }
  }
  if (components.empty()) {
    c.genus.reason = kNoFaces;
  } else if (!*analysis.attributes.manifold.value) {
    c.genus.reason = kNotManifold;
  } else if (!all_known) {
    c.genus.reason = "the mesh is not orientable";
  } else if (analysis.integrity.orphan_vertices != 0) {
    c.genus.reason = "orphan vertices: " + std::to_string(analysis.integrity.orphan_vertices);
  } else {
    c.genus.value = c.genus_of_components;
  }
}

}  // namespace meshalyzer
