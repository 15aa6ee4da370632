#include "meshalyzer/repair/cut/internal/positions_on_grid.h"

#include "meshalyzer/arrangement/round_vertices.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/point_table.h"

#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// #n_faces: 1 for those that change together with an unfinished one.
std::vector<std::uint8_t> which_are_of_unfinished_parts(const CutSurface& surface,
                                                        std::size_t n_faces) {
  DisjointSets parts(n_faces);
  for (const auto& [a, b] : surface.ties) {
    if (a < n_faces && b < n_faces) parts.unite(a, b);
  }
  std::vector<std::uint8_t> found(n_faces, 0);
  for (const Index face : surface.unfinished) {
    if (face < n_faces) found[parts.find(face)] = 1;
  }
  for (Index face = 0; face < n_faces; ++face) found[face] = found[parts.find(face)];
  return found;
}

}  // namespace

std::vector<Vec3> positions_on_grid(const Soup& soup, const CutSurface& surface, double spacing) {
  const std::vector<std::uint8_t> is_unfinished =
      which_are_of_unfinished_parts(surface, soup.n_faces());
  std::vector<Vec3> positions = soup.positions;
  const std::vector<Index> place_of = first_equal_points(soup.positions);
  std::vector<std::uint8_t> is_rounded(positions.size(), 0);
  for (std::size_t face = 0; face < soup.n_faces(); ++face) {
    if (is_unfinished[face] == 0) continue;
    for (const Index v : soup.triangles[face]) is_rounded[place_of[v]] = 1;
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (is_rounded[place_of[v]] != 0) positions[v] = nearest_on_grid(positions[v], spacing);
  }
  return positions;
}

}  // namespace meshalyzer
