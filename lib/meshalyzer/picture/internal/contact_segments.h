#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

/// A short list of segments.
struct ContactSegments {
  /// The largest number of corners of a triangle clipped five times, in spite of rounding.
  static constexpr std::size_t kMax = 20;

  std::array<std::array<Vec3, 2>, kMax> segments;
  std::size_t count = 0;

  [[nodiscard]] const std::array<Vec3, 2>* begin() const { return segments.data(); }
  [[nodiscard]] const std::array<Vec3, 2>* end() const { return segments.data() + count; }
};

/// Returns the intersection of two intersecting triangles, including what they share by id: the
/// outline of an overlap (coplanar overlap, fold-over, duplicate), else the segment along which
/// they meet, of length 0 if it is a point.
///
/// The result is accurate enough for drawing: every point is within 1e-9 of the size of the pair
/// from both triangles, even for slivers and triangles of zero area. If the planes are parallel up
/// to rounding, the segment is the longest one that is that close to both. Triangles that do not
/// meet give a point between them.
///
/// @param p, q  The triangles, which must be finite.
/// @return      At least one segment; all are finite.
[[nodiscard]] ContactSegments contact_segments(const Corners& p, const Corners& q,
                                               ContactKind kind);

}  // namespace meshalyzer
