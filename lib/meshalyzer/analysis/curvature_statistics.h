#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/mesh/side_table.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

/// How a surface bends, over the vertices where it has a curvature (CurvatureState::Defined).
struct CurvatureStatistics {
  /// What the curvatures are spread over.
  VertexArea area = VertexArea::Mixed;
  Statistics gaussian;
  /// Signed: positive where the surface bends away from the side its normals point to.
  Statistics mean;
  Statistics k1;
  Statistics k2;
  /// By CurvatureState: how many vertices.
  std::array<std::size_t, kCurvatureStates> vertices{};
  /// Radians, over all vertices that faces use: 2 pi (V - E + F), to rounding (Gauss-Bonnet).
  double total_angle_defect = 0.0;
};

/// Measures the curvature at the vertices of a mesh, and says it in figures.
/// @complexity O(#V + #F).
[[nodiscard]] CurvatureStatistics curvature_statistics(const CutMesh& cut, VertexArea area);

}  // namespace meshalyzer
