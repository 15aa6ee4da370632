#pragma once

#include "meshalyzer/base/types.h"

namespace meshalyzer {

/// Axes that are turned against those of the file, for boxes that fit long faces oblique to these.
///
/// Places in the frame are rounded: they serve to tell faces apart that are clearly so, and nothing
/// else.
struct BoxFrame {
  /// A point near the faces, in the file's coordinates.
  Vec3 origin = Vec3::Zero();
  /// Three perpendicular unit vectors, row by row.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  [[nodiscard]] Vec3 place_of(const Vec3& point) const { return axes * (point - origin); }

  /// Returns a bound on the error of each coordinate of place_of().
  ///
  /// With u = 2^-53, the difference is off by at most u of its length, and the three products and
  /// two sums, whatever their order, by 3.01 u of it. The bound has 8 u of the largest length: axes
  /// may be a little longer than 1, and an underflow is less than the rest if it is not below
  /// 2^-900.
  ///
  /// @param box  The points meant, in the file's coordinates.
  [[nodiscard]] double rounding(const Box3& box) const {
    return 0x1p-50 *
           (box.min() - origin).cwiseAbs().cwiseMax((box.max() - origin).cwiseAbs()).norm();
  }
};

}  // namespace meshalyzer
