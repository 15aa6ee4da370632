#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

/// The figures that decide whether a face is thin. Lengths are in the mesh's unit.
struct FacetShape {
  /// The lengths of the edges from corner k to corner k + 1.
  std::array<double, 3> lengths{};
  /// The shortest altitude, which is the one on the longest edge; 0 if the corners are collinear.
  double altitude = 0.0;
  /// The unit normal; zero if the corners are collinear.
  Vec3 normal = Vec3::Zero();

  /// Returns the longest edge, by its first corner; of equal ones the first.
  [[nodiscard]] std::size_t longest_edge() const;
  [[nodiscard]] std::size_t shortest_edge() const;
  /// Tells whether no edge and no altitude is below a tolerance, or 0. A small margin makes sure
  /// that another measurement of the face agrees.
  [[nodiscard]] bool is_sound(double tolerance) const {
    return altitude > 0.0 && altitude >= tolerance * (1.0 + 1e-6);
  }
};

/// Measures a face of any size and shape: neither overflows early nor loses the digits of slivers.
[[nodiscard]] FacetShape measure_facet(const Corners& p);

}  // namespace meshalyzer
