#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

// Private to the picture module: where two faces meet, to be drawn.

/// A few segments.
struct ContactSegments {
  /// A triangle clipped five times has no more corners, rounding included.
  static constexpr std::size_t kMax = 20;

  std::array<std::array<Vec3, 2>, kMax> segments;
  std::size_t count = 0;

  [[nodiscard]] const std::array<Vec3, 2>* begin() const { return segments.data(); }
  [[nodiscard]] const std::array<Vec3, 2>* end() const { return segments.data() + count; }
};

/// What two intersecting triangles have in common, vertices and edges that are common by id
/// included: the outline of an overlap (coplanar overlap, fold-over, duplicate), else the segment
/// along which they meet, of length 0 where it is a point.
///
/// For drawing: every point is within 1e-9 of the size of the pair from both triangles, slivers and
/// triangles of zero area included. Where their planes are parallel to rounding, the segment is the
/// longest one that is that close to both. Of triangles that do not meet it is a point between
/// them.
///
/// @param p, q  Finite.
/// @return      One segment at least; finite.
[[nodiscard]] ContactSegments contact_segments(const Corners& p, const Corners& q,
                                               ContactKind kind);

}  // namespace meshalyzer
