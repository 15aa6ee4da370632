#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/tri_mesh.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace meshalyzer {

// The figures of each face that curvatures and normals at vertices need; private to the geometry
// module. The corners of a face are those of face_corners(), in its order.

/// A face scaled to a size near 1, where products of its lengths neither overflow nor vanish.
struct ScaledFace {
  Corners corner;
  /// The corners are in units of 2^exponent; the exponent is 0 except for extreme sizes.
  int exponent = 0;
};

[[nodiscard]] ScaledFace scaled_face(const TriMesh& mesh, FaceHandle face);

/// The normal, angles and area of a face.
struct FaceShape {
  /// The unit normal; zero where the face has no area.
  Vec3 normal = Vec3::Zero();
  /// The angle at each corner in radians. The sum is pi for any face, also for a line (0, 0, pi),
  /// for two points (0 at one, pi / 2 at the two that coincide) and for a single point (pi / 3).
  std::array<double, 3> angle{};
  /// The area in units of 4^exponent.
  double area = 0.0;
  int exponent = 0;

  /// Returns the area in the mesh's unit squared: infinite or zero where it is too large or too
  /// small for a double.
  [[nodiscard]] double true_area() const {
    return exponent == 0 ? area : std::ldexp(area, 2 * exponent);
  }
};

/// Measures the shapes of all faces.
///
/// @return     #mesh faces.
/// @complexity O(#F).
[[nodiscard]] std::vector<FaceShape> measure_face_shapes(const TriMesh& mesh);

/// Returns the corner of its face from which an inner half-edge starts.
[[nodiscard]] inline std::size_t corner_left_by(const TriMesh& mesh, HalfedgeHandle h) {
  // The face's own half-edge enters corner 0, so it leaves corner 2.
  const HalfedgeHandle last = mesh.halfedge_handle(mesh.face_handle(h));
  return h == last ? 2 : h == mesh.next_halfedge_handle(last) ? 0 : 1;
}

}  // namespace meshalyzer
