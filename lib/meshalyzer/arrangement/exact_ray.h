#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"
#include "meshalyzer/exact/predicates.h"

#include <vector>

namespace meshalyzer {

/// A face that a ray crosses.
struct RayCrossing {
  Index face = kNoIndex;
  /// The sign is 1 if the ray leaves the enclosed space, -1 if it enters.
  Sign sign = 1;
};

/// The crossings of a ray from inside a piece along an axis. The faces of the piece itself are
/// excluded.
struct PieceRay {
  /// The cell beside the piece in which the ray begins.
  Index cell = kNoIndex;
  /// The crossed faces of closed components.
  std::vector<RayCrossing> crossings;
};

/// Follows a ray from a piece, exactly; it grazes no edge of a closed component.
///
/// @param piece  A piece of non-zero area.
[[nodiscard]] PieceRay follow_ray(const ArrangedSoup& arranged, Index piece);

}  // namespace meshalyzer
