#include "genus.h"

#include <vector>

namespace lab {
namespace {

using meshalyzer::HalfedgeHandle;
using meshalyzer::VertexHandle;

std::size_t index(OpenMesh::BaseHandle handle) {
  return static_cast<std::size_t>(handle.idx());
}

void paint_from(const TriMesh& mesh, VertexHandle first, std::vector<char>& painted) {
  std::vector<VertexHandle> to_visit{first};
  painted[index(first)] = 1;
  while (!to_visit.empty()) {
    const VertexHandle v = to_visit.back();
    to_visit.pop_back();
    for (const VertexHandle neighbour : mesh.vv_range(v)) {
      if (painted[index(neighbour)] != 0) continue;
      painted[index(neighbour)] = 1;
      to_visit.push_back(neighbour);
    }
  }
}

}  // namespace

std::optional<int> genus_of_closed_shell(int n_vertices, int n_edges, int n_faces) {
  const int twice = n_edges + 2 - n_vertices - n_faces;
  if (twice < 0 || twice % 2 != 0) return std::nullopt;
  return twice / 2;
}

int euler_number(const TriMesh& mesh) {
  int n_used = 0;
  for (const VertexHandle v : mesh.vertices()) n_used += mesh.is_isolated(v) ? 0 : 1;
  return n_used - static_cast<int>(mesh.n_edges()) + static_cast<int>(mesh.n_faces());
}

int n_boundaries(const TriMesh& mesh) {
  std::vector<char> seen(mesh.n_halfedges(), 0);
  int count = 0;
  for (const HalfedgeHandle first : mesh.halfedges()) {
    if (!mesh.is_boundary(first) || seen[index(first)] != 0) continue;
    ++count;
    for (HalfedgeHandle h = first; seen[index(h)] == 0; h = mesh.next_halfedge_handle(h)) {
      seen[index(h)] = 1;
    }
  }
  return count;
}

int n_components(const TriMesh& mesh) {
  std::vector<char> painted(mesh.n_vertices(), 0);
  int count = 0;
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_isolated(v) || painted[index(v)] != 0) continue;
    paint_from(mesh, v, painted);
    ++count;
  }
  return count;
}

int genus(const TriMesh& mesh) {
  return (2 * n_components(mesh) - n_boundaries(mesh) - euler_number(mesh)) / 2;
}

}  // namespace lab
