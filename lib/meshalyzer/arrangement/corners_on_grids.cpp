#include "meshalyzer/arrangement/corners_on_grids.h"

#include "meshalyzer/arrangement/round_vertices.h"
#include "meshalyzer/base/point_table.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/used_box.h"

#include <array>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

/// The resolutions of the grids, see grid_spacing(); the finest first.
constexpr std::array kGridsOfAttempts{40, 36, 32};

/// #V: non-zero for the corners of some faces, and for all vertices at the same positions.
std::vector<std::uint8_t> which_are_moved(const Soup& soup,
                                          std::span<const std::uint8_t> is_moved_face) {
  const std::vector<Index> place_of = first_equal_points(soup.positions);
  std::vector<std::uint8_t> is_moved(soup.n_vertices(), 0);
  for (std::size_t face = 0; face < soup.n_faces(); ++face) {
    if (is_moved_face[face] == 0) continue;
    for (const Index v : soup.triangles[face]) is_moved[place_of[v]] = 1;
  }
  for (std::size_t v = 0; v < is_moved.size(); ++v) is_moved[v] = is_moved[place_of[v]];
  return is_moved;
}

}  // namespace

std::vector<std::vector<Vec3>> corners_on_grids(const Soup& soup,
                                                std::span<const std::uint8_t> is_moved,
                                                double max_deviation) {
  const std::vector<std::uint8_t> is_moved_vertex = which_are_moved(soup, is_moved);
  const double extent = used_extent(soup);
  std::vector<std::vector<Vec3>> attempts;
  for (const int bits : kGridsOfAttempts) {
    const double spacing = grid_spacing(bits, extent, max_deviation);
    if (!(spacing > 0.0)) break;
    std::vector<Vec3> positions = soup.positions;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (is_moved_vertex[v] != 0) positions[v] = nearest_on_grid(positions[v], spacing);
    }
    // With the same positions an attempt ends as the one before.
    const std::vector<Vec3>& before = attempts.empty() ? soup.positions : attempts.back();
    if (positions != before) attempts.push_back(std::move(positions));
  }
  return attempts;
}

}  // namespace meshalyzer
