#pragma once

#include "meshalyzer/mesh/face_parts.h"
#include "meshalyzer/spatial/face_tree.h"

#include <limits>
#include <vector>

namespace meshalyzer {

/// The location of a point relative to the parts of a mesh.
struct PointLocation {
  /// The parts whose faces a ray from the point meets an odd number of times, ascending: the point
  /// is inside those that are closed.
  std::vector<Index> odd;
  /// The parts on whose faces the point lies, ascending; `odd` has no meaning for these.
  std::vector<Index> on;
};

/// Follows a ray from a point in the direction of x and counts the faces that it meets, part by
/// part.
///
/// The answer is exact: the start of the ray is symbolically displaced by (0, e, e^2), with e
/// smaller than any positive number, so that the ray meets no edge and no vertex (Edelsbrunner and
/// Mücke 1990).
///
/// @param point  Any point; it need not be a vertex of the mesh.
/// @param far_x  The x at which the ray ends: the result has no meaning for parts that reach
///               beyond.
/// @complexity   O(log #F + faces whose boxes the ray meets).
[[nodiscard]] PointLocation locate(const FaceTree& tree, const FaceParts& parts, const Vec3& point,
                                   double far_x = std::numeric_limits<double>::infinity());

}  // namespace meshalyzer
