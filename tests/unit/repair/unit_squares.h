#pragma once

#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace meshalyzer {

/// A mesh of squares between whole numbers, two faces each, with one vertex for each corner.
class UnitSquares {
 public:
  /// Adds a square across an axis.
  ///
  /// @param corner     The corner with the lowest coordinates.
  /// @param is_turned  Whether it faces the negative end of the axis.
  void add(const std::array<int, 3>& corner, std::size_t axis, bool is_turned) {
    std::array<Index, 4> quad{};
    // Counter-clockwise seen from the positive end of the axis.
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> at = corner;
      at[(axis + 1) % 3] += (k == 1 || k == 2) ? 1 : 0;
      at[(axis + 2) % 3] += k >= 2 ? 1 : 0;
      const auto [place, is_new] =
          vertices_.try_emplace(at, static_cast<Index>(soup_.positions.size()));
      if (is_new) soup_.positions.emplace_back(at[0], at[1], at[2]);
      quad[is_turned ? 3 - k : k] = place->second;
    }
    soup_.triangles.push_back({quad[0], quad[1], quad[2]});
    soup_.triangles.push_back({quad[0], quad[2], quad[3]});
  }

  [[nodiscard]] const Soup& soup() const { return soup_; }

 private:
  Soup soup_;
  std::map<std::array<int, 3>, Index> vertices_;
};

}  // namespace meshalyzer
