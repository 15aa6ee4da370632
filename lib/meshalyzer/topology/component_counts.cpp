#include "meshalyzer/topology/component_counts.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Adds each finding on the mesh to the counts of its component.
class Counter {
 public:
  Counter(const CutMesh& cut, const ComponentCountsInput& input)
      : cut_(cut), input_(input), counts_(input.components.count) {}

  void add_faces() {
    for (const FaceHandle f : cut_.mesh.all_faces()) {
      ComponentCounts& counts = at(f);
      if (counts.faces++ == 0) counts.first_face = cut_.side.face(f);
    }
  }

  /// Copies are skipped: a file vertex that faces use is never isolated itself.
  void add_vertices() {
    for (std::size_t v = 0; v < cut_.side.n_file_vertices; ++v) {
      const VertexHandle vertex(static_cast<int>(v));
      if (!cut_.mesh.is_isolated(vertex)) ++at(vertex).vertices;
    }
    for (const Index v : cut_.side.non_manifold_vertices) {
      ++at(VertexHandle(static_cast<int>(v))).non_manifold_vertices;
    }
  }

  void add_edges() {
    if (counts_.size() == 1) {
      counts_.front().edges = static_cast<Index>(cut_.mesh.n_edges());
    } else {
      for (const EdgeHandle e : cut_.mesh.all_edges()) ++at(cut_.mesh.halfedge_handle(e, 0)).edges;
    }
    add_cuts(cut_.side.flipped_edges, &ComponentCounts::flipped_edges);
    add_cuts(cut_.side.non_manifold_edges, &ComponentCounts::non_manifold_edges);
  }

  void add_boundaries() {
    for (const BoundaryLoop& boundary : input_.boundaries) {
      ComponentCounts& counts = at(boundary.halfedges.front());
      ++counts.boundaries;
      counts.border_edges += static_cast<Index>(boundary.halfedges.size());
    }
  }

  void add_edge_components() {
    // Edge components are numbered by their lowest face: each new number is one more of them.
    const Components& parts = input_.edge_components;
    std::size_t n_met = 0;
    for (const FaceHandle f : cut_.mesh.all_faces()) {
      const Index part = parts.of_face[static_cast<std::size_t>(f.idx())];
      if (part != n_met) continue;
      ComponentCounts& counts = at(f);
      ++counts.edge_components;
      counts.orientable = counts.orientable && input_.orientability.of_component[part] != 0;
      ++n_met;
    }
  }

  [[nodiscard]] std::vector<ComponentCounts> take() { return std::move(counts_); }

 private:
  ComponentCounts& at(FaceHandle f) {
    return counts_[input_.components.of_face[static_cast<std::size_t>(f.idx())]];
  }
  ComponentCounts& at(HalfedgeHandle h) {
    const FaceHandle f = cut_.mesh.face_handle(h);
    return at(f.is_valid() ? f : cut_.mesh.opposite_face_handle(h));
  }
  ComponentCounts& at(VertexHandle v) { return at(cut_.mesh.halfedge_handle(v)); }

  /// Counts the edges of a list, and subtracts the mesh edges that cutting added.
  void add_cuts(const CutEdges& edges, Index ComponentCounts::*count) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto halfedges = edges[i].halfedges;
      ComponentCounts& counts = at(halfedges[0]);
      ++(counts.*count);
      counts.edges -= static_cast<Index>(halfedges.size() - 1);
    }
  }

  const CutMesh& cut_;
  const ComponentCountsInput& input_;
  std::vector<ComponentCounts> counts_;
};

}  // namespace

std::vector<ComponentCounts> count_by_component(const CutMesh& cut,
                                                const ComponentCountsInput& input) {
  Counter counter(cut, input);
  counter.add_faces();
  counter.add_vertices();
  counter.add_edges();
  counter.add_boundaries();
  counter.add_edge_components();
  return counter.take();
}

}  // namespace meshalyzer
