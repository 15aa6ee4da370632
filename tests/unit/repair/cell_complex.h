#pragma once

#include "meshalyzer/base/disjoint_sets.h"
#include "unit/repair/unit_squares.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace meshalyzer {

/// A block of unit cubes, each of which belongs to a cell, named by a number from 1, or to none: 0.
class CellComplex {
 public:
  explicit CellComplex(const std::array<int, 3>& size)
      : size_(size), cell_of_(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0) {}

  void assign(const std::array<int, 3>& cube, int cell) { cell_of_[number(cube)] = cell; }
  [[nodiscard]] int cell(const std::array<int, 3>& cube) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cube[k] < 0 || cube[k] >= size_[k]) return 0;
    }
    return cell_of_[number(cube)];
  }
  [[nodiscard]] double volume() const {
    double volume = 0.0;
    for (const int cell : cell_of_) volume += cell == 0 ? 0.0 : 1.0;
    return volume;
  }

  /// Counts the parts of cells that are joined through common squares.
  [[nodiscard]] std::size_t n_parts() const {
    DisjointSets joined(cell_of_.size());
    for_each_square(
        [&](const std::array<int, 3>& cube, const std::array<int, 3>& next, std::size_t) {
          if (cell(cube) != 0 && cell(cube) == cell(next)) {
            joined.unite(static_cast<Index>(number(cube)), static_cast<Index>(number(next)));
          }
        });
    std::size_t n = 0;
    for (Index i = 0; i < cell_of_.size(); ++i)
      n += cell_of_[i] != 0 && joined.is_lowest(i) ? 1 : 0;
    return n;
  }

  /// The faces of all cells, those between two of them once: outward, and from the cell with the
  /// lower number to the other.
  struct Faces {
    Soup soup;
    /// The faces between two cells, ascending.
    std::vector<Index> walls;
  };
  [[nodiscard]] Faces faces() const {
    Faces faces;
    UnitSquares squares;
    for_each_square(
        [&](const std::array<int, 3>& low, const std::array<int, 3>& high, std::size_t axis) {
          const int behind = cell(low);
          const int front = cell(high);
          if (behind == front) return;
          const bool is_wall = behind != 0 && front != 0;
          const bool is_turned = is_wall ? front < behind : behind == 0;
          const auto first = static_cast<Index>(squares.soup().n_faces());
          if (is_wall) faces.walls.insert(faces.walls.end(), {first, first + 1});
          squares.add(high, axis, is_turned);
        });
    faces.soup = squares.soup();
    return faces;
  }

 private:
  [[nodiscard]] std::size_t number(const std::array<int, 3>& cube) const {
    return static_cast<std::size_t>((cube[2] * size_[1] + cube[1]) * size_[0] + cube[0]);
  }

  /// Calls `body` with the cubes on both sides of each square of the block, the lower one first,
  /// and the axis from one to the other. One of them may be outside.
  template <typename Body>
  void for_each_square(const Body& body) const {
    for (int z = 0; z <= size_[2]; ++z) {
      for (int y = 0; y <= size_[1]; ++y) {
        for (int x = 0; x <= size_[0]; ++x) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<int, 3> low{x, y, z};
            --low[axis];
            body(low, std::array<int, 3>{x, y, z}, axis);
          }
        }
      }
    }
  }

  std::array<int, 3> size_;
  std::vector<int> cell_of_;
};

/// Returns a block of which each cube belongs to one of some cells at random.
[[nodiscard]] inline CellComplex random_complex(const std::array<int, 3>& size, unsigned n_cells,
                                                std::mt19937& random) {
  CellComplex complex(size);
  for (int x = 0; x < size[0]; ++x) {
    for (int y = 0; y < size[1]; ++y) {
      for (int z = 0; z < size[2]; ++z) {
        complex.assign({x, y, z}, 1 + static_cast<int>(random() % n_cells));
      }
    }
  }
  return complex;
}

/// Returns a cube of n^3 unit cubes, each of which belongs to the cell of the nearest of some
/// random points, as in a grained material.
[[nodiscard]] inline CellComplex grained_complex(int n, int n_cells, std::mt19937& random) {
  // In quarters of a cube.
  std::vector<std::array<int, 3>> seeds(static_cast<std::size_t>(n_cells));
  for (auto& seed : seeds) {
    for (int& x : seed) x = static_cast<int>(random() % static_cast<unsigned>(4 * n));
  }
  CellComplex complex({n, n, n});
  for (int i = 0; i < n * n * n; ++i) {
    const std::array<int, 3> cube{i % n, i / n % n, i / n / n};
    const auto distance = [&](const std::array<int, 3>& seed) {
      int sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += (4 * cube[k] + 2 - seed[k]) * (4 * cube[k] + 2 - seed[k]);
      }
      return sum;
    };
    const auto nearest =
        std::min_element(seeds.begin(), seeds.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    complex.assign(cube, 1 + static_cast<int>(nearest - seeds.begin()));
  }
  return complex;
}

}  // namespace meshalyzer
