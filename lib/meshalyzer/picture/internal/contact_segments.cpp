#include "meshalyzer/picture/internal/contact_segments.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Lengths in units of the size of the pair. A point this near to a triangle counts as on it, for
/// clipping (kClipTolerance) and if clipping finds nothing (kNear); a segment this short counts as
/// a point.
constexpr double kClipTolerance = 1e-12;
constexpr double kNear = 1e-10;
constexpr double kPoint = 1e-9;

/// The number of iterations towards a common point. Each comes closer unless the triangles are
/// nearly parallel.
constexpr int kProjections = 64;

/// Coordinates about the centre of a pair of triangles in which the pair has the size 1.
class PairScale {
 public:
  PairScale(const Corners& p, const Corners& q) {
    const Box3 box = box_of(p).extend(box_of(q));
    middle_ = middle_of(box);
    const double half = half_widths_of(box).maxCoeff();
    if (half > 0.0) half_ = half;
  }

  [[nodiscard]] Corners scaled(const Corners& t) const {
    return {(t[0] - middle_) / half_, (t[1] - middle_) / half_, (t[2] - middle_) / half_};
  }
  [[nodiscard]] Vec3 unscaled(const Vec3& point) const { return middle_ + point * half_; }

 private:
  Vec3 middle_;
  double half_ = 1.0;
};

/// The corners of a convex planar polygon, up to the rounding errors of clipping.
struct Polygon {
  /// The remaining corners. Each clipping turns n corners into at most n - 1 and one for each
  /// change of sign.
  std::array<Vec3, ContactSegments::kMax> corners;
  std::size_t count = 0;

  void add(const Vec3& corner) {
    if (count < corners.size()) corners[count++] = corner;
  }
};

/// A half-space: the points x with direction . (x - origin) >= -kClipTolerance.
struct HalfSpace {
  Vec3 origin;
  Vec3 direction;

  [[nodiscard]] double height(const Vec3& x) const {
    return direction.dot(x - origin) + kClipTolerance;
  }
};

Polygon clip(const Polygon& polygon, const HalfSpace& half_space) {
  Polygon clipped;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3& a = polygon.corners[i];
    const Vec3& b = polygon.corners[i + 1 == polygon.count ? 0 : i + 1];
    const double height_a = half_space.height(a);
    const double height_b = half_space.height(b);
    if (height_a >= 0.0) clipped.add(a);
    if ((height_a >= 0.0) != (height_b >= 0.0)) {
      clipped.add(a + height_a / (height_a - height_b) * (b - a));
    }
  }
  return clipped;
}

/// Returns the part of a triangle that lies on another one with this normal; it is a thin strip if
/// their planes cross.
Polygon clip_to_triangle(const Corners& p, const Corners& q, const Vec3& normal) {
  Polygon polygon{{p[0], p[1], p[2]}, 3};
  const Vec3 up = normal.stableNormalized();
  polygon = clip(clip(polygon, {q[0], up}), {q[0], -up});
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 along = (q[(i + 1) % 3] - q[i]).stableNormalized();
    polygon = clip(polygon, {q[i], up.cross(along)});
  }
  return polygon;
}

/// Returns the direction of the longest edge, or zero if the triangle is a point.
Vec3 direction_of(const Corners& t) {
  const std::array edges{Vec3(t[1] - t[0]), Vec3(t[2] - t[1]), Vec3(t[0] - t[2])};
  const auto longest = std::max_element(
      edges.begin(), edges.end(),
      [](const Vec3& a, const Vec3& b) { return a.stableNorm() < b.stableNorm(); });
  return longest->stableNormalized();
}

/// Returns the point of the line along p that is closest to the line along q, or the middle of p if
/// the lines are parallel.
Vec3 crossing_of_lines(const Corners& p, const Corners& q) {
  const Vec3 along_p = direction_of(p);
  const Vec3 along_q = direction_of(q);
  const Vec3 upright = along_p.cross(along_q);
  if (upright.isZero(0.0)) return (p[0] + p[1] + p[2]) / 3;
  const Vec3 across_q = along_q.cross(upright);
  return p[0] + across_q.dot(q[0] - p[0]) / upright.squaredNorm() * along_p;
}

/// Finds a common point of two triangles by alternating projections.
///
/// Two triangles of zero area, which have no plane to clip by, start at the point where they cross:
/// at a small angle the iteration would converge too slowly.
Vec3 common_point(const Corners& p, const Corners& q) {
  Vec3 point = crossing_of_lines(p, q);
  for (int i = 0; i < kProjections; ++i) {
    point = closest_on_triangle(p, closest_on_triangle(q, point).point).point;
  }
  return (point + closest_on_triangle(q, point).point) / 2;
}

/// Finds common points without a plane: the corners of each triangle that are on the other one,
/// else one point.
Polygon common_corners(const Corners& p, const Corners& q) {
  Polygon common;
  for (const Vec3& corner : p) {
    if (closest_on_triangle(q, corner).distance <= kNear) common.add(corner);
  }
  for (const Vec3& corner : q) {
    if (closest_on_triangle(p, corner).distance <= kNear) common.add(corner);
  }
  if (common.count == 0) common.add(common_point(p, q));
  return common;
}

Polygon common_part(const Corners& p, const Corners& q) {
  const Vec3 normal_p = accurate_normal(p[0], p[1], p[2]);
  const Vec3 normal_q = accurate_normal(q[0], q[1], q[2]);
  Polygon common;
  if (!normal_q.isZero(0.0)) common = clip_to_triangle(p, q, normal_q);
  if (common.count == 0 && !normal_p.isZero(0.0)) common = clip_to_triangle(q, p, normal_p);
  return common.count == 0 ? common_corners(p, q) : common;
}

bool is_area(ContactKind kind) {
  return kind == ContactKind::CoplanarOverlap || kind == ContactKind::FoldOver ||
         kind == ContactKind::Duplicate;
}

void add_segment(const PairScale& scale, const Vec3& a, const Vec3& b, ContactSegments& found) {
  found.segments[found.count++] = {scale.unscaled(a), scale.unscaled(b)};
}

/// Returns the two corners that are farthest apart; the same corner twice if all coincide.
std::array<Vec3, 2> longest_diagonal(const Polygon& polygon) {
  std::array<Vec3, 2> longest{polygon.corners[0], polygon.corners[0]};
  double length = kPoint * kPoint;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    for (std::size_t j = i + 1; j < polygon.count; ++j) {
      const double squared = (polygon.corners[j] - polygon.corners[i]).squaredNorm();
      if (squared <= length) continue;
      length = squared;
      longest = {polygon.corners[i], polygon.corners[j]};
    }
  }
  return longest;
}

}  // namespace

ContactSegments contact_segments(const Corners& p, const Corners& q, ContactKind kind) {
  const PairScale scale(p, q);
  const Polygon common = common_part(scale.scaled(p), scale.scaled(q));
  ContactSegments found;
  for (std::size_t i = 0; is_area(kind) && i < common.count; ++i) {
    const Vec3& a = common.corners[i];
    const Vec3& b = common.corners[i + 1 == common.count ? 0 : i + 1];
    if ((b - a).squaredNorm() > kPoint * kPoint) add_segment(scale, a, b, found);
  }
  if (found.count == 0) {
    const auto [a, b] = longest_diagonal(common);
    add_segment(scale, a, b, found);
  }
  return found;
}

}  // namespace meshalyzer
