#include "meshalyzer/repair/split/internal/walls_between_cells.h"

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/exact_volume.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/split/internal/edge_incidences.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace meshalyzer {
namespace {

/// A side of a triangle, as its two vertices, the lower one first, and the triangle.
struct WallSide {
  std::array<Index, 2> ends{};
  Index triangle = 0;
};

class WallsBetweenCells {
 public:
  WallsBetweenCells(const PreparedMesh& mesh, const EdgeIncidences& incidences)
      : mesh_(mesh), incidences_(incidences) {}

  [[nodiscard]] std::vector<std::vector<Index>> find() {
    faces_ = faces_of_sound_components();
    if (faces_.empty()) return {};
    Soup part;
    part.positions = mesh_.soup().positions;
    for (const Index face : faces_) part.triangles.push_back(mesh_.soup().triangles[face]);
    const Cells cells = find_cells(part, arrange(part, {}));
    return sets_of(part.triangles, find_walls(part, cells));
  }

 private:
  [[nodiscard]] bool is_odd(std::size_t edge) const { return incidences_.n_faces(edge) % 2 != 0; }

  /// Returns the faces of the components with odd edges in which no faces intersect or have no
  /// area, ascending.
  [[nodiscard]] std::vector<Index> faces_of_sound_components() const {
    const Soup& soup = mesh_.soup();
    const Components components = find_edge_components(mesh_.cut());
    const std::vector<Index> component_of =
        components_of_file_faces(mesh_.cut(), components, soup.n_faces());
    std::vector<std::uint8_t> is_sound(components.count, 0);
    for (std::size_t edge = 0; edge < incidences_.size(); ++edge) {
      if (is_odd(edge)) is_sound[component_of[incidences_.faces[incidences_.begin[edge]]]] = 1;
    }
    for (const IntersectingPair& pair : mesh_.intersecting_pairs()) {
      is_sound[component_of[pair.face_a]] = 0;
      is_sound[component_of[pair.face_b]] = 0;
    }
    if (mesh_.was_intersection_search_cut()) return {};
    const auto is_in_sound = [&](Index face) {
      return component_of[face] != kNoIndex && is_sound[component_of[face]] != 0;
    };
    std::vector<Index> faces;
    for (Index face = 0; face < soup.n_faces(); ++face) {
      if (!is_in_sound(face)) continue;
      if (are_collinear(corners_of(soup, face))) is_sound[component_of[face]] = 0;
      faces.push_back(face);
    }
    std::erase_if(faces, [&](Index face) { return !is_in_sound(face); });
    return faces;
  }

  /// #triangles: 1 for those with different enclosed cells on their sides.
  [[nodiscard]] std::vector<std::uint8_t> find_walls(const Soup& part, const Cells& cells) const {
    DisjointSets joined = join_at_borders(cells);
    const auto front = [&](Index t) { return joined.find(cells.front(t)); };
    const auto behind = [&](Index t) { return joined.find(cells.behind(t)); };
    std::vector<ExactVolume> volumes(cells.count);
    for (Index t = 0; t < part.n_faces(); ++t) {
      if (front(t) == behind(t)) continue;
      const auto [a, b, c] = corners_of(part, t);
      volumes[behind(t)].add(a, b, c);
      volumes[front(t)].add(a, c, b);
    }
    std::vector<std::uint8_t> is_wall(part.n_faces(), 0);
    for (Index t = 0; t < part.n_faces(); ++t) {
      is_wall[t] =
          front(t) != behind(t) && volumes[front(t)].sign() > 0 && volumes[behind(t)].sign() > 0;
    }
    return is_wall;
  }

  /// Joins the cells on the two sides of each face at a border, because space goes on round it.
  [[nodiscard]] DisjointSets join_at_borders(const Cells& cells) const {
    DisjointSets joined(cells.count);
    const CutMesh& cut = mesh_.cut();
    for (const HalfedgeHandle border : find_border_edges(cut)) {
      const Index face = cut.side.face(cut.mesh.face_handle(border));
      const auto found = std::lower_bound(faces_.begin(), faces_.end(), face);
      if (found == faces_.end() || *found != face) continue;
      const auto triangle = static_cast<Index>(found - faces_.begin());
      joined.unite(cells.front(triangle), cells.behind(triangle));
    }
    return joined;
  }

  /// Returns the sets of walls with an odd edge, as faces.
  [[nodiscard]] std::vector<std::vector<Index>> sets_of(
      std::span<const Triangle> triangles, std::span<const std::uint8_t> is_wall) const {
    const std::vector<WallSide> sides = sides_of(triangles, is_wall);
    DisjointSets together(triangles.size());
    std::vector<Index> with_odd_edge;
    for_each_run(std::span(sides), &WallSide::ends, [&](std::span<const WallSide> edge) {
      for (const WallSide& side : edge) together.unite(edge.front().triangle, side.triangle);
      if (has_odd_edge_at(edge.front().ends)) with_odd_edge.push_back(edge.front().triangle);
    });
    std::vector<Index> number_of(triangles.size(), kNoIndex);
    std::vector<Index> lowest;
    for (const Index t : with_odd_edge) lowest.push_back(together.find(t));
    sort_unique(lowest);
    for (Index i = 0; i < lowest.size(); ++i) number_of[lowest[i]] = i;
    std::vector<std::vector<Index>> sets(lowest.size());
    for (Index t = 0; t < triangles.size(); ++t) {
      const Index number = number_of[together.find(t)];
      if (number != kNoIndex) sets[number].push_back(faces_[t]);
    }
    return sets;
  }

  /// Returns the sides of the walls, ascending by their ends.
  [[nodiscard]] static std::vector<WallSide> sides_of(std::span<const Triangle> triangles,
                                                      std::span<const std::uint8_t> is_wall) {
    std::vector<WallSide> sides;
    for (Index t = 0; t < triangles.size(); ++t) {
      if (is_wall[t] == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
        sides.push_back({.ends = {low, high}, .triangle = t});
      }
    }
    std::sort(sides.begin(), sides.end(),
              [](const WallSide& a, const WallSide& b) { return a.ends < b.ends; });
    return sides;
  }

  [[nodiscard]] bool has_odd_edge_at(const std::array<Index, 2>& ends) const {
    const std::size_t edge = incidences_.edge_between(ends[0], ends[1]);
    return edge < incidences_.size() && incidences_.ends[edge] == ends && is_odd(edge);
  }

  const PreparedMesh& mesh_;
  const EdgeIncidences& incidences_;
  /// The faces of the surfaces with cells, ascending.
  std::vector<Index> faces_;
};

}  // namespace

std::vector<std::vector<Index>> find_walls_between_cells(const PreparedMesh& mesh) {
  const EdgeIncidences incidences = list_incidences(mesh.cut());
  for (std::size_t edge = 0; edge < incidences.size(); ++edge) {
    if (incidences.n_faces(edge) % 2 != 0) return WallsBetweenCells(mesh, incidences).find();
  }
  return {};
}

}  // namespace meshalyzer
