#pragma once

#include "meshalyzer/geometry/corner_shares.h"
#include "meshalyzer/geometry/face_shape.h"
#include "meshalyzer/geometry/fan_sums.h"

#include <vector>

namespace meshalyzer {

// Private to the geometry module.

/// The principal curvatures at a vertex: see Curvature.
struct PrincipalCurvature {
  double k1 = 0.0;
  double k2 = 0.0;
  Vec3 direction1 = Vec3::Zero();
  Vec3 direction2 = Vec3::Zero();
};

/// Estimates the principal curvatures at all vertices from how the normals turn along the faces'
/// edges: the second fundamental form of each face is fitted by least squares and averaged at the
/// vertices by area (Rusinkiewicz 2004, "Estimating curvatures and their derivatives on triangle
/// meshes").
///
/// The normals are fitted_normals() with FanSums::sphere_normal as given normals. The curvatures of
/// any mesh whose vertices lie on a sphere are exact.
///
/// Faces without area are ignored.
///
/// @param sums   The sums at the vertices, of which only the normals are used.
/// @param mixed  The shares of VertexArea::Mixed.
/// @return       #mesh vertices: the curvatures, each from its own fan. They may be NaN or infinite
///               where there is no area or no normal, or where they overflow.
/// @complexity   O(#F).
[[nodiscard]] std::vector<PrincipalCurvature> principal_curvatures(
    const TriMesh& mesh, const std::vector<FaceShape>& shapes, const std::vector<FanSums>& sums,
    const std::vector<CornerShares>& mixed);

}  // namespace meshalyzer
