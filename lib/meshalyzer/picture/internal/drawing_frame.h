#pragma once

#include "meshalyzer/base/types.h"

#include <vector>

namespace meshalyzer {

/// Maps positions to drawn coordinates: about the centre of a box, and scaled by a power of two if
/// the size of the box does not suit single precision, or a viewer that multiplies lengths.
class DrawingFrame {
 public:
  /// @param box  A finite box; if it is empty, nothing is moved or scaled.
  explicit DrawingFrame(const Box3& box);

  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] double scale() const { return scale_; }
  /// Returns half the diagonal of the box in drawn coordinates; 1 if the box has none.
  [[nodiscard]] double radius() const { return radius_; }

  /// Returns the drawn coordinates of a position. They are finite and their squares fit into
  /// floats: positions farther away, which could not be seen beside the mesh, are drawn nearer.
  [[nodiscard]] Vec3 operator()(const Vec3& place) const {
    return ((place - centre_) * scale_).cwiseMax(-kFarthest).cwiseMin(kFarthest);
  }

 private:
  static constexpr double kFarthest = 0x1p60;

  Vec3 centre_ = Vec3::Zero();
  double scale_ = 1.0;
  double radius_ = 1.0;
};

/// Appends the coordinates of a point to a flat array.
void append_point(std::vector<float>& array, const Vec3& drawn);

}  // namespace meshalyzer
