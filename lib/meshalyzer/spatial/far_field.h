#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/spatial/two_vectors.h"

#include <numbers>
#include <span>

namespace meshalyzer {

/// The far field of some triangles: the first three terms of the multipole expansion about their
/// centre. With r from the point to the centre and d from the centre to a place on a triangle, the
/// flux of (r + d) / |r + d|^3 through all triangles is expanded in d. The derivatives of r / |r|^3
/// are symmetric and traceless, so that only such parts of the moments count.
struct FarField {
  Vec3 centre = Vec3::Zero();
  /// The square of the distance from which the expansion is accurate enough.
  double far_squared = 0.0;
  /// The sum of the area vectors.
  Vec3 area = Vec3::Zero();
  /// The integral of the products of offset and area vector, as the coefficients of a quadratic
  /// form: of xx, yy, zz, and of yz, zx, xy.
  Vec3 squares = Vec3::Zero();
  Vec3 mixed = Vec3::Zero();
  /// The integral of the products of two offsets and the area vector, as the coefficients of a
  /// cubic form: of xxx, yyy, zzz; of xyy, yzz, zxx; of xzz, yxx, zyy; of xyz.
  Vec3 cubes = Vec3::Zero();
  Vec3 with_next = Vec3::Zero();
  Vec3 with_last = Vec3::Zero();
  double of_all = 0.0;

  /// Adds a triangle with corners at offsets from the centre.
  ///
  /// @param n  The area vector.
  void add(const Corners& d, const Vec3& n);

  /// Makes both forms harmonic, which changes nothing but makes their traces zero.
  void remove_traces();

  /// Returns the shares of directions of all the triangles together, as seen from two points.
  ///
  /// @param r  The offsets from the points to the centre.
  [[nodiscard, gnu::always_inline]] Two share_from(const TwoVectors& r,
                                                   const Two& distance_squared) const {
    const Two inverse = 1.0 / distance_squared;
    const TwoVectors square(r.x * r.x, r.y * r.y, r.z * r.z);
    const TwoVectors product(r.y * r.z, r.z * r.x, r.x * r.y);
    const Two second = square.dot(squares) + product.dot(mixed);
    const TwoVectors factor(
        cubes.x() * square.x + with_next.x() * square.y + with_last.x() * square.z,
        cubes.y() * square.y + with_next.y() * square.z + with_last.y() * square.x,
        cubes.z() * square.z + with_next.z() * square.x + with_last.z() * square.y);
    const Two third = factor.dot(r) + of_all * (r.x * product.x);
    const Two sum = r.dot(area) + (7.5 * third * inverse - 3.0 * second) * inverse;
    return sum * inverse * inverse.sqrt() / (4.0 * std::numbers::pi);
  }
};

/// Returns the far field of some triangles.
///
/// @param far  It is used beyond this many radii.
[[nodiscard]] FarField far_field_of(std::span<const Corners> triangles, double far);

}  // namespace meshalyzer
