#pragma once

#include "meshalyzer/base/box.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace meshalyzer {

/// Maps triangles to coordinates of about -1 ... 1, in which squares and cubes neither overflow nor
/// vanish. The scale is a power of two: coordinates are rounded only by moving the centre to 0.
class UnitScale {
 public:
  explicit UnitScale(std::span<const Corners> triangles) {
    Box3 box;
    for (const Corners& t : triangles) {
      for (const Vec3& p : t) {
        box.extend(p);
      }
    }
    if (box.isEmpty()) {
      return;
    }
    const double half = half_widths_of(box).maxCoeff();
    const int exponent = half > 0.0 ? -std::ilogb(half) : 0;
    // The scaling takes two steps, because the factor itself may overflow.
    first_ = std::ldexp(1.0, exponent / 2);
    second_ = std::ldexp(1.0, exponent - exponent / 2);
    centre_ = scaled(box.min()) / 2 + scaled(box.max()) / 2;
    rounding_ =
        std::max(scaled(box.min()).cwiseAbs().maxCoeff(), scaled(box.max()).cwiseAbs().maxCoeff()) *
        0x1p-52;
  }

  [[nodiscard]] Vec3 operator()(const Vec3& point) const { return scaled(point) - centre_; }

  /// Returns the spacing of doubles at the original coordinates, in the scaled ones.
  [[nodiscard]] double rounding() const { return rounding_; }

 private:
  [[nodiscard]] Vec3 scaled(const Vec3& point) const { return point * first_ * second_; }

  double first_ = 1.0;
  double second_ = 1.0;
  Vec3 centre_ = Vec3::Zero();
  double rounding_ = 0.0;
};

}  // namespace meshalyzer
