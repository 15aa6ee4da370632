#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/spatial/face_tree.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// The winding numbers of a closed set of triangles, by the crossings of a ray: a ray that leaves
/// the surface through its front counts 1, one that enters it counts -1.
///
/// All rays are parallel, in a direction that hardly any face is parallel to.
class RayWindings {
 public:
  /// @param triangles  Triangles along whose edges equally many run in both directions
  ///                   (closing_triangles()), with coordinates of about -1 ... 1.
  /// @param near       A point within this distance of a triangle may be on it.
  /// @complexity       O(n log n).
  RayWindings(std::span<const Corners> triangles, double near);

  /// Returns the winding numbers at two points; if they are near each other, both take little more
  /// than one.
  ///
  /// @return     Nothing if a ray passes so close to an edge that rounding might decide, or begins
  ///             on a triangle.
  /// @complexity O(log n + crossings) on average.
  [[nodiscard]] std::optional<std::array<int, 2>> at_both(const Vec3& first,
                                                          const Vec3& second) const;

 private:
  class TwoRays;

  double near_;
  /// The triangles in the order of the tree, turned so that the rays run along x.
  std::vector<Corners> triangles_;
  /// Level 0 has the boxes of triangles, eight together; each other level those of the eight nodes
  /// below.
  std::vector<std::vector<EightBoxes>> levels_;
};

}  // namespace meshalyzer
