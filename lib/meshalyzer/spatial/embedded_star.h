#pragma once

#include "meshalyzer/base/types.h"

#include <span>

namespace meshalyzer {

/// The faces of one fan round a vertex, the hub, seen from there: face i has the arms i and i + 1.
struct Star {
  /// The vectors from the hub to the other vertices of the fan, counter-clockwise, each coordinate
  /// a difference of the file's rounded once. A closed fan does not repeat its first ones at its
  /// end.
  std::span<const Vec3> arms;
  bool is_closed = false;

  [[nodiscard]] std::size_t n_faces() const {
    return is_closed || arms.empty() ? arms.size() : arms.size() - 1;
  }
  /// The arms of a face, in its order.
  [[nodiscard]] const Vec3& first_arm(std::size_t face) const { return arms[face]; }
  [[nodiscard]] const Vec3& second_arm(std::size_t face) const {
    return arms[face + 1 == arms.size() ? 0 : face + 1];
  }
};

/// Tells whether a quick test proves that no two faces of a star share more than the hub, or the
/// one edge between neighbours. False says nothing.
///
/// Proves the stars of nearly all vertices of a surface. Where all faces surely face one direction,
/// each covers a sector of the plane below it, and the sectors follow each other round the hub. So
/// the faces are apart where the sectors are: those of a closed fan when they go round exactly
/// once, those of an open one when they go round less than once. (Going round twice, all faces may
/// well face one direction: the turns must be counted.)
[[nodiscard]] bool is_surely_embedded(const Star& star);

}  // namespace meshalyzer
