#include "meshalyzer/spatial/proven_stars.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/one_ring.h"
#include "meshalyzer/spatial/embedded_star.h"

namespace meshalyzer {
namespace {

void exclude_ends(const CutMesh& cut, const CutEdges& edges, std::vector<std::uint8_t>& proven) {
  for (const HalfedgeHandle h : edges.halfedges) {
    proven[cut.side.vertex(cut.mesh.from_vertex_handle(h))] = 0;
    proven[cut.side.vertex(cut.mesh.to_vertex_handle(h))] = 0;
  }
}

/// Marks the file vertices whose faces are one fan of the cut mesh, joined through the same edges
/// as in the file.
std::vector<std::uint8_t> uncut_vertices(const CutMesh& cut) {
  std::vector<std::uint8_t> uncut(cut.side.n_file_vertices, 1);
  for (const Index v : cut.side.copies) {
    uncut[v] = 0;
  }
  exclude_ends(cut, cut.side.non_manifold_edges, uncut);
  exclude_ends(cut, cut.side.flipped_edges, uncut);
  return uncut;
}

/// @param arms  Scratch memory for the arms of a star.
bool is_proven(const TriMesh& mesh, VertexHandle v, std::vector<Arm>& arms) {
  arms.clear();
  bool is_closed = true;
  for (const HalfedgeHandle h : one_ring_halfedges(mesh, v)) {
    arms.emplace_back(mesh.point(v), mesh.point(mesh.to_vertex_handle(h)));
    is_closed = !mesh.is_boundary(h);
  }
  return is_surely_embedded({.arms = arms, .is_closed = is_closed});
}

}  // namespace

std::vector<std::uint8_t> prove_stars(const CutMesh& cut) {
  std::vector<std::uint8_t> proven = uncut_vertices(cut);
  parallel_chunks(proven.size(), [&](Chunk chunk) {
    std::vector<Arm> arms;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (proven[i] != 0) {
        proven[i] =
            static_cast<std::uint8_t>(is_proven(cut.mesh, VertexHandle(static_cast<int>(i)), arms));
      }
    }
  });
  return proven;
}

}  // namespace meshalyzer
