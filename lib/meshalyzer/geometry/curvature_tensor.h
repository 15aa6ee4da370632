#pragma once

#include "meshalyzer/geometry/face_shape.h"

#include <array>

namespace meshalyzer {

// Private to the geometry module.

/// A symmetric 3 x 3 matrix that maps a direction in a face to the change of the normal along it.
struct CurvatureTensor {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  [[nodiscard]] Vec3 operator*(const Vec3& p) const {
    return {xx * p.x() + xy * p.y() + xz * p.z(), xy * p.x() + yy * p.y() + yz * p.z(),
            xz * p.x() + yz * p.y() + zz * p.z()};
  }
};

/// Returns the second fundamental form of a face multiplied by its area, so that it is finite for
/// any thin face.
///
/// @param shape    The shape of the face; its area must not be zero.
/// @param normals  The unit normals at its corners.
[[nodiscard]] CurvatureTensor fit_curvature(const ScaledFace& face, const FaceShape& shape,
                                            const std::array<Vec3, 3>& normals);

}  // namespace meshalyzer
