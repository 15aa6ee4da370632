#pragma once

#include "meshalyzer/base/types.h"

#include <span>

namespace meshalyzer {

/// The faces of one fan round a vertex, the hub. Face i has the arms i and i + 1.
struct Star {
  /// The vectors from the hub to the other vertices of the fan, counter-clockwise, each coordinate
  /// rounded once. A closed fan does not repeat its first arm at the end.
  std::span<const Vec3> arms;
  bool is_closed = false;

  [[nodiscard]] std::size_t n_faces() const {
    return is_closed || arms.empty() ? arms.size() : arms.size() - 1;
  }
  /// Returns the first arm of a face.
  [[nodiscard]] const Vec3& first_arm(std::size_t face) const { return arms[face]; }
  [[nodiscard]] const Vec3& second_arm(std::size_t face) const {
    return arms[face + 1 == arms.size() ? 0 : face + 1];
  }
};

/// Tells whether a quick test proves that no two faces of a star share more than the hub, or the
/// edge between neighbours. False means that nothing is proven.
///
/// The test succeeds at nearly all vertices of a surface. If all faces surely face one direction,
/// each projects to a sector of a plane, and the sectors follow each other round the hub. So the
/// faces are disjoint if the sectors are: those of a closed fan when they go round exactly once,
/// those of an open one when they go round less than once. (All faces may face one direction even
/// if they go round twice: the turns must be counted.)
[[nodiscard]] bool is_surely_embedded(const Star& star);

}  // namespace meshalyzer
