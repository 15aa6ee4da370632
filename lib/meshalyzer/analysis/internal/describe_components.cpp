#include "meshalyzer/analysis/internal/describe_components.h"

#include "meshalyzer/topology/genus.h"

namespace meshalyzer {
namespace {

/// Copies the counts, and answers what they determine: closed, manifold, orientable, consistent,
/// genus.
void describe_topology(const ComponentCounts& counts, ComponentAnalysis& component) {
  component.first_face = counts.first_face;
  component.faces = counts.faces;
  component.vertices = counts.vertices;
  component.edges = counts.edges;
  component.edge_components = counts.edge_components;
  component.boundaries = counts.boundaries;
  component.border_edges = counts.border_edges;
  component.non_manifold_edges = counts.non_manifold_edges;
  component.non_manifold_vertices = counts.non_manifold_vertices;
  component.flipped_edges = counts.flipped_edges;
  component.closed = counts.border_edges == 0;
  component.manifold = counts.non_manifold_edges == 0 && counts.non_manifold_vertices == 0;
  if (component.manifold) {
    component.orientable = counts.orientable;
    component.consistent = counts.flipped_edges == 0;
  }
  if (component.manifold && counts.orientable) {
    component.genus = genus({.vertices = counts.vertices,
                             .edges = counts.edges,
                             .faces = counts.faces,
                             .boundaries = counts.boundaries});
  }
}

/// Sets whether a component points outward, its volume, and which component directly encloses it. A
/// component that encloses no volume points nowhere; one whose volume is too large for a double has
/// no volume.
void describe_shell(const Shell& shell, ComponentAnalysis& component) {
  component.volume = shell.volume;
  component.outward = shell.outward;
  if (shell.inside != kNoIndex) component.inside = shell.inside;
}

}  // namespace

std::vector<ComponentAnalysis> describe_components(const ComponentFindings& found) {
  std::vector<ComponentAnalysis> components(found.counts.size());
  for (std::size_t c = 0; c < components.size(); ++c) {
    ComponentAnalysis& component = components[c];
    describe_topology(found.counts[c], component);
    component.bounding_box = found.boxes[c];
    if (!found.measures.area.empty()) {
      component.area = found.measures.area[c];
      component.zero_area_faces = found.measures.zero_area_faces[c];
    }
    if (!found.intersecting_pairs.empty()) {
      component.intersecting_pairs = found.intersecting_pairs[c];
    }
    describe_shell(found.shells[c], component);
  }
  return components;
}

}  // namespace meshalyzer
