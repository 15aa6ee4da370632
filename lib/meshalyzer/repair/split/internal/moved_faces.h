#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to part_contacts().

/// A mesh some of whose vertices are being moved by little.
class MovedMesh {
 public:
  explicit MovedMesh(const PreparedMesh& mesh) : mesh_(mesh), positions_(mesh.soup().positions) {}

  [[nodiscard]] const Vec3& position(Index vertex) const { return positions_[vertex]; }
  [[nodiscard]] const Triangle& triangle(Index face) const { return mesh_.soup().triangles[face]; }
  [[nodiscard]] Corners corners(const Triangle& t) const {
    return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
  }

  void move(std::span<const Index> vertices, const Vec3& to);

  /// Returns faces of the complex that may share a point with a box, whatever has moved; ascending.
  [[nodiscard]] std::vector<Index> faces_near(const Box3& box) const;

 private:
  const PreparedMesh& mesh_;
  std::vector<Vec3> positions_;
  /// Tells how far any vertex has been moved along an axis.
  double reach_ = 0.0;
};

/// Vertices at one place that are to be moved as one, and what they may come to touch.
class Move {
 public:
  /// @param mesh      Must outlive this unchanged.
  /// @param vertices  At one place; ascending.
  /// @param faces     All that use them, ascending.
  /// @param reach     How far they may be moved.
  Move(const MovedMesh& mesh, std::span<const Index> vertices, std::span<const Index> faces,
       double reach);

  [[nodiscard]] double reach() const { return reach_; }

  /// Tells whether so many faces are near that looking at all of them, for every place of a mesh,
  /// would never end: a heap of faces across each other. Then nothing is accepted.
  [[nodiscard]] bool is_crowded() const { return is_crowded_; }

  /// Tells whether the vertices can go there: no face is turned over or loses its area, and none
  /// shares a point with another, but for what they have in common by id, or elsewhere by place,
  /// and for those that do so already, vertices at one place counting as one.
  ///
  /// This is not const, because it remembers what was in the way in order to check that first the
  /// next time.
  ///
  /// @param to  Within reach.
  [[nodiscard]] bool is_accepted(const Vec3& to);

 private:
  /// A face that moves, and another.
  using Pair = std::array<Index, 2>;

  [[nodiscard]] Box3 box_of(Index face) const;
  [[nodiscard]] bool is_moving(Index vertex) const;
  [[nodiscard]] bool is_at_place(Index face) const;
  [[nodiscard]] Corners moved_corners(const Triangle& t, const Vec3& to) const;
  [[nodiscard]] bool keeps_its_side(const Triangle& t, const Vec3& to) const;
  [[nodiscard]] bool would_touch(const Pair& pair, const Vec3& to) const;
  [[nodiscard]] bool touched_before(const Pair& pair) const;

  const MovedMesh& mesh_;
  std::span<const Index> vertices_;
  std::span<const Index> faces_;
  double reach_;
  bool is_crowded_ = false;
  /// The pairs that may come into contact, the likeliest first.
  std::vector<Pair> pairs_;
};

}  // namespace meshalyzer
