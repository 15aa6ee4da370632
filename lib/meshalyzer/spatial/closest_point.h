#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// A query to ClosestPoints::find().
struct ClosestQuery {
  Vec3 point;
  /// Points farther away than this are ignored.
  double within = std::numeric_limits<double>::infinity();
  /// Points outside this cone, whose apex is `point`, are ignored.
  std::optional<Cone> cone = std::nullopt;
  /// #mesh faces: faces with a non-zero entry are ignored. It may be empty; the query only refers
  /// to it.
  std::span<const std::uint8_t> excluded = {};
  /// Faces for which this returns false are ignored. It may be null, which ignores none; the query
  /// only refers to it.
  const std::function<bool(Index mesh_face)>* is_wanted = nullptr;
  /// The slot of a face that is likely to be near, such as SurfacePoint::slot of a neighbour's
  /// answer. It saves time; the answer depends on it only if any face will do.
  Index hint = kNoIndex;
  /// If it is given, any face within this distance will do, if there is one: the search ends at the
  /// first that is found. Zero, for any face that the point lies on, saves much time where very
  /// many faces lie on each other. At least 0.
  std::optional<double> near_enough = std::nullopt;
};

/// A point of a mesh, and its distance to the query point.
struct SurfacePoint {
  Vec3 point;
  /// The distance in the mesh's unit, see closest_on_triangle().
  double distance = 0.0;
  Index mesh_face = kNoIndex;
  /// The slot of the face in the tree.
  Index slot = kNoIndex;
};

/// The corners of eight faces side by side, in the coordinates of a FaceTree. Missing faces are
/// NaN, which is never near anything.
struct alignas(32) EightTriangles {
  /// The coordinates, by corner, coordinate, and face.
  std::array<std::array<std::array<float, 8>, 3>, 3> corners;

  [[nodiscard]] static EightTriangles none();
};

/// Eight boxes side by side, each along three directions of its own, in the coordinates of a
/// FaceTree: those of eight leaves, which fit them better than boxes along the axes.
struct alignas(32) EightOrientedBoxes {
  /// The coordinates of the directions, by direction, coordinate, and box.
  std::array<std::array<std::array<float, 8>, 3>, 3> axes;
  /// From where to where each box reaches along its directions.
  std::array<std::array<float, 8>, 3> low;
  std::array<std::array<float, 8>, 3> high;
};

/// Finds the points of a mesh that are closest to given ones.
class ClosestPoints {
 public:
  /// @param tree  The tree, which must outlive this object.
  /// @complexity  O(#F) time; 44 bytes a face.
  explicit ClosestPoints(const FaceTree& tree);

  /// Returns the closest point of the mesh.
  ///
  /// The answer is the same, to the bit, as that of closest_on_triangle() for all faces: the
  /// smallest distance, and the first of several faces at this distance; or else that of any face
  /// that the query calls near enough. Several threads may call it at a time.
  ///
  /// @return       Nothing if no face has such a point, or if the query's point is not finite.
  /// @complexity   O(log #F) on average; O(#F) if all faces are equally far up to rounding.
  [[nodiscard]] std::optional<SurfacePoint> find(const ClosestQuery& query) const;

  /// Tells whether the mesh may come as near to a box as `distance`. If it does not, no point in
  /// the box has an answer within this distance.
  ///
  /// @param box       A box that is not empty.
  /// @param distance  At least 0; it may be infinite.
  /// @complexity      O(log #F) for a box that is small beside the distance.
  [[nodiscard]] bool may_be_within(const Box3& box, double distance) const;

  /// Returns the bytes of memory that it takes for a mesh.
  [[nodiscard]] static std::uint64_t bytes_for(std::size_t n_faces);

 private:
  const FaceTree& tree_;
  std::vector<EightTriangles> triangles_;
  /// The boxes of each eight leaves.
  std::vector<EightOrientedBoxes> leaf_boxes_;
};

}  // namespace meshalyzer
