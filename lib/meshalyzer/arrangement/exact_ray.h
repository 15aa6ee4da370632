#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"
#include "meshalyzer/exact/predicates.h"

#include <vector>

namespace meshalyzer {

/// A face that a ray goes through.
struct RayCrossing {
  Index face = kNoIndex;
  /// 1 where the ray leaves what the face encloses, -1 where it enters.
  Sign sign = 1;
};

/// What a ray from inside a piece, along an axis, goes through. The faces that the piece is of are
/// left out.
struct PieceRay {
  /// The cell beside the piece that the ray begins in.
  Index cell = kNoIndex;
  /// Faces of closed components alone.
  std::vector<RayCrossing> crossings;
};

/// Follows a ray from a piece, exactly; it grazes no edge of a closed component.
///
/// @param piece  Of an area.
[[nodiscard]] PieceRay follow_ray(const ArrangedSoup& arranged, Index piece);

}  // namespace meshalyzer
