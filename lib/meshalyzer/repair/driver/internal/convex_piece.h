#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/triangle.h"

#include <array>
#include <cstddef>
#include <span>

namespace meshalyzer {

/// The points that lie less far than a length from a point, along a direction.
struct HalfSpace {
  Vec3 point;
  /// A direction that leads out of it, of length 1.
  Vec3 outward;
  double reach = 0.0;

  /// Returns how far a point lies outside; negative inside.
  [[nodiscard]] double excess(const Vec3& p) const { return (p - point).dot(outward) - reach; }
};

/// Returns a point between two others, without overflow: the first at 0, the second at 1.
[[nodiscard]] inline Vec3 between(const Vec3& a, const Vec3& b, double at) {
  return (1.0 - at) * a + at * b;
}

/// A convex polygon that was cut out of a triangle; of one of zero area, the segment or point that
/// it is, with three or more corners.
class ConvexPiece {
 public:
  /// The largest number of corners; a cut adds one at most.
  static constexpr std::size_t kMostCorners = 24;

  /// Makes a piece without corners.
  ConvexPiece() = default;
  explicit ConvexPiece(const Corners& triangle);

  [[nodiscard]] std::span<const Vec3> corners() const {
    return std::span(corners_).first(n_corners_);
  }
  [[nodiscard]] bool empty() const { return n_corners_ == 0; }
  /// Returns the mean of the corners, without overflow.
  [[nodiscard]] Vec3 middle() const;
  [[nodiscard]] Box3 box() const;
  /// Returns the area where a length is the unit.
  [[nodiscard]] double area(double unit) const;
  /// Returns the two corners that are farthest from each other.
  [[nodiscard]] std::array<Vec3, 2> diameter() const;

  struct Parts;
  /// Cuts the piece at the plane of a half-space. The parts that are empty have no corners. If the
  /// plane runs so close along a thin piece that it seems to cross it more than once, all of it
  /// counts as inside.
  [[nodiscard]] Parts cut(const HalfSpace& half_space) const;
  /// Cuts a piece with at least four corners in two between opposite ones.
  [[nodiscard]] Parts cut_between_corners() const;
  /// Returns the part in a box, without corners if there is none. It may reach out of the box where
  /// the piece is so thin that cut() takes all of it as inside.
  [[nodiscard]] ConvexPiece part_in(const Box3& box) const;

 private:
  void add(const Vec3& corner) { corners_[n_corners_++] = corner; }

  std::array<Vec3, kMostCorners> corners_;
  std::size_t n_corners_ = 0;
};

/// The parts of a piece that was cut.
struct ConvexPiece::Parts {
  ConvexPiece inside;
  ConvexPiece outside;
};

}  // namespace meshalyzer
