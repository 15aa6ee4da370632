#pragma once

#include "meshalyzer/boolean/inside_rule.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// The result of a rule for boxes on a grid of unit cells, found cell by cell.
class CellModel {
 public:
  /// Boxes have coordinates from 0 to this one.
  static constexpr int kSize = 12;
  /// The lowest and the highest coordinate on each axis.
  using Box = std::array<std::array<int, 2>, 3>;

  CellModel(const std::vector<Box>& boxes, const InsideRule& rule);

  [[nodiscard]] int volume() const;

  /// Returns the Euler characteristic of its boundary, a complex of unit squares.
  [[nodiscard]] int euler_characteristic() const;

 private:
  [[nodiscard]] bool inside(int x, int y, int z) const;

  /// Tells whether the cells round a vertex, edge or square are inside and outside.
  [[nodiscard]] bool is_on_boundary(const std::array<int, 3>& at,
                                    const std::array<int, 3>& extent) const;

  std::array<bool, kSize * kSize * kSize> is_inside_{};
};

[[nodiscard]] Soup box_mesh(const CellModel::Box& box);

}  // namespace meshalyzer
