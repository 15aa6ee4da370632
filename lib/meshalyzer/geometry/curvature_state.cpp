#include "meshalyzer/geometry/curvature_state.h"

#include "meshalyzer/base/parallel.h"

namespace meshalyzer {
namespace {

VertexHandle handle(std::size_t v) {
  return VertexHandle(static_cast<int>(v));
}

/// The file's vertices at the two ends of an edge.
std::array<Index, 2> ends(const CutMesh& cut, HalfedgeHandle h) {
  return {cut.side.vertex(cut.mesh.from_vertex_handle(h)),
          cut.side.vertex(cut.mesh.to_vertex_handle(h))};
}

void take_off_surplus(const CutMesh& cut, const CutEdges& edges, std::vector<int>& beyond) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto halfedges = edges[i].halfedges;
    for (const Index v : ends(cut, halfedges[0])) {
      beyond[v] -= static_cast<int>(halfedges.size()) - 1;
    }
  }
}

}  // namespace

std::vector<CurvatureState> curvature_states(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  std::vector<CurvatureState> states(cut.side.n_file_vertices, CurvatureState::Defined);
  parallel_chunks(states.size(), [&](Chunk chunk) {
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      if (mesh.is_isolated(handle(v))) {
        states[v] = CurvatureState::Unused;
      } else if (mesh.is_boundary(handle(v))) {
        states[v] = CurvatureState::Border;
      }
    }
  });
  for (const Index v : cut.side.non_manifold_vertices) {
    states[v] = CurvatureState::NotOneFan;
  }
  for (std::size_t i = 0; i < cut.side.flipped_edges.size(); ++i) {
    for (const Index v : ends(cut, cut.side.flipped_edges[i].halfedges[0])) {
      states[v] = CurvatureState::NotOneFan;
    }
  }
  return states;
}

std::vector<int> edges_beyond_faces(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  std::vector<int> beyond(cut.side.n_file_vertices, 0);
  const auto is_open = [&](std::size_t v) {
    return !mesh.is_isolated(handle(v)) && mesh.is_boundary(handle(v));
  };
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    if (is_open(v)) ++beyond[cut.side.vertex(handle(v))];
  }
  take_off_surplus(cut, cut.side.flipped_edges, beyond);
  take_off_surplus(cut, cut.side.non_manifold_edges, beyond);
  return beyond;
}

}  // namespace meshalyzer
