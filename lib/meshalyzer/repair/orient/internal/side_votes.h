#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/winding_number.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module: estimates from samples which side of a surface is inside.

/// A sample point of a surface and the share of the area that it represents, in a unit of the
/// surface's own.
struct SurfaceSample {
  Vec3 point = Vec3::Zero();
  double area = 0.0;
};

/// Samples the middles of faces: of all that have an area if they are few; else of some, larger
/// ones with a higher probability, chosen at equal steps through the area in the order given.
///
/// @return A few hundred samples at most; the same if faces are turned over by exchanging their
/// last two corners.
[[nodiscard]] std::vector<SurfaceSample> sample_surface(std::span<const Corners> triangles);

/// The area of a surface by its winding numbers on both sides. A closed surface has 1 behind its
/// faces and 0 in front, a flat sheet 1/2 and -1/2: each face counts as the nearer of these.
struct SideVotes {
  double area = 0.0;
  /// The area that separates with the inside behind the faces.
  double outward = 0.0;
  /// The area that separates with the inside in front of the faces.
  double inward = 0.0;

  /// Tells whether at least half of the surface separates.
  [[nodiscard]] bool bounds_solid() const { return area > 0.0 && outward + inward >= area / 2; }
  [[nodiscard]] bool is_outward() const { return outward > inward; }
  /// Tells whether at least half of the surface votes one way, and less than half as much the
  /// other.
  [[nodiscard]] bool is_clear() const {
    const double more = is_outward() ? outward : inward;
    const double less = is_outward() ? inward : outward;
    return area > 0.0 && more >= area / 2 && less < more / 2;
  }
};

/// @param surface  The surface that was sampled.
/// @complexity     O(#samples log #F).
[[nodiscard]] SideVotes count_votes(const WindingNumbers& surface,
                                    std::span<const SurfaceSample> samples);

}  // namespace meshalyzer
