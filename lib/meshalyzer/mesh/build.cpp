#include "meshalyzer/mesh/build.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/corners.h"
#include "meshalyzer/mesh/edge_pairs.h"
#include "meshalyzer/mesh/fans.h"
#include "meshalyzer/mesh/link.h"
#include "meshalyzer/mesh/require_records.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::size_t kMaxVertices = std::size_t{1} << 31U;
constexpr std::size_t kMaxFaces = std::size_t{1} << 30U;

/// Returns a side table that holds nothing yet but which faces the mesh will hold.
SideTable sort_out_faces(const Soup& soup) {
  const auto is_kept = [&](Index face) { return is_in_complex(soup.triangles[face]); };
  SideTable side;
  side.n_file_vertices = soup.n_vertices();
  side.faces = parallel_filter(soup.n_faces(), is_kept);
  if (side.faces.size() < soup.n_faces()) {
    side.rejected_faces = parallel_filter(soup.n_faces(), std::not_fn(is_kept));
  }
  return side;
}

CutEdges cut_edges(CornerLists sides, const EdgeNumbers& edges) {
  CutEdges cut;
  cut.begin = std::move(sides.begin);
  cut.halfedges.reserve(sides.corners.size());
  for (const Index side : sides.corners) {
    cut.halfedges.emplace_back(static_cast<int>(edges.halfedge[side]));
  }
  return cut;
}

}  // namespace

CutMesh build(const Soup& soup) {
  if (soup.n_vertices() > kMaxVertices) throw InvalidArgument("build: more than 2^31 vertices");
  require_records(soup);
  SideTable side = sort_out_faces(soup);
  if (side.faces.size() > kMaxFaces) throw InvalidArgument("build: more than 2^30 faces");

  const Complex complex{
      .n_vertices = soup.n_vertices(), .triangles = soup.triangles, .faces = side.faces};
  EdgePairs pairs = pair_edges(complex);
  Fans fans = find_fans(complex, pairs);
  const EdgeNumbers edges = number_edges(std::move(pairs.opposite));
  side.non_manifold_edges = cut_edges(std::move(pairs.non_manifold), edges);
  side.flipped_edges = cut_edges(std::move(pairs.flipped), edges);
  side.non_manifold_vertices = std::move(fans.non_manifold_vertices);
  side.copies = fans.copies;
  // The mesh is constructed in place: OpenMesh's meshes have no move constructor, so that a named
  // one would be copied.
  return {link_mesh(complex, soup.positions, edges, fans), std::move(side)};
}

}  // namespace meshalyzer
