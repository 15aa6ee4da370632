#include "meshalyzer/topology/components.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/topology/edges.h"

#include <utility>

namespace meshalyzer {
namespace {

Index index(FaceHandle face) {
  return static_cast<Index>(face.idx());
}

/// Joins the two faces of every edge that has two in the cut mesh.
DisjointSets join_through_inner_edges(const TriMesh& mesh) {
  DisjointSets faces(mesh.n_faces());
  for (const EdgeHandle e : mesh.all_edges()) {
    const FaceHandle a = mesh.face_handle(mesh.halfedge_handle(e, 0));
    const FaceHandle b = mesh.face_handle(mesh.halfedge_handle(e, 1));
    if (a.is_valid() && b.is_valid()) faces.unite(index(a), index(b));
  }
  return faces;
}

void join_through_cuts(const TriMesh& mesh, const CutEdges& edges, DisjointSets& faces) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto halfedges = edges[i].halfedges;
    for (const HalfedgeHandle h : halfedges.subspan(1)) {
      faces.unite(index(mesh.face_handle(halfedges[0])), index(mesh.face_handle(h)));
    }
  }
}

Components number_components(const DisjointSets& faces) {
  DisjointSets::Numbers number = faces.number_all();
  return {number.count, std::move(number.of)};
}

}  // namespace

Components find_components(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  DisjointSets vertices(cut.side.n_file_vertices);
  for (const EdgeHandle e : mesh.all_edges()) {
    const auto [from, to] = file_ends(cut, mesh.halfedge_handle(e, 0));
    vertices.unite(from, to);
  }
  Components components;
  components.of_face.resize(mesh.n_faces());
  std::vector<Index> number(cut.side.n_file_vertices, kNoIndex);
  for (const FaceHandle f : mesh.all_faces()) {
    const VertexHandle corner = mesh.to_vertex_handle(mesh.halfedge_handle(f));
    Index& component = number[vertices.find(cut.side.vertex(corner))];
    if (component == kNoIndex) component = static_cast<Index>(components.count++);
    components.of_face[index(f)] = component;
  }
  return components;
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
