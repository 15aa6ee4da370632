#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/spatial/box_frame.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

struct EightBoxes;

/// An axis-aligned box in the coordinates of a FaceTree.
struct TreeBox {
  std::array<float, 3> low;
  std::array<float, 3> high;

  /// Returns the box that holds all of `boxes`.
  [[nodiscard]] static TreeBox around(const EightBoxes& boxes);
};

/// Eight axis-aligned boxes side by side, so that one loop tests them all.
///
/// Their coordinates are those of the mesh in the tree's frame, under a monotone map to float (see
/// FaceTree), so boxes that meet in space meet here in spite of rounding.
struct alignas(32) EightBoxes {
  std::array<std::array<float, 8>, 3> min;
  std::array<std::array<float, 8>, 3> max;

  /// Returns eight empty boxes, which meet nothing.
  [[nodiscard]] static EightBoxes empty();
  [[nodiscard]] TreeBox box(std::size_t i) const {
    return {{min[0][i], min[1][i], min[2][i]}, {max[0][i], max[1][i], max[2][i]}};
  }
  void set(std::size_t i, const TreeBox& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      min[k][i] = box.low[k];
      max[k][i] = box.high[k];
    }
  }
  /// Returns a mask in which bit i is set if box i meets `other`, which is bounded along at least
  /// one axis.
  [[nodiscard]] unsigned meeting(const TreeBox& other) const;
};

/// Returns the nodes above others in a tree: the box of each eight of these.
[[nodiscard]] std::vector<EightBoxes> boxes_above(std::span<const EightBoxes> below);

/// The file vertices of eight faces side by side, corner by corner; kNoIndex for missing faces.
struct alignas(32) EightFaces {
  std::array<std::array<Index, 8>, 3> corners;
};

/// A bounding volume hierarchy over the faces of a mesh: an implicit, complete tree with eight
/// children per node.
///
/// Faces are ordered by splits at medians (order_for_tree), so the depth is logarithmic for any
/// input; the nodes need no pointers. The tree also holds the faces' vertices in tree order,
/// for locality. It refers to the points of the mesh, which must outlive it unchanged.
///
/// If a few faces reach a thousand times farther than all others, the coordinates of boxes are
/// those of the others, because in floats made for all of them the others would be one point. What
/// lies outside is moved to the nearest place within -2 ... 2: that is monotone, too, and takes no
/// two points farther apart.
///
/// The frame of the boxes is that of the file, or for a search among the tree's own faces a turned
/// one, where map() and all else in the coordinates of boxes takes places in that frame (placed()).
class FaceTree {
 public:
  /// @complexity O(#F log #F) time; 48 bytes a face.
  explicit FaceTree(const CutMesh& cut);
  /// Makes a tree over some faces of a mesh.
  ///
  /// @param mesh_faces  Ascending, each once.
  FaceTree(const CutMesh& cut, std::span<const Index> mesh_faces);
  /// Makes a tree over the faces of another one, with boxes along other axes. Everything but
  /// bounds() that has coordinates is then in its frame.
  FaceTree(const FaceTree& other, const BoxFrame& frame);

  [[nodiscard]] std::size_t n_faces() const { return mesh_faces_.size(); }
  [[nodiscard]] std::size_t n_leaves() const { return levels_.front().size(); }
  /// Returns the number of levels. Level 0 has the boxes of faces, eight per leaf; each other level
  /// has the boxes of the nodes below.
  [[nodiscard]] std::size_t n_levels() const { return levels_.size(); }
  [[nodiscard]] const EightBoxes& node(std::size_t level, std::size_t i) const {
    return levels_[level][i];
  }

  [[nodiscard]] const EightFaces& leaf_faces(std::size_t i) const { return faces_[i]; }

