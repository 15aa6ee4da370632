#include "meshalyzer/repair/cut/internal/cut_topology.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/cut/internal/face_edges.h"

namespace meshalyzer {

SurfaceTopology topology_of(std::span<const Triangle> faces) {
  SurfaceTopology topology;
  std::vector<Index> vertices;
  for (const Triangle& t : faces) vertices.insert(vertices.end(), t.begin(), t.end());
  sort_unique(vertices);
  const std::vector<FaceEdge> edges = sorted_edges(faces);
  DisjointSets connected(faces.size());
  std::size_t n_edges = 0;
  for_each_run(std::span(edges), &FaceEdge::ends, [&](std::span<const FaceEdge> edge) {
    for (const FaceEdge& side : edge) connected.unite(edge[0].face, side.face);
    ++n_edges;
    topology.is_manifold = topology.is_manifold && edge.size() <= 2;
  });
  topology.components = connected.number_all().count;
  topology.euler_characteristic = static_cast<std::ptrdiff_t>(vertices.size()) -
                                  static_cast<std::ptrdiff_t>(n_edges) +
                                  static_cast<std::ptrdiff_t>(faces.size());
  return topology;
}

std::vector<std::uint8_t> faces_replaced_alike(const Soup& soup, const Edits& edits) {
  std::vector<std::vector<Triangle>> removed(edits.n_operations);
  std::vector<std::vector<Triangle>> added(edits.n_operations);
  for (const auto& [op, face] : edits.removed_faces) removed[op].push_back(soup.triangles[face]);
  for (const Edits::AddedFace& face : edits.added_faces) added[face.op].push_back(face.corners);
  std::vector<std::uint8_t> is_alike(edits.n_operations);
  for (std::size_t op = 0; op < edits.n_operations; ++op) {
    is_alike[op] = topology_of(removed[op]) == topology_of(added[op]) ? 1 : 0;
  }
  std::vector<std::uint8_t> result(soup.n_faces(), 0);
  for (const auto& [op, face] : edits.removed_faces) result[face] = is_alike[op];
  return result;
}

}  // namespace meshalyzer
