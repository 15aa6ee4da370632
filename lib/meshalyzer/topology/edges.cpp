#include "meshalyzer/topology/edges.h"

#include "meshalyzer/base/parallel.h"

namespace meshalyzer {
namespace {

void mark(const CutMesh& cut, const CutEdges& edges, EdgeKind kind, std::vector<EdgeKind>& kinds) {
  for (const HalfedgeHandle h : edges.halfedges) {
    kinds[static_cast<std::size_t>(cut.mesh.edge_handle(h).idx())] = kind;
  }
}

/// Counts the mesh edges that are not the first of their edge of the complex.
std::size_t n_surplus(const CutEdges& edges) {
  return edges.halfedges.size() - edges.size();
}

/// Counts the edges of the cut mesh at one of its vertices.
Index mesh_valence(const TriMesh& mesh, std::size_t v) {
  const HalfedgeHandle first = mesh.halfedge_handle(VertexHandle(static_cast<int>(v)));
  if (!first.is_valid()) return 0;
  Index n = 0;
  HalfedgeHandle h = first;
  do {
    ++n;
    h = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
  } while (h != first);
  return n;
}

void take_off_surplus(const CutMesh& cut, const CutEdges& edges, std::vector<Index>& valences) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto halfedges = edges[i].halfedges;
    const auto surplus = static_cast<Index>(halfedges.size() - 1);
    for (const Index v : file_ends(cut, halfedges[0])) valences[v] -= surplus;
  }
}

}  // namespace

std::vector<EdgeKind> classify_edges(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  std::vector<EdgeKind> kinds(mesh.n_edges(), EdgeKind::Inner);
  for (const EdgeHandle e : mesh.all_edges()) {
    if (mesh.is_boundary(e)) kinds[static_cast<std::size_t>(e.idx())] = EdgeKind::Border;
  }
  mark(cut, cut.side.flipped_edges, EdgeKind::Flipped, kinds);
  mark(cut, cut.side.non_manifold_edges, EdgeKind::NonManifold, kinds);
  return kinds;
}

std::size_t n_edges(const CutMesh& cut) {
  return cut.mesh.n_edges() - n_surplus(cut.side.flipped_edges) -
         n_surplus(cut.side.non_manifold_edges);
}

std::vector<Index> vertex_valences(const CutMesh& cut) {
  const std::size_t n = cut.side.n_file_vertices;
  std::vector<Index> valences(n);
  parallel_chunks(n, [&](Chunk chunk) {
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) valences[v] = mesh_valence(cut.mesh, v);
  });
  for (std::size_t i = 0; i < cut.side.copies.size(); ++i) {
    valences[cut.side.copies[i]] += mesh_valence(cut.mesh, n + i);
  }
  take_off_surplus(cut, cut.side.flipped_edges, valences);
  take_off_surplus(cut, cut.side.non_manifold_edges, valences);
  return valences;
}

std::array<Index, 2> file_ends(const CutMesh& cut, HalfedgeHandle halfedge) {
  return {cut.side.vertex(cut.mesh.from_vertex_handle(halfedge)),
          cut.side.vertex(cut.mesh.to_vertex_handle(halfedge))};
}

std::array<Index, 2> ascending_file_ends(const CutMesh& cut, HalfedgeHandle halfedge) {
  std::array<Index, 2> ends = file_ends(cut, halfedge);
  std::sort(ends.begin(), ends.end());
  return ends;
}

}  // namespace meshalyzer
