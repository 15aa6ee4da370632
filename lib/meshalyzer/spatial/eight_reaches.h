#pragma once

#include "meshalyzer/base/eight_lanes.h"
#include "meshalyzer/spatial/leaf_triangles.h"

#include <array>
#include <cmath>

namespace meshalyzer {

// Any direction is valid, even a rounded one; only the errors of the computed coordinates of
// corners along it matter. With u = 2^-24, and |d| the sum of the magnitudes of the direction's
// coordinates:
//
// - A coordinate of a corner is at most 1 in magnitude and rounded from a double: it is off by less
//   than 1.01 u.
// - Its product with that of the direction, and the two sums, add at most 3.03 u of their terms.
//
// So the coordinate of a corner is off by less than 4.05 u |d|, and a gap by twice that. The rest
// of the factor covers the roundings of |d|, of its product, and of the sum or difference in which
// it is used. Underflow causes an error of about 2^-148, which matters only for the shortest
// directions.
inline constexpr float kGapSlack = 10 * 0x1p-24F;
inline constexpr float kUnderflow = 0x1p-120F;

/// Returns by how much a gap between two extents along a direction must be computed to be wide, for
/// it to be one.
inline float gap_slack(const std::array<float, 3>& direction) {
  return kGapSlack * (std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2])) +
         kUnderflow;
}

/// Three coordinates of eight points or directions.
using EightVectors = std::array<EightFloats, 3>;

inline EightVectors loaded(const std::array<std::array<float, 8>, 3>& coordinates) {
  return {EightFloats::load(coordinates[0]), EightFloats::load(coordinates[1]),
          EightFloats::load(coordinates[2])};
}

inline EightVectors eight_times(const std::array<float, 3>& v) {
  return {EightFloats::all(v[0]), EightFloats::all(v[1]), EightFloats::all(v[2])};
}

inline EightFloats dot_product(const EightVectors& a, const EightVectors& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// These templates work for single numbers and for eight of them.

template <typename Vector>
Vector subtracted(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <typename Vector>
Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

using EightCorners = std::array<EightVectors, 3>;

inline EightCorners loaded(const LeafTriangles& faces) {
  return {loaded(faces.corners[0]), loaded(faces.corners[1]), loaded(faces.corners[2])};
}

/// The extents of eight triangles along a direction.
struct EightReaches {
  EightFloats low;
  EightFloats high;

  EightReaches(const EightVectors& directions, const EightCorners& corners) {
    const EightFloats a = dot_product(directions, corners[0]);
    const EightFloats b = dot_product(directions, corners[1]);
    const EightFloats c = dot_product(directions, corners[2]);
    low = min(min(a, b), c);
    high = max(max(a, b), c);
  }
};

}  // namespace meshalyzer
