#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Says what find_closest() looks for.
struct ClosestQuery {
  Vec3 point;
  /// Leaves out points that are farther away than this.
  double within = std::numeric_limits<double>::infinity();
  /// Leaves out points outside this cone, whose apex is `point`.
  std::optional<Cone> cone = std::nullopt;
  /// #mesh faces, those with a non-zero entry are left out; empty: none are. Only referred to.
  std::span<const std::uint8_t> excluded = {};
  /// Slot of a face that is likely to be near, such as SurfacePoint::slot of a neighbour's answer.
  /// Saves time; the answer does not depend on it.
  Index hint = kNoIndex;
};

/// A point of a mesh, and how far it is from the point asked for.
struct SurfacePoint {
  Vec3 point;
  /// The distance in the mesh's unit, see closest_on_triangle().
  double distance = 0.0;
  Index mesh_face = kNoIndex;
  /// The face's place in the tree.
  Index slot = kNoIndex;
};

/// The corners of eight faces side by side, in the coordinates of a FaceTree; NaN where there are
/// fewer, which is never near anything.
struct alignas(32) EightTriangles {
  /// The coordinates, by corner, coordinate, and face.
  std::array<std::array<std::array<float, 8>, 3>, 3> corners;

  [[nodiscard]] static EightTriangles none();
};

/// Finds the points of a mesh that are closest to given ones.
class ClosestPoints {
 public:
  /// @param tree  Must outlive this.
  /// @complexity  O(#F) time; 36 bytes a face.
  explicit ClosestPoints(const FaceTree& tree);

  /// Returns the closest point of the mesh.
  ///
  /// The same bits as closest_on_triangle() of every face give: the smallest of these distances,
  /// and of several faces at this distance the first. Safe to call from several threads.
  ///
  /// @param query  Its point is finite and may lie anywhere.
  /// @return       Nothing where no face has such a point.
  /// @complexity   O(log #F) on average; all faces where they are equally far but for rounding.
  [[nodiscard]] std::optional<SurfacePoint> find(const ClosestQuery& query) const;

 private:
  const FaceTree& tree_;
  std::vector<EightTriangles> triangles_;
};

}  // namespace meshalyzer
