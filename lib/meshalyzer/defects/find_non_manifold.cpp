#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/faces_at.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/topology/edges.h"
#include "meshalyzer/topology/manifold.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace meshalyzer {
namespace {

DefectList find_crowded_edges(const PreparedMesh& mesh) {
  const CutMesh& cut = mesh.cut();
  const CutEdges& edges = cut.side.non_manifold_edges;
  DefectList defects;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto halfedges = edges[i].halfedges;
    const auto ends = ascending_file_ends(cut, halfedges[0]);
    Defect defect = make_defect(DefectCode::NonManifold);
    defect.edges = {ends};
    for (const HalfedgeHandle h : halfedges) {
      defect.faces.push_back(cut.side.face(cut.mesh.face_handle(h)));
    }
    defect.positions = {middle_of_edge(mesh.soup(), ends)};
    defect.value = static_cast<double>(halfedges.size());
    defects.push_back(defect);
  }
  return defects;
}

/// Joins the mesh vertices that form one fan of the complex: the mesh is cut where a fan passes
/// flipped edges.
DisjointSets join_through_flipped_edges(const CutMesh& cut) {
  DisjointSets fans(cut.mesh.n_vertices());
  const auto unite = [&](VertexHandle a, VertexHandle b) {
    fans.unite(static_cast<Index>(a.idx()), static_cast<Index>(b.idx()));
  };
  const CutEdges& flipped = cut.side.flipped_edges;
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    const HalfedgeHandle a = flipped[i].halfedges[0];
    const HalfedgeHandle b = flipped[i].halfedges[1];
    unite(cut.mesh.from_vertex_handle(a), cut.mesh.from_vertex_handle(b));
    unite(cut.mesh.to_vertex_handle(a), cut.mesh.to_vertex_handle(b));
  }
  return fans;
}

std::size_t count_sets(DisjointSets& sets, const std::vector<VertexHandle>& vertices) {
  std::vector<Index> names;
  for (const VertexHandle v : vertices) names.push_back(sets.find(static_cast<Index>(v.idx())));
  sort_unique(names);
  return names.size();
}

DefectList find_pinches(const PreparedMesh& mesh) {
  const CutMesh& cut = mesh.cut();
  const std::vector<Index> pinched = find_pinched_vertices(cut);
  if (pinched.empty()) return {};
  DisjointSets fans = join_through_flipped_edges(cut);
  DefectList defects;
  for (const Index v : pinched) {
    Defect defect = make_defect(DefectCode::NonManifold);
    defect.vertices = {v};
    defect.faces = faces_at(cut, v);
    defect.positions = {mesh.soup().positions[v]};
    defect.value = static_cast<double>(count_sets(fans, cut.side.mesh_vertices(v)));
    defects.push_back(defect);
  }
  return defects;
}

Index lowest_vertex(const Defect& defect) {
  return defect.edges.empty() ? defect.vertices[0] : defect.edges[0][0];
}

}  // namespace

DefectList find_non_manifold(const PreparedMesh& mesh) {
  const DefectList edges = find_crowded_edges(mesh);
  const DefectList vertices = find_pinches(mesh);
  DefectList defects;
  std::merge(edges.begin(), edges.end(), vertices.begin(), vertices.end(),
             std::back_inserter(defects),
             [](const Defect& a, const Defect& b) { return lowest_vertex(a) < lowest_vertex(b); });
  return defects;
}

}  // namespace meshalyzer
