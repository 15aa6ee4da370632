#include "meshalyzer/arrangement/corners_on_grid.h"

#include "meshalyzer/arrangement/round_vertices.h"
#include "meshalyzer/base/point_table.h"
#include "meshalyzer/base/triangle.h"

#include <cstddef>

namespace meshalyzer {

std::vector<Vec3> corners_on_grid(const Soup& soup, std::span<const std::uint8_t> is_moved,
                                  double spacing) {
  std::vector<Vec3> positions = soup.positions;
  const std::vector<Index> place_of = first_equal_points(soup.positions);
  std::vector<std::uint8_t> is_rounded(positions.size(), 0);
  for (std::size_t face = 0; face < soup.n_faces(); ++face) {
    if (is_moved[face] == 0) continue;
    for (const Index v : soup.triangles[face]) is_rounded[place_of[v]] = 1;
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (is_rounded[place_of[v]] != 0) positions[v] = nearest_on_grid(positions[v], spacing);
  }
  return positions;
}

}  // namespace meshalyzer
