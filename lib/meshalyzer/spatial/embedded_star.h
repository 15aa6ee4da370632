#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// The vector from the hub of a star to another vertex of it, each coordinate rounded once.
struct Arm {
  Arm(const Vec3& hub, const Vec3& end) : vector(end - hub), size(vector.cwiseAbs().maxCoeff()) {}

  Vec3 vector;
  /// The largest magnitude of a coordinate.
  double size;
};

/// The faces of one fan round a vertex, the hub. Face i has the arms i and i + 1.
struct Star {
  /// The arms of the fan, counter-clockwise. A closed fan does not repeat its first arm at the end.
  std::span<const Arm> arms;
  bool is_closed = false;

  [[nodiscard]] std::size_t n_faces() const {
    return is_closed || arms.empty() ? arms.size() : arms.size() - 1;
  }
  /// Returns the first arm of a face.
  [[nodiscard]] const Arm& first_arm(std::size_t face) const { return arms[face]; }
  [[nodiscard]] const Arm& second_arm(std::size_t face) const {
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