  /// Returns the file vertices of the face at a slot, its place in the tree (leaf i holds slots 8 i
  /// ... 8 i + 7).
  [[nodiscard]] Triangle triangle(std::size_t slot) const {
    const auto& corners = faces_[slot / 8].corners;
    return {corners[0][slot % 8], corners[1][slot % 8], corners[2][slot % 8]};
  }
  [[nodiscard]] Index mesh_face(std::size_t slot) const { return mesh_faces_[slot]; }
  [[nodiscard]] const Vec3& point(Index file_vertex) const { return points_[file_vertex]; }
  /// Returns the place of a vertex in the frame of the boxes: point() itself, or turned, with an
  /// error that the boxes allow for.
  [[nodiscard]] Vec3 placed(Index file_vertex) const {
    const Vec3& p = points_[file_vertex];
    return frame_ ? frame_->place_of(p) : p;
  }
  /// Returns the positions of the corners of the face at a slot.
  [[nodiscard]] Corners corners(std::size_t slot) const {
    return corners_of(points_, triangle(slot));
  }
  /// Returns the number of points, file vertices and their copies.
  [[nodiscard]] std::size_t n_points() const { return points_.size(); }

  /// Returns the box of the faces' corners in the file's own coordinates; it is empty where there
  /// are no faces.
  [[nodiscard]] const Box3& bounds() const { return bounds_; }
  /// Returns the centre in the map of points to the coordinates of boxes, (point - centre) * scale,
  /// rounded; points of the mesh that are not far are mapped to about -1 ... 1.
  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] double scale() const { return scale_; }
  /// Maps a point to the coordinates of the boxes, monotonically in each coordinate.
  [[nodiscard, gnu::always_inline]] inline std::array<float, 3> map(const Vec3& point) const {
    // Rounded subtraction, multiplication by a positive factor, conversion and clamping are
    // monotone, so their composition is.
    const auto place = [&](Eigen::Index k) {
      const auto x = static_cast<float>((point[k] - centre_[k]) * scale_);
      // Unlike std::clamp(), this compiles to two instructions without a branch.
      return std::min(std::max(x, -limit_), limit_);
    };
    return {place(0), place(1), place(2)};
  }

  /// Returns the box of a vertex: one place, but for a turned tree.
  [[nodiscard]] TreeBox box_of_vertex(Index file_vertex) const {
    const Vec3 place = placed(file_vertex);
    return {map(place.array() - margin_), map(place.array() + margin_)};
  }

  /// Maps a point likewise, and brings it to -farthest ... farthest along each axis.
  [[nodiscard]] std::array<float, 3> map_within(const Vec3& point, float farthest) const;

  /// Tells whether some faces are so far from the others that their boxes are in another place.
  [[nodiscard]] bool has_far_faces() const { return !is_far_leaf_.empty(); }
  /// Tells whether a leaf has such a face. Only the boxes of its faces may be compared with others.
  [[nodiscard]] bool is_far_leaf(std::size_t leaf) const {
    return has_far_faces() && is_far_leaf_[leaf] != 0;
  }
  /// Tells whether a point may be in another place than (point - centre) * scale.
  [[nodiscard]] bool is_far(const Vec3& point) const;

 private:
  [[nodiscard]] TreeBox box_of(const Triangle& t) const;
  void make(std::vector<Triangle> triangles);
  [[nodiscard]] Box3 box_of_places(std::span<const Triangle> triangles) const;
  void choose_map(std::span<const Triangle> triangles);
  [[nodiscard]] bool choose_map_of_most(std::span<const Triangle> triangles, const Box3& all);
  void set_map(const Box3& box);
  void order_faces(std::span<const Triangle> triangles);
  void box_faces();
  void box_levels();
  void mark_far_leaves();

  std::span<const Vec3> points_;
  /// The frame of the boxes, if it is not that of the points, and by how much boxes are wider than
  /// the rounded places of corners on each side.
  std::optional<BoxFrame> frame_;
  double margin_ = 0.0;
  Box3 bounds_;
  Vec3 centre_ = Vec3::Zero();
  double scale_ = 1.0;
  /// The largest coordinate of a box.
  float limit_ = std::numeric_limits<float>::infinity();
  std::vector<EightFaces> faces_;
  std::vector<Index> mesh_faces_;
  std::vector<std::vector<EightBoxes>> levels_;
  /// #leaves: non-zero for those with a far face; empty if there is none.
  std::vector<std::uint8_t> is_far_leaf_;
};

}  // namespace meshalyzer
