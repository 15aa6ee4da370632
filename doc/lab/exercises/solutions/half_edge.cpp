#include "half_edge.h"

#include <map>
#include <stdexcept>
#include <utility>

namespace lab {

HalfEdgeMesh link_faces(int n_vertices, const std::vector<std::array<int, 3>>& faces) {
  HalfEdgeMesh mesh;
  mesh.vertex_halfedge.assign(static_cast<std::size_t>(n_vertices), kNone);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int first = static_cast<int>(3 * f);
    for (int k = 0; k < 3; ++k) {
      HalfEdge h;
      h.vertex = faces[f][static_cast<std::size_t>(k)];
      h.face = static_cast<int>(f);
      h.next = first + (k + 1) % 3;
      h.prev = first + (k + 2) % 3;
      mesh.vertex_halfedge[static_cast<std::size_t>(h.vertex)] = first + k;
      mesh.halfedges.push_back(h);
    }
  }
  return mesh;
}

void link_pairs(HalfEdgeMesh& mesh) {
  const auto start = [&](int h) { return mesh.halfedges[static_cast<std::size_t>(h)].vertex; };
  std::map<std::pair<int, int>, int> by_ends;
  for (int h = 0; h < static_cast<int>(mesh.halfedges.size()); ++h) {
    const int next = mesh.halfedges[static_cast<std::size_t>(h)].next;
    if (!by_ends.emplace(std::pair(start(h), start(next)), h).second) {
      throw std::invalid_argument("two half-edges run the same way between the same vertices");
    }
  }
  for (const auto& [ends, h] : by_ends) {
    const auto other = by_ends.find({ends.second, ends.first});
    if (other != by_ends.end()) mesh.halfedges[static_cast<std::size_t>(h)].pair = other->second;
  }
}

void link_borders(HalfEdgeMesh& mesh) {
  const std::size_t n_inner = mesh.halfedges.size();
  std::map<int, int> border_from;
  for (std::size_t h = 0; h < n_inner; ++h) {
    if (mesh.halfedges[h].pair != kNone) continue;
    HalfEdge border;
    border.vertex = mesh.halfedges[static_cast<std::size_t>(mesh.halfedges[h].next)].vertex;
    border.pair = static_cast<int>(h);
    mesh.halfedges[h].pair = static_cast<int>(mesh.halfedges.size());
    border_from[border.vertex] = mesh.halfedges[h].pair;
    mesh.halfedges.push_back(border);
  }
  for (std::size_t b = n_inner; b < mesh.halfedges.size(); ++b) {
    const int end = mesh.halfedges[static_cast<std::size_t>(mesh.halfedges[b].pair)].vertex;
    mesh.halfedges[b].next = border_from.at(end);
    mesh.halfedges[static_cast<std::size_t>(border_from.at(end))].prev = static_cast<int>(b);
  }
}

}  // namespace lab
