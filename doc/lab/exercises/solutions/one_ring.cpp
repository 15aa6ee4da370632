#include "one_ring.h"

#include <algorithm>

namespace lab {
namespace {

HalfedgeHandle turn_counter_clockwise(const TriMesh& mesh, HalfedgeHandle h) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}

}  // namespace

std::vector<HalfedgeHandle> outgoing_halfedges(const TriMesh& mesh, VertexHandle vertex) {
  std::vector<HalfedgeHandle> ring;
  const HalfedgeHandle first = mesh.halfedge_handle(vertex);
  if (!first.is_valid()) return ring;
  HalfedgeHandle h = first;
  do {
    ring.push_back(h);
    h = turn_counter_clockwise(mesh, h);
  } while (h != first);
  // The turn hops over a hole too; the ring begins after it.
  const auto border = std::find_if(ring.begin(), ring.end(),
                                   [&](HalfedgeHandle out) { return mesh.is_boundary(out); });
  if (border != ring.end()) std::rotate(ring.begin(), border + 1, ring.end());
  return ring;
}

std::vector<VertexHandle> one_ring_vertices(const TriMesh& mesh, VertexHandle vertex) {
  std::vector<VertexHandle> vertices;
  for (const HalfedgeHandle h : outgoing_halfedges(mesh, vertex)) {
    vertices.push_back(mesh.to_vertex_handle(h));
  }
  return vertices;
}

std::vector<FaceHandle> one_ring_faces(const TriMesh& mesh, VertexHandle vertex) {
  std::vector<FaceHandle> faces;
  for (const HalfedgeHandle h : outgoing_halfedges(mesh, vertex)) {
    if (!mesh.is_boundary(h)) faces.push_back(mesh.face_handle(h));
  }
  return faces;
}

bool is_on_border(const TriMesh& mesh, VertexHandle vertex) {
  return one_ring_faces(mesh, vertex).size() < one_ring_vertices(mesh, vertex).size();
}

}  // namespace lab
