#pragma once

#include "meshalyzer/mesh/face_parts.h"
#include "meshalyzer/spatial/face_tree.h"

#include <limits>
#include <vector>

namespace meshalyzer {

/// The place of a point with regard to the parts of a mesh.
struct PointLocation {
  /// The parts whose faces a ray from the point meets an odd number of times: where closed, the
  /// point is inside them. Ascending.
  std::vector<Index> odd;
  /// The parts on whose faces the point lies, in which case `odd` says nothing of them. Ascending.
  std::vector<Index> on;
};

/// Follows a ray from a point in the direction of x and counts the faces that it meets, part by
/// part.
///
/// Exact: the ray's start is taken to be displaced by (0, e, e^2) for an e that is smaller than any
/// positive number, so that the ray meets no edge and no vertex (Edelsbrunner and Mücke 1990).
///
/// @param point  Need not be a vertex of the mesh.
/// @param far_x  The ray ends there: what is said of parts that reach beyond means nothing.
/// @complexity   O(log #F + faces whose boxes the ray meets).
[[nodiscard]] PointLocation locate(const FaceTree& tree, const FaceParts& parts, const Vec3& point,
                                   double far_x = std::numeric_limits<double>::infinity());

}  // namespace meshalyzer
