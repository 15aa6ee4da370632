#pragma once

#include "unit/repair/unit_squares.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A solid of unit cubes in a block of them, whose surface has one vertex for each corner: where
/// cubes have but an edge or a vertex in common, it is not manifold.
class VoxelSolid {
 public:
  explicit VoxelSolid(const std::array<int, 3>& size)
      : size_(size), is_full_(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0) {}

  void fill(const std::array<int, 3>& cell) { is_full_[number(cell)] = 1; }
  [[nodiscard]] bool is_full(const std::array<int, 3>& cell) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell[k] < 0 || cell[k] >= size_[k]) return false;
    }
    return is_full_[number(cell)] != 0;
  }
  [[nodiscard]] std::vector<std::array<int, 3>> full_cells() const {
    std::vector<std::array<int, 3>> cells;
    for (int z = 0; z < size_[2]; ++z) {
      for (int y = 0; y < size_[1]; ++y) {
        for (int x = 0; x < size_[0]; ++x) {
          if (is_full({x, y, z})) cells.push_back({x, y, z});
        }
      }
    }
    return cells;
  }

  /// Outward.
  [[nodiscard]] Soup surface() const {
    UnitSquares squares;
    for (const auto& cell : full_cells()) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) add_side(cell, axis, side, squares);
      }
    }
    return squares.soup();
  }

  /// Returns the number of parts of the cubes that are joined through common squares.
  [[nodiscard]] std::size_t n_parts() const {
    std::vector<std::uint8_t> seen(is_full_.size(), 0);
    std::size_t n = 0;
    for (const auto& start : full_cells()) {
      if (seen[number(start)] != 0) continue;
      ++n;
      seen[number(start)] = 1;
      std::vector<std::array<int, 3>> waiting{start};
      while (!waiting.empty()) {
        const auto cell = waiting.back();
        waiting.pop_back();
        for (std::size_t k = 0; k < 6; ++k) {
          const auto next = neighbour(cell, k / 2, static_cast<int>(k % 2));
          if (!is_full(next) || seen[number(next)] != 0) continue;
          seen[number(next)] = 1;
          waiting.push_back(next);
        }
      }
    }
    return n;
  }

 private:
  [[nodiscard]] std::size_t number(const std::array<int, 3>& cell) const {
    return static_cast<std::size_t>((cell[2] * size_[1] + cell[1]) * size_[0] + cell[0]);
  }
  [[nodiscard]] static std::array<int, 3> neighbour(std::array<int, 3> cell, std::size_t axis,
                                                    int side) {
    cell[axis] += 2 * side - 1;
    return cell;
  }

  /// Adds the square on a side of a cell, if it is on the surface.
  void add_side(std::array<int, 3> cell, std::size_t axis, int side, UnitSquares& squares) const {
    if (is_full(neighbour(cell, axis, side))) return;
    cell[axis] += side;
    squares.add(cell, axis, side == 0);
  }

  std::array<int, 3> size_;
  std::vector<std::uint8_t> is_full_;
};

}  // namespace meshalyzer
