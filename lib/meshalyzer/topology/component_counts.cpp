#include "meshalyzer/topology/component_counts.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/tally.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Adds each finding on the mesh to the counts of its component.
class Counter {
 public:
  Counter(const CutMesh& cut, const ComponentCountsInput& input)
      : cut_(cut), input_(input), counts_(input.components.count) {}

  void add_faces() {
    add_all(cut_.mesh.n_faces(), &ComponentCounts::faces,
            [&](std::size_t i) { return component_of(FaceHandle(static_cast<int>(i))); });
  }

  /// Copies are skipped: a file vertex that faces use is never isolated itself.
  void add_vertices() {
    add_all(cut_.side.n_file_vertices, &ComponentCounts::vertices, [&](std::size_t i) {
      const VertexHandle v(static_cast<int>(i));
      return cut_.mesh.is_isolated(v) ? kNoIndex : component_of(v);
    });
    for (const Index v : cut_.side.non_manifold_vertices) {
      ++at(VertexHandle(static_cast<int>(v))).non_manifold_vertices;
    }
  }

  void add_edges() {
    add_all(cut_.mesh.n_edges(), &ComponentCounts::edges, [&](std::size_t i) {
      return component_of(cut_.mesh.halfedge_handle(EdgeHandle(static_cast<int>(i)), 0));
    });
    add_cuts(cut_.side.flipped_edges, &ComponentCounts::flipped_edges);
    add_cuts(cut_.side.non_manifold_edges, &ComponentCounts::non_manifold_edges);
  }

  void add_boundaries() {
    for (std::size_t i = 0; i < input_.boundaries.size(); ++i) {
      const BoundaryLoop boundary = input_.boundaries[i];
      ComponentCounts& counts = at(boundary.halfedges.front());
      ++counts.boundaries;
      counts.border_edges += static_cast<Index>(boundary.halfedges.size());
    }
  }

  /// Components and edge components are numbered by their lowest faces: each new number is one more
  /// of them.
  void add_edge_components() {
    const Components& parts = input_.edge_components;
    std::size_t n_components_met = 0;
    std::size_t n_parts_met = 0;
    for (std::size_t i = 0; n_parts_met < parts.count; ++i) {
      const Index part = parts.of_face[i];
      if (part != n_parts_met) continue;
      const FaceHandle f(static_cast<int>(i));
      const Index component = component_of(f);
      ComponentCounts& counts = counts_[component];
      if (component == n_components_met) {
        counts.first_face = cut_.side.face(f);
        ++n_components_met;
      }
      ++counts.edge_components;
      counts.orientable = counts.orientable && input_.orientability.of_component[part] != 0;
      ++n_parts_met;
    }
  }

  [[nodiscard]] std::vector<ComponentCounts> take() { return std::move(counts_); }

 private:
  [[nodiscard]] Index component_of(FaceHandle f) const { return input_.components.of(f); }
  [[nodiscard]] Index component_of(HalfedgeHandle h) const {
    return input_.components.of(cut_.mesh, h);
  }
  [[nodiscard]] Index component_of(VertexHandle v) const {
    return component_of(cut_.mesh.halfedge_handle(v));
  }
  template <typename Handle>
  ComponentCounts& at(Handle handle) {
    return counts_[component_of(handle)];
  }

  /// Counts elements by component, in parallel. No component, kNoIndex, is not counted.
  template <typename ComponentOf>
  void add_all(std::size_t n, Index ComponentCounts::*count, ComponentOf&& component) {
    parallel_chunks(n, [&](Chunk chunk) {
      Tally tally([&](Index c) -> Index& { return counts_[c].*count; });
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        if (const Index c = component(i); c != kNoIndex) tally.add(c);
      }
    });
  }

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
