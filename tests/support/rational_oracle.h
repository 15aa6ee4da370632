#pragma once

#include "meshalyzer/exact/predicates.h"

#include <array>
#include <span>

namespace meshalyzer::test {

/// The corners of a triangle.
using Triangle3 = std::array<Vec3, 3>;

/// Returns the expected result of orient3d(): the sign of the determinant |b-a, c-a, d-a| over the
/// rationals.
[[nodiscard]] Sign rational_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Returns the expected result of orient2d(): the sign of a component of (b-a) x (c-a) over the
/// rationals.
[[nodiscard]] Sign rational_orient2d(Axis dropped, const Vec3& a, const Vec3& b, const Vec3& c);

/// Tells whether a finite vector is the true (b-a) x (c-a) up to an error of this fraction of its
/// length.
[[nodiscard]] bool is_rational_normal(const Vec3& normal, const Triangle3& corners, double error);

/// Tells whether the largest component of the true (b-a) x (c-a) lies between these magnitudes.
[[nodiscard]] bool is_rational_normal_within(const Triangle3& corners, double low, double high);

/// Returns the sign of the sum of det(a, b, c) over triangles, given as three corners each.
[[nodiscard]] Sign rational_volume_sign(std::span<const Vec3> corners);

/// Returns a sixth of the sum of det(a, b, c) over triangles, given as three corners each.
[[nodiscard]] double rational_volume(std::span<const Vec3> corners);

}  // namespace meshalyzer::test
