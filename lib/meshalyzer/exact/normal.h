#pragma once

#include "meshalyzer/base/corners.h"

#include <cstddef>

namespace meshalyzer {

/// Returns the vector (b - a) x (c - a), twice the area of the triangle long, with a relative error
/// of its length below 1e-9 for any shape: slivers, for which the floating-point product has no
/// correct digit, are evaluated exactly and rounded.
///
/// Zero exactly when the points are collinear, or when the result underflows. Overflows to infinity
/// where the true value does.
[[nodiscard]] Vec3 accurate_normal(const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns the same for a triangle, evaluated from one of its corners: least is lost seen from the
/// one opposite to the longest edge, where the differences are shortest.
[[nodiscard]] Vec3 accurate_normal(const Corners& t, std::size_t apex = 0);

/// Returns the unit vector along accurate_normal(); zero where the corners are collinear.
[[nodiscard]] Vec3 unit_normal(const Corners& t);

}  // namespace meshalyzer
