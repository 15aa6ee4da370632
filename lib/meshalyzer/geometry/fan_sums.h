#pragma once

#include "meshalyzer/geometry/corner_shares.h"
#include "meshalyzer/geometry/face_shape.h"
#include "meshalyzer/geometry/vertex_normals.h"

#include <vector>

namespace meshalyzer {

// Private to the geometry module.

/// The sums over the faces round a vertex of the mesh.
struct FanSums {
  /// The sum of the angles, in radians.
  double angle = 0.0;
  /// The sum of the vertex's shares of the faces' areas.
  double area = 0.0;
  /// The sum of (cot alpha + cot beta) (p - q) over the neighbours q of p: 4 A H n, twice the
  /// gradient of the area.
  Vec3 cotangent = Vec3::Zero();
  /// The sum of the unit normals weighted by angle; not a unit vector.
  Vec3 normal = Vec3::Zero();
  /// The sum of the normals with the weights of Max 1999, "Weights for computing vertex normals
  /// from facet normals": area over the squared lengths of the two sides at the vertex. It is exact
  /// where the vertices lie on a sphere; it is zero or NaN where the squares of sides overflow or
  /// underflow.
  Vec3 sphere_normal = Vec3::Zero();

  /// Tells whether the faces face a common side, which they do not if they lie back to back.
  [[nodiscard]] bool has_normal() const { return normal.norm() > kNormalsCancel * angle; }
};

/// Computes the sums at all vertices.
///
/// @return     #mesh vertices: the sums; a copy of a vertex has those of its own fan.
/// @complexity O(#F).
[[nodiscard]] std::vector<FanSums> sum_fans(const TriMesh& mesh,
                                            const std::vector<FaceShape>& shapes,
                                            const std::vector<CornerShares>& shares);

}  // namespace meshalyzer
