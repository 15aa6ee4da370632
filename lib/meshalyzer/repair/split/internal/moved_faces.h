#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to part_contacts().

/// A mesh in which some vertices are moved by small distances.
class MovedMesh {
 public:
  explicit MovedMesh(const PreparedMesh& mesh) : mesh_(mesh), positions_(mesh.soup().positions) {}

  [[nodiscard]] const Vec3& position(Index vertex) const { return positions_[vertex]; }
  [[nodiscard]] const Triangle& triangle(Index face) const { return mesh_.soup().triangles[face]; }
  [[nodiscard]] Corners corners(const Triangle& t) const { return corners_of(positions_, t); }

  void move(std::span<const Index> vertices, const Vec3& to);

  /// Returns the faces of the complex that may share a point with a box after all moves.
  [[nodiscard]] std::vector<Index> faces_near(const Box3& box) const;

 private:
  const PreparedMesh& mesh_;
  std::vector<Vec3> positions_;
  /// The largest distance by which any vertex has been moved along an axis.
  double reach_ = 0.0;
};

/// Vertices at one position that are to be moved together, and the faces that they may come to
/// touch.
class Move {
 public:
  /// @param mesh      Must outlive this unchanged.
  /// @param vertices  Vertices at one position, ascending.
  /// @param faces     All faces that use them, ascending.
  /// @param reach     The maximum distance by which they may be moved.
  Move(const MovedMesh& mesh, std::span<const Index> vertices, std::span<const Index> faces,
       double reach);

  /// Returns the time that it took to find the faces nearby, as a number of pairs checked.
  [[nodiscard]] std::size_t n_checks_to_find() const { return n_checks_to_find_; }

  /// Returns a box that all faces meet on which the answers depend.
  [[nodiscard]] const Box3& region() const { return region_; }

  /// Tells whether so many faces are near that checking all of them, for every position of a mesh,
  /// would take too long, as in a heap of faces across each other. Then no move is accepted.
  [[nodiscard]] bool is_crowded() const { return is_crowded_; }

  /// Tells whether the vertices can be moved to a position: no face is turned over or loses its
  /// area, and none shares a point with another, except for their common vertices by id, or
  /// elsewhere by position, and except for pairs that do so already, with vertices at one position
  /// counting as one.
  ///
  /// This is not const, because it remembers the obstacle in order to check it first the next time.
  ///
  /// @param to             A position within reach.
  /// @param n_checks_left  The number of pairs of faces that may still be checked; it is reduced by
  /// those that are. If it does not suffice, the position is not accepted.
  [[nodiscard]] bool is_accepted(const Vec3& to, std::size_t& n_checks_left);

 private:
  /// A face that moves, and another that it may touch.
  using Pair = std::array<Index, 2>;

  [[nodiscard]] bool is_moving(Index vertex) const;
  [[nodiscard]] bool is_at_place(Index face) const;
  [[nodiscard]] Corners moved_corners(const Triangle& t, const Vec3& to) const;
  [[nodiscard]] bool keeps_its_side(const Triangle& t, const Vec3& to) const;
  [[nodiscard]] bool would_touch(const Pair& pair, const Vec3& to) const;
  [[nodiscard]] bool touched_before(const Pair& pair) const;

  const MovedMesh& mesh_;
  std::span<const Index> vertices_;
  std::span<const Index> faces_;
  Box3 region_;
  bool is_crowded_ = false;
  std::size_t n_checks_to_find_ = 0;
  /// The pairs that may come into contact, the most likely first.
  std::vector<Pair> pairs_;
};

}  // namespace meshalyzer
