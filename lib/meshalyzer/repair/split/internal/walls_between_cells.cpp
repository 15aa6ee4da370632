#include "meshalyzer/repair/split/internal/walls_between_cells.h"

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/exact_volume.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// An edge of a triangle, as its two vertices, the lower one first, and the triangle.
struct TriangleEdge {
  std::array<Index, 2> ends{};
  Index triangle = 0;
};

/// Returns the edges of some triangles, ascending by their ends.
std::vector<TriangleEdge> edges_of(std::span<const Triangle> triangles) {
  std::vector<TriangleEdge> edges;
  for (Index t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      edges.push_back({.ends = {low, high}, .triangle = t});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const TriangleEdge& a, const TriangleEdge& b) {
    return std::pair(a.ends, a.triangle) < std::pair(b.ends, b.triangle);
  });
  return edges;
}

/// Returns a face of each edge with an odd number of faces above two.
std::vector<FaceHandle> faces_at_odd_edges(const CutMesh& cut) {
  std::vector<FaceHandle> faces;
  const CutEdges& edges = cut.side.non_manifold_edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto halfedges = edges[i].halfedges;
    if (halfedges.size() % 2 != 0) faces.push_back(cut.mesh.face_handle(halfedges[0]));
  }
  return faces;
}

/// The faces of the components of some faces, without those in which faces intersect or have no
/// area, ascending.
std::vector<Index> faces_that_may_have_walls(const PreparedMesh& mesh,
                                             std::span<const FaceHandle> at_odd_edges) {
  const Soup& soup = mesh.soup();
  const Components components = find_edge_components(mesh.cut());
  const std::vector<Index> component_of =
      components_of_file_faces(mesh.cut(), components, soup.n_faces());
  std::vector<std::uint8_t> is_candidate(components.count, 0);
  for (const FaceHandle face : at_odd_edges) is_candidate[components.of(face)] = 1;
  const auto is_in_candidate = [&](Index face) {
    return component_of[face] != kNoIndex && is_candidate[component_of[face]] != 0;
  };
  std::vector<Index> faces;
  for (Index face = 0; face < soup.n_faces(); ++face) {
    if (!is_in_candidate(face)) continue;
    if (are_collinear(corners_of(soup, face))) is_candidate[component_of[face]] = 0;
    faces.push_back(face);
  }
  std::erase_if(faces, [&](Index face) { return !is_in_candidate(face); });
  if (faces.empty()) return faces;
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    is_candidate[component_of[pair.face_a]] = 0;
    is_candidate[component_of[pair.face_b]] = 0;
  }
  if (mesh.was_intersection_search_cut()) return {};
  std::erase_if(faces, [&](Index face) { return !is_in_candidate(face); });
  return faces;
}

/// Finds the walls of components in which no faces intersect or have no area.
class WallFinderInCells {
 public:
  /// @param part  The triangles of these components.
  WallFinderInCells(const Soup& part, const Cells& cells)
      : part_(part), edges_(edges_of(part.triangles)), joined_(cells.count), cells_(cells) {
    // Space goes on round a border.
    for_each_edge([&](std::span<const TriangleEdge> edge) {
      if (edge.size() == 1) join_sides(edge.front().triangle);
    });
    is_enclosed_ = which_are_enclosed();
  }

  /// Returns walls and others by triangle.
  [[nodiscard]] WallsBetweenCells find() {
    WallsBetweenCells found{.sets = sets_of_walls(), .inward = {}};
    for (Index t = 0; t < part_.n_faces(); ++t) {
      if (is_enclosed_[front(t)] != 0 && is_enclosed_[behind(t)] == 0) found.inward.push_back(t);
    }
    return found;
  }

