#include "meshalyzer/repair/rules/internal/fixed_vertices.h"

#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"

#include <array>

namespace meshalyzer {
namespace {

void fix_ends(const CutMesh& cut, HalfedgeHandle halfedge, std::vector<std::uint8_t>& fixed) {
  for (const Index v : file_ends(cut, halfedge)) fixed[v] = 1;
}

void fix_borders(const CutMesh& cut, std::vector<std::uint8_t>& fixed) {
  for (const HalfedgeHandle h : find_border_edges(cut)) fix_ends(cut, h, fixed);
}

/// Fixes the ends of edges whose faces are not all of one group.
void fix_common_borders(const Soup& soup, const CutMesh& cut, std::vector<std::uint8_t>& fixed) {
  const auto group = [&](HalfedgeHandle h) {
    return group_of(soup, cut.side.face(cut.mesh.face_handle(h)));
  };
  for (const EdgeHandle edge : cut.mesh.edges()) {
    const HalfedgeHandle h = cut.mesh.halfedge_handle(edge, 0);
    const HalfedgeHandle g = cut.mesh.opposite_halfedge_handle(h);
    if (cut.mesh.is_boundary(h) || cut.mesh.is_boundary(g)) continue;
    if (group(h) != group(g)) fix_ends(cut, h, fixed);
  }
  for (const CutEdges* edges : {&cut.side.flipped_edges, &cut.side.non_manifold_edges}) {
    for (std::size_t i = 0; i < edges->size(); ++i) {
      const auto halfedges = (*edges)[i].halfedges;
      for (const HalfedgeHandle h : halfedges) {
        if (group(h) != group(halfedges.front())) fix_ends(cut, h, fixed);
      }
    }
  }
}

}  // namespace

std::vector<std::uint8_t> find_fixed_vertices(const TrackedMesh& tracked, const CutMesh& cut,
                                              const RepairOptions& options) {
  const Soup& soup = tracked.soup;
  const bool has_faces = options.groups == Groups::Faces && !soup.groups.empty();
  if (options.borders != Borders::Intended && !has_faces) return {};
  std::vector<std::uint8_t> fixed(soup.n_vertices(), 0);
  if (options.borders == Borders::Intended) fix_borders(cut, fixed);
  if (has_faces) fix_common_borders(soup, cut, fixed);
  std::vector<std::uint8_t> by_key(tracked.n_vertex_keys(), 0);
  for (std::size_t v = 0; v < fixed.size(); ++v) by_key[tracked.vertex_keys[v]] = fixed[v];
  return by_key;
}

}  // namespace meshalyzer
