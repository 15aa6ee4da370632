#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include "meshalyzer/base/point_table.h"
#include "meshalyzer/mesh/inner_halfedge.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

bool has_two_equal_corners(const Soup& soup, const WeldEdge& edge) {
  const Vec3& a = soup.positions[edge.from];
  const Vec3& b = soup.positions[edge.to];
  const Vec3& c = soup.positions[edge.third];
  return a == b || b == c || c == a;
}

WeldEdge edge_of(const CutMesh& cut, HalfedgeHandle inner) {
  const auto [from, to] = file_ends(cut, inner);
  const HalfedgeHandle next = cut.mesh.next_halfedge_handle(inner);
  return {.from = from,
          .to = to,
          .third = cut.side.vertex(cut.mesh.to_vertex_handle(next)),
          .face = cut.side.face(cut.mesh.face_handle(inner))};
}

}  // namespace

std::vector<WeldEdge> find_weld_edges(const PreparedMesh& mesh) {
  const CutMesh& cut = mesh.cut();
  const std::vector<EdgeKind> kinds = classify_edges(cut);
  std::vector<WeldEdge> edges;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] != EdgeKind::Border) continue;
    const WeldEdge edge = edge_of(cut, inner_halfedge(cut.mesh, EdgeHandle(static_cast<int>(i))));
    if (!has_two_equal_corners(mesh.soup(), edge)) edges.push_back(edge);
  }
  return edges;
}

std::vector<Index> find_weld_places(std::span<const Vec3> positions,
                                    std::span<const WeldEdge> edges) {
  std::vector<Index> ends;
  ends.reserve(2 * edges.size());
  for (const WeldEdge& edge : edges) ends.insert(ends.end(), {edge.from, edge.to});
  return first_equal_points(positions, ends);
}

ItemsByGroup list_edges_at_places(std::span<const WeldEdge> edges, std::span<const Index> wanted,
                                  std::span<const Index> places) {
  return ItemsByGroup(places.size(), [&](const auto& use) {
    for (const Index e : wanted) {
      for (const Index v : {edges[e].from, edges[e].to}) use(places[v], e);
    }
  });
}

}  // namespace meshalyzer