 private:
  [[nodiscard]] std::vector<std::vector<Index>> sets_of_walls() {
    DisjointSets together(part_.n_faces());
    std::vector<Index> at_odd_edges;
    for_each_edge([&](std::span<const TriangleEdge> edge) {
      Index first = kNoIndex;
      std::size_t n_between_cells = 0;
      for (const TriangleEdge& use : edge) {
        if (front(use.triangle) != behind(use.triangle)) ++n_between_cells;
        if (!is_wall(use.triangle)) continue;
        if (first == kNoIndex) first = use.triangle;
        together.unite(first, use.triangle);
      }
      if (first != kNoIndex && n_between_cells % 2 != 0) at_odd_edges.push_back(first);
    });
    for (Index& triangle : at_odd_edges) triangle = together.find(triangle);
    sort_unique(at_odd_edges);
    std::vector<std::vector<Index>> sets(at_odd_edges.size());
    for (Index t = 0; t < part_.n_faces(); ++t) {
      const auto set = std::lower_bound(at_odd_edges.begin(), at_odd_edges.end(), together.find(t));
      if (set == at_odd_edges.end() || *set != together.find(t)) continue;
      sets[static_cast<std::size_t>(set - at_odd_edges.begin())].push_back(t);
    }
    return sets;
  }

  /// Tells whether there are different enclosed cells on the two sides.
  [[nodiscard]] bool is_wall(Index triangle) {
    return front(triangle) != behind(triangle) && is_enclosed_[front(triangle)] != 0 &&
           is_enclosed_[behind(triangle)] != 0;
  }
  [[nodiscard]] Index front(Index triangle) { return joined_.find(cells_.front(triangle)); }
  [[nodiscard]] Index behind(Index triangle) { return joined_.find(cells_.behind(triangle)); }
  void join_sides(Index triangle) {
    joined_.unite(cells_.front(triangle), cells_.behind(triangle));
  }

  template <typename Body>
  void for_each_edge(const Body& body) const {
    for_each_run(std::span(edges_), &TriangleEdge::ends, body);
  }

  /// #cells, by those that are joined: 1 for those with a positive volume.
  [[nodiscard]] std::vector<std::uint8_t> which_are_enclosed() {
    std::vector<ExactVolume> volumes(cells_.count);
    for (Index t = 0; t < part_.n_faces(); ++t) {
      if (front(t) == behind(t)) continue;
      const auto [a, b, c] = corners_of(part_, t);
      volumes[behind(t)].add(a, b, c);
      volumes[front(t)].add(a, c, b);
    }
    std::vector<std::uint8_t> is_enclosed;
    for (const ExactVolume& volume : volumes) is_enclosed.push_back(volume.sign() > 0 ? 1 : 0);
    return is_enclosed;
  }

  const Soup& part_;
  std::vector<TriangleEdge> edges_;
  DisjointSets joined_;
  const Cells& cells_;
  /// #cells: see which_are_enclosed().
  std::vector<std::uint8_t> is_enclosed_;
};

}  // namespace

WallsBetweenCells find_walls_between_cells(const PreparedMesh& mesh,
                                           const StopQuery& wants_to_stop) {
  const std::vector<FaceHandle> at_odd_edges = faces_at_odd_edges(mesh.cut());
  if (at_odd_edges.empty()) return {};
  const std::vector<Index> faces = faces_that_may_have_walls(mesh, at_odd_edges);
  if (faces.empty()) return {};
  std::vector<Triangle> triangles;
  for (const Index face : faces) triangles.push_back(mesh.soup().triangles[face]);
  const Soup part = compact_soup(mesh.soup().positions, std::move(triangles));
  const std::optional<Arrangement> uncut =
      arrange_within(part, {}, {.wants_to_stop = wants_to_stop});
  if (!uncut || wants_to_stop()) return {};
  const Cells cells = find_cells(part, *uncut);
  WallsBetweenCells found = WallFinderInCells(part, cells).find();
  for (std::vector<Index>& set : found.sets) {
    for (Index& triangle : set) triangle = faces[triangle];
  }
  for (Index& triangle : found.inward) triangle = faces[triangle];
  return found;
}

}  // namespace meshalyzer
