#include "meshalyzer/spatial/faces_near.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/box_tree.h"
#include "meshalyzer/spatial/finite_part.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

/// A grid of 64 x 64 x 64 cells over some boxes, each of which knows whether a box lies in it. Most
/// faces are in cells without any, which takes far less time to see than a search in a tree.
class BoxGrid {
 public:
  explicit BoxGrid(std::span<const Box3> boxes) : rows_(kCells * kCells, 0) {
    for (const Box3& box : boxes) bounds_.extend(box);
    if (bounds_.isEmpty()) return;
    bounds_ = finite_part(bounds_);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double width = half_widths_of(bounds_)[k];
      cells_per_half_[k] =
          width > 0.0 ? std::min(kCells / width, std::numeric_limits<double>::max()) : 0.0;
    }
    for (const Box3& box : boxes) {
      if (box.isEmpty()) continue;
      visit_rows(box, [&](std::size_t row, std::uint64_t cells) { rows_[row] |= cells; });
    }
  }

  /// Tells whether a box, not an empty one, is in a cell with one of the boxes.
  [[nodiscard]] bool may_meet(const Box3& box) const {
    if (!bounds_.intersects(box)) return false;
    bool is_met = false;
    visit_rows(box, [&](std::size_t row, std::uint64_t cells) {
      is_met = is_met || (rows_[row] & cells) != 0;
    });
    return is_met;
  }

 private:
  static constexpr unsigned kCells = 64;

  /// Returns the cell of a coordinate, or the nearest one: monotone, so that boxes that meet have a
  /// cell in common.
  [[nodiscard]] unsigned cell(double x, Eigen::Index axis) const {
    const double low = bounds_.min()[axis];
    const double place =
        (std::clamp(x, low, bounds_.max()[axis]) / 2 - low / 2) * cells_per_half_[axis];
    return std::min(static_cast<unsigned>(place), kCells - 1);
  }

  /// Calls `visit` with the number of each row of cells along x that a box touches, and the bits of
  /// the cells.
  template <typename Visit>
  void visit_rows(const Box3& box, const Visit& visit) const {
    std::array<unsigned, 3> low;
    std::array<unsigned, 3> high;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      low[k] = cell(box.min()[axis], axis);
      high[k] = cell(box.max()[axis], axis);
    }
    const std::uint64_t cells = ~std::uint64_t{0} >> (kCells - 1 - high[0] + low[0]) << low[0];
    for (unsigned z = low[2]; z <= high[2]; ++z) {
      for (unsigned y = low[1]; y <= high[1]; ++y) visit(kCells * z + y, cells);
    }
  }

  Box3 bounds_;
  Vec3 cells_per_half_ = Vec3::Zero();
  /// A bit for each cell of a row along x.
  std::vector<std::uint64_t> rows_;
};

}  // namespace

std::vector<Index> find_faces_near(const Soup& soup, std::span<const Box3> boxes) {
  const BoxGrid grid(boxes);
  const BoxTree tree(boxes);
  return parallel_filter(soup.n_faces(), [&](Index face) {
    if (!is_in_complex(soup.triangles[face])) return false;
    const Box3 box = box_of(corners_of(soup, face));
    return grid.may_meet(box) && tree.meets_any(box);
  });
}

}  // namespace meshalyzer
