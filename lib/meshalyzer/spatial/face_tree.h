#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <array>
#include <span>
#include <vector>

namespace meshalyzer {

struct EightBoxes;

/// One box in the coordinates of a FaceTree.
struct TreeBox {
  std::array<float, 3> low;
  std::array<float, 3> high;

  /// Returns the box that holds all of `boxes`.
  [[nodiscard]] static TreeBox around(const EightBoxes& boxes);
};

/// Eight axis-aligned boxes side by side, so that one loop tests them all.
///
/// Their coordinates are the mesh's own under a monotone map to float (see FaceTree): boxes that
/// meet in space meet here, whatever the rounding.
struct alignas(32) EightBoxes {
  std::array<std::array<float, 8>, 3> min;
  std::array<std::array<float, 8>, 3> max;

  /// All eight empty: they meet nothing.
  [[nodiscard]] static EightBoxes empty();
  [[nodiscard]] TreeBox box(std::size_t i) const {
    return {{min[0][i], min[1][i], min[2][i]}, {max[0][i], max[1][i], max[2][i]}};
  }
  /// Bit i is set where box i meets `other`, which is bounded along at least one axis.
  [[nodiscard]] unsigned meeting(const TreeBox& other) const;
};

/// The file vertices of eight faces side by side, corner by corner; kNoIndex where there are fewer.
struct alignas(32) EightFaces {
  std::array<std::array<Index, 8>, 3> corners;
};

/// A bounding volume hierarchy over the faces of a mesh: an implicit, complete tree of eight
/// children a node.
///
/// Faces are ordered by splitting at the median of the widest axis, so the depth is logarithmic for
/// any input; the nodes need no pointers. Holds the faces' vertices in tree order too, for
/// locality; refers to the mesh's points, so the mesh must outlive it unchanged.
class FaceTree {
 public:
  /// @complexity O(#F log #F) time; 48 bytes a face.
  explicit FaceTree(const CutMesh& cut);

  [[nodiscard]] std::size_t n_faces() const { return mesh_faces_.size(); }
  [[nodiscard]] std::size_t n_leaves() const { return levels_.front().size(); }
  /// Number of levels; level 0 boxes faces, eight a leaf; each level boxes the nodes of the one
  /// below.
  [[nodiscard]] std::size_t n_levels() const { return levels_.size(); }
  [[nodiscard]] const EightBoxes& node(std::size_t level, std::size_t i) const {
    return levels_[level][i];
  }

  [[nodiscard]] const EightFaces& leaf_faces(std::size_t i) const { return faces_[i]; }

  /// Returns the file vertices, or the mesh face, of a slot, the face's place in the tree (leaf i
  /// holds slots 8 i ... 8 i + 7).
  [[nodiscard]] Triangle triangle(std::size_t slot) const {
    const auto& corners = faces_[slot / 8].corners;
    return {corners[0][slot % 8], corners[1][slot % 8], corners[2][slot % 8]};
  }
  [[nodiscard]] Index mesh_face(std::size_t slot) const { return mesh_faces_[slot]; }
  [[nodiscard]] const Vec3& point(Index file_vertex) const { return points_[file_vertex]; }

  /// Returns the box of the faces' corners in the file's own coordinates; it is empty where there
  /// are no faces.
  [[nodiscard]] const Box3& bounds() const { return bounds_; }
  /// The coordinates of the boxes are (point - centre) * scale, rounded; about -1 ... 1 for points
  /// of the mesh.
  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] double scale() const { return scale_; }
  /// Returns the place of a point in the coordinates of the boxes: monotone in each coordinate.
  [[nodiscard]] std::array<float, 3> map(const Vec3& point) const;

 private:
  void choose_map(std::span<const Triangle> triangles);
  void order_faces(std::span<const Triangle> triangles);
  void box_faces();
  void box_levels();

  std::span<const Vec3> points_;
  Box3 bounds_;
  Vec3 centre_ = Vec3::Zero();
  double scale_ = 1.0;
  std::vector<EightFaces> faces_;
  std::vector<Index> mesh_faces_;
  std::vector<std::vector<EightBoxes>> levels_;
};

}  // namespace meshalyzer
