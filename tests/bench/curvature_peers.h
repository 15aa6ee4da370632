#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer::bench {

/// k1 >= k2 and unit tangents, zero where a method has none; NaN where it gives no answer.
struct PrincipalEstimate {
  double k1 = 0.0;
  double k2 = 0.0;
  Vec3 direction1 = Vec3::Zero();
  Vec3 direction2 = Vec3::Zero();
};

/// A published way to estimate curvature, as its paper has it: clear, not fast.
struct CurvatureMethod {
  std::string_view name;
  /// At each vertex of a mesh.
  std::vector<PrincipalEstimate> (*estimate)(const TriMesh& mesh);
};

/// - Meyer, Desbrun, Schröder and Barr 2003, "Discrete differential-geometry operators for
///   triangulated 2-manifolds": H +- sqrt(H^2 - K) with the mixed area, without directions
/// - Taubin 1995, "Estimating the tensor of curvature of a surface from a polyhedral
///   approximation"
/// - Rusinkiewicz 2004, "Estimating curvatures and their derivatives on triangle meshes"
/// - Hamann 1993, "Curvature approximation for triangulated surfaces": a quadric through the
///   vertex in the frame of its normal, fitted to its neighbours
/// - Goldfeather and Interrante 2004, "A novel cubic-order algorithm for approximating principal
///   direction vectors": a cubic fitted to the neighbours and their normals
/// - Cazals and Pouget 2005, "Estimating differential quantities using polynomial fitting of
///   osculating jets": of degree 2 and 3, fitted to two rings
///
/// All but the last begin with vertex normals; all get the same (Max 1999, "Weights for computing
/// vertex normals from facet normals"), so that the methods are compared and not the normals.
[[nodiscard]] std::span<const CurvatureMethod> published_methods();

}  // namespace meshalyzer::bench
