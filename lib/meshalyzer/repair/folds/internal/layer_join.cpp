#include "meshalyzer/repair/folds/internal/layer_join.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the number of faces at an edge that stay; 0 if there is no such edge.
std::size_t n_left_at(const TriMesh& mesh, VertexHandle a, VertexHandle b, const LayerJoin& join) {
  const HalfedgeHandle h = mesh.find_halfedge(a, b);
  if (!h.is_valid()) return 0;
  std::size_t n = 0;
  for (const FaceHandle f :
       std::array<FaceHandle, 2>{mesh.face_handle(h), mesh.opposite_face_handle(h)}) {
    const bool goes = std::any_of(join.layers.begin(), join.layers.end(),
                                  [&](const auto& pair) { return pair[0] == f || pair[1] == f; });
    if (f.is_valid() && !goes) ++n;
  }
  return n;
}

/// Tells whether no edge of the merged vertex would have more than two faces, or become a border.
bool is_manifold_after(const TriMesh& mesh, const LayerJoin& join) {
  const auto neighbours = mesh.vv_range(join.merged);
  return std::all_of(neighbours.begin(), neighbours.end(), [&](VertexHandle v) {
    const std::size_t n =
        n_left_at(mesh, join.merged, v, join) + n_left_at(mesh, join.kept, v, join);
    return n == 0 || n == 2;
  });
}

}  // namespace

std::optional<LayerJoin> join_layers_at(const TriMesh& mesh, HalfedgeHandle crease) {
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(crease);
  LayerJoin join;
  join.kept = mesh.opposite_vh(opposite);
  join.merged = mesh.opposite_vh(crease);
  if (join.kept == join.merged || mesh.find_halfedge(join.kept, join.merged).is_valid()) {
    return std::nullopt;
  }
  for (const HalfedgeHandle h : mesh.voh_range(join.merged)) {
    // The edge of the face that the merged vertex is not on.
    const HalfedgeHandle edge = mesh.next_halfedge_handle(h);
    const HalfedgeHandle beyond = mesh.opposite_halfedge_handle(edge);
    if (mesh.opposite_vh(beyond) == join.kept) {
      join.layers.push_back({mesh.face_handle(beyond), mesh.face_handle(edge)});
    } else {
      join.changed.push_back(mesh.face_handle(edge));
    }
  }
  return is_manifold_after(mesh, join) ? std::optional(std::move(join)) : std::nullopt;
}

}  // namespace meshalyzer
