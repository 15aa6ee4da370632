#include "meshalyzer/mesh/validate_mesh.h"

#include <fmt/format.h>

namespace meshalyzer {
namespace {

template <typename Handle>
bool is_in(Handle handle, std::size_t n) {
  return handle.idx() >= 0 && static_cast<std::size_t>(handle.idx()) < n;
}

void check_ranges(const TriMesh& mesh, Complaints& complaints) {
  const std::size_t n_halfedges = mesh.n_halfedges();
  for (const VertexHandle v : mesh.all_vertices()) {
    const HalfedgeHandle out = mesh.halfedge_handle(v);
    if (out.is_valid() && !is_in(out, n_halfedges)) {
      complaints.add(fmt::format("vertex {}: no half-edge {}", v.idx(), out.idx()));
    }
  }
  for (const FaceHandle f : mesh.all_faces()) {
    if (!is_in(mesh.halfedge_handle(f), n_halfedges)) {
      complaints.add(
          fmt::format("face {}: no half-edge {}", f.idx(), mesh.halfedge_handle(f).idx()));
    }
  }
  for (const HalfedgeHandle h : mesh.all_halfedges()) {
    if (!is_in(mesh.next_halfedge_handle(h), n_halfedges) ||
        !is_in(mesh.prev_halfedge_handle(h), n_halfedges)) {
      complaints.add(fmt::format("half-edge {}: its next or previous does not exist", h.idx()));
    }
    if (!is_in(mesh.to_vertex_handle(h), mesh.n_vertices())) {
      complaints.add(
          fmt::format("half-edge {}: no vertex {}", h.idx(), mesh.to_vertex_handle(h).idx()));
    }
    if (mesh.face_handle(h).is_valid() && !is_in(mesh.face_handle(h), mesh.n_faces())) {
      complaints.add(fmt::format("half-edge {}: no face {}", h.idx(), mesh.face_handle(h).idx()));
    }
  }
}

void check_halfedges(const TriMesh& mesh, Complaints& complaints) {
  for (const HalfedgeHandle h : mesh.all_halfedges()) {
    const HalfedgeHandle next = mesh.next_halfedge_handle(h);
    if (mesh.prev_halfedge_handle(next) != h ||
        mesh.next_halfedge_handle(mesh.prev_halfedge_handle(h)) != h) {
      complaints.add(fmt::format("half-edge {}: next and previous are not inverse", h.idx()));
    }
    if (mesh.from_vertex_handle(next) != mesh.to_vertex_handle(h)) {
      complaints.add(fmt::format("half-edge {}: the next one starts at another vertex", h.idx()));
    }
    if (mesh.from_vertex_handle(h) == mesh.to_vertex_handle(h)) {
      complaints.add(fmt::format("half-edge {}: it joins vertex {} to itself", h.idx(),
                                 mesh.to_vertex_handle(h).idx()));
    }
    // Next and previous are inverse, so it follows that every border is a closed loop.
    if (mesh.face_handle(next) != mesh.face_handle(h)) {
      complaints.add(fmt::format("half-edge {}: the next one has another face", h.idx()));
    }
    if (mesh.is_boundary(h) && mesh.is_boundary(mesh.opposite_halfedge_handle(h))) {
      complaints.add(fmt::format("half-edge {}: its edge has no face", h.idx()));
    }
  }
}

void check_faces(const TriMesh& mesh, Complaints& complaints) {
  std::size_t n_inner = 0;
  for (const HalfedgeHandle h : mesh.all_halfedges()) n_inner += mesh.is_boundary(h) ? 0 : 1;
  if (n_inner != 3 * mesh.n_faces()) {
    complaints.add(fmt::format("{} faces have {} half-edges", mesh.n_faces(), n_inner));
  }
  for (const FaceHandle f : mesh.all_faces()) {
    const HalfedgeHandle a = mesh.halfedge_handle(f);
    const HalfedgeHandle b = mesh.next_halfedge_handle(a);
    const HalfedgeHandle c = mesh.next_halfedge_handle(b);
    if (mesh.face_handle(a) != f || a == b || a == c || mesh.next_halfedge_handle(c) != a) {
      complaints.add(fmt::format("face {}: it is not a loop of three half-edges", f.idx()));
    }
  }
}

/// The outgoing half-edges of each vertex, collected from the half-edges themselves.
struct Outgoing {
  std::vector<Index> n;
  std::vector<Index> n_border;
};

Outgoing count_outgoing(const TriMesh& mesh) {
  Outgoing outgoing{std::vector<Index>(mesh.n_vertices(), 0),
                    std::vector<Index>(mesh.n_vertices(), 0)};
  for (const HalfedgeHandle h : mesh.all_halfedges()) {
    const auto v = static_cast<std::size_t>(mesh.from_vertex_handle(h).idx());
    ++outgoing.n[v];
    if (mesh.is_boundary(h)) ++outgoing.n_border[v];
  }
  return outgoing;
}

void check_vertices(const TriMesh& mesh, Complaints& complaints) {
  const Outgoing outgoing = count_outgoing(mesh);
  for (const VertexHandle v : mesh.all_vertices()) {
    const Index n = outgoing.n[static_cast<std::size_t>(v.idx())];
    const Index n_border = outgoing.n_border[static_cast<std::size_t>(v.idx())];
    const HalfedgeHandle first = mesh.halfedge_handle(v);
    if (first.is_valid() != (n != 0)) {
      complaints.add(
          fmt::format("vertex {}: isolated or not, its half-edge says otherwise", v.idx()));
      continue;
    }
    if (n == 0) continue;
    if (mesh.from_vertex_handle(first) != v) {
      complaints.add(fmt::format("vertex {}: its half-edge starts at another vertex", v.idx()));
      continue;
    }
    if (n_border != 0 && !mesh.is_boundary(first)) {
      complaints.add(fmt::format("vertex {}: its half-edge is not the one on the border", v.idx()));
    }
    Index n_turned = 0;
    HalfedgeHandle h = first;
    do {
      ++n_turned;
      h = mesh.cw_rotated_halfedge_handle(h);
    } while (h != first && n_turned <= n);
    if (n_turned != n || n_border > 1) {
      complaints.add(fmt::format("vertex {}: its faces are not one fan", v.idx()));
    }
  }
}

}  // namespace

void validate_mesh(const TriMesh& mesh, Complaints& complaints) {
  check_ranges(mesh, complaints);
  if (!complaints.none()) return;
  check_halfedges(mesh, complaints);
  check_faces(mesh, complaints);
  check_vertices(mesh, complaints);
}

}  // namespace meshalyzer
