#include "meshalyzer/topology/components.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/inner_halfedge.h"
#include "meshalyzer/topology/join_through_cuts.h"

#include <utility>

namespace meshalyzer {
namespace {

Index index(FaceHandle face) {
  return static_cast<Index>(face.idx());
}

/// Returns a face at a vertex that has one.
FaceHandle a_face_at(const TriMesh& mesh, VertexHandle v) {
  return mesh.face_handle(inner_halfedge(mesh, mesh.halfedge_handle(v)));
}

/// Joins the two faces of every edge that has two in the cut mesh.
DisjointSets join_through_inner_edges(const TriMesh& mesh) {
  DisjointSets faces(mesh.n_faces());
  parallel_chunks(mesh.n_edges(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const EdgeHandle e(static_cast<int>(i));
      const FaceHandle a = mesh.face_handle(mesh.halfedge_handle(e, 0));
      const FaceHandle b = mesh.face_handle(mesh.halfedge_handle(e, 1));
      if (a.is_valid() && b.is_valid()) faces.unite(index(a), index(b));
    }
  });
  return faces;
}

/// Joins the fans of each file vertex that has several.
void join_through_copies(const CutMesh& cut, DisjointSets& faces) {
  const auto n_file_vertices = static_cast<int>(cut.side.n_file_vertices);
  for (std::size_t i = 0; i < cut.side.copies.size(); ++i) {
    const VertexHandle copy(n_file_vertices + static_cast<int>(i));
    const VertexHandle first(static_cast<int>(cut.side.copies[i]));
    faces.unite(index(a_face_at(cut.mesh, first)), index(a_face_at(cut.mesh, copy)));
  }
}

Components number_components(const DisjointSets& faces) {
  DisjointSets::Numbers number = faces.number_all();
  return {number.count, std::move(number.of)};
}

}  // namespace

Components find_components(const CutMesh& cut) {
  DisjointSets faces = join_through_inner_edges(cut.mesh);
  join_through_copies(cut, faces);
  return number_components(faces);
}

Components find_edge_components(const CutMesh& cut) {
  DisjointSets faces = join_through_inner_edges(cut.mesh);
  join_through_cuts(cut.mesh, cut.side.flipped_edges, faces);
  join_through_cuts(cut.mesh, cut.side.non_manifold_edges, faces);
  return number_components(faces);
}

Components find_oriented_regions(const CutMesh& cut) {
  return number_components(join_through_inner_edges(cut.mesh));
}

std::vector<Index> components_of_file_faces(const CutMesh& cut, const Components& components,
                                            std::size_t n_file_faces) {
  std::vector<Index> component_of(n_file_faces, kNoIndex);
  for (std::size_t f = 0; f < components.of_face.size(); ++f) {
    component_of[cut.side.faces[f]] = components.of_face[f];
  }
  return component_of;
}

}  // namespace meshalyzer
