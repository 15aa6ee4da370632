#pragma once

#include "curvature_peers.h"

namespace meshalyzer::bench {

/// The kind of polynomial z(x, y) that is fitted round a vertex, in the frame of its normal.
struct FitOptions {
  /// So many edges away.
  std::size_t rings = 1;
  /// 2 or 3.
  int degree = 2;
  /// Tells whether the polynomial goes through the vertex at right angles to the normal given, or
  /// both are fitted too.
  enum class Low : std::uint8_t { Fixed, Fitted } constant_and_linear = Low::Fixed;
  /// Tells whether its slopes are to fit those of the neighbours' normals.
  enum class Slopes : std::uint8_t { Free, OfNormals } slopes = Slopes::Free;
};

/// Fits by least squares round each vertex. No answer (NaN) where the points are too few.
[[nodiscard]] std::vector<PrincipalEstimate> fit_polynomials(const TriMesh& mesh,
                                                             const std::vector<Vec3>& normals,
                                                             const FitOptions& options);

/// The principal curvatures at the origin of the graph of a function, whose normal points up.
///
/// @param slope    Its first derivatives there.
/// @param hessian  Its second derivatives.
/// @param frame    The directions of x, y and z.
[[nodiscard]] PrincipalEstimate curvature_of_graph(const Eigen::Vector2d& slope,
                                                   const Eigen::Matrix2d& hessian,
                                                   const Eigen::Matrix3d& frame);

/// Two tangents and the normal, as columns.
[[nodiscard]] Eigen::Matrix3d frame_of(const Vec3& normal);

}  // namespace meshalyzer::bench
