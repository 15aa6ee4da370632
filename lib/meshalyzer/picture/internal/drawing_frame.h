#pragma once

#include "meshalyzer/base/types.h"

#include <vector>

namespace meshalyzer {

/// Maps places to drawn coordinates: about the centre of a box, and scaled by a power of two where
/// single precision, or a viewer that multiplies lengths, would not do with its size.
class DrawingFrame {
 public:
  /// @param box  Must be finite; where it is empty nothing is moved or scaled.
  explicit DrawingFrame(const Box3& box);

  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] double scale() const { return scale_; }
  /// Half the diagonal of the box in drawn coordinates; 1 where the box has none.
  [[nodiscard]] double radius() const { return radius_; }

  /// Returns the drawn coordinates of a place. They are finite and their squares fit into floats:
  /// what is farther away could not be seen beside the mesh anyway, and is drawn nearer.
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
