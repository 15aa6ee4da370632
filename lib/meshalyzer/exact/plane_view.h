#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/exact/predicates.h"

namespace meshalyzer {

/// Returns the axis along which a plane figure with this normal projects to the largest area.
[[nodiscard]] inline Axis longest_axis(const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return static_cast<Axis>(axis);
}

/// A projection along an axis in which a plane figure is counter-clockwise. Decisions are exact.
struct PlaneView {
  Axis dropped = Axis::Z;
  /// The orientation of the figure in the projection: 1 counter-clockwise, -1 clockwise.
  Sign sense = 1;

  /// Returns the turn from a to b to c: 1 to the left, -1 to the right.
  [[nodiscard]] Sign turn(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return sense * orient2d(dropped, a, b, c);
  }

  /// Tells whether a point lies in a counter-clockwise triangle or on its border.
  [[nodiscard]] bool covers(const Corners& t, const Vec3& p) const {
    return turn(t[0], t[1], p) >= 0 && turn(t[1], t[2], p) >= 0 && turn(t[2], t[0], p) >= 0;
  }
};

}  // namespace meshalyzer
