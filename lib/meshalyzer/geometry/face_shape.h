#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/tri_mesh.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace meshalyzer {

// Private to the geometry module: what curvatures and normals at vertices need of each face. The
// corners of a face are those of face_corners(), in its order.

/// A face at a size near 1, where products of its lengths neither overflow nor vanish.
struct ScaledFace {
  Corners corner;
  /// The corners are in units of 2^exponent; 0 at all sizes but extreme ones.
  int exponent = 0;
};

[[nodiscard]] ScaledFace scaled_face(const TriMesh& mesh, FaceHandle face);

/// Directions, angles and size of a face.
struct FaceShape {
  /// The unit normal; zero where the face has no area.
  Vec3 normal = Vec3::Zero();
  /// Radians, at each corner; pi in all for any face, also where it is a line (0, 0, pi), two
  /// points (0 at one, pi / 2 at the two that coincide) or one (pi / 3).
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

/// A sum of weighted unit normals that is this much shorter than the weights that went into it has
/// no digits left: the faces cancel each other.
inline constexpr double kNormalsCancel = 1e-12;

/// Measures all faces.
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
