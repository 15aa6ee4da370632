#pragma once

#include "meshalyzer/base/corners.h"

#include <cstddef>

namespace meshalyzer {

/// Returns the vector (b - a) x (c - a), whose length is twice the area of the triangle, with a
/// relative error below 1e-9 for any shape: slivers, for which the floating-point product has no
/// correct digit, are evaluated exactly and rounded.
///
/// It is zero exactly when the points are collinear or the result underflows, and infinite where
/// the true value overflows.
[[nodiscard]] Vec3 accurate_normal(const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns the accurate normal of a triangle, evaluated from one of its corners. The corner
/// opposite to the longest edge loses the least, because the differences are shortest there.
[[nodiscard]] Vec3 accurate_normal(const Corners& t, std::size_t apex = 0);

/// Returns the accurate normal of a triangle of the same shape that is about as large as 1. It has
/// the same direction and, whatever the size of the triangle, neither overflows nor underflows
/// unless the triangle is flatter than doubles can tell; it is zero when the corners are collinear.
[[nodiscard]] Vec3 rescaled_normal(const Corners& t);

/// Returns the unit vector along the normal, whatever the size of the triangle, or zero when the
/// corners are collinear.
[[nodiscard]] Vec3 unit_normal(const Corners& t);

}  // namespace meshalyzer
