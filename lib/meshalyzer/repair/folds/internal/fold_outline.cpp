#include "meshalyzer/repair/folds/internal/fold_outline.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/repair/holes/internal/ear_cutter.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

using Vec2 = Eigen::Vector2d;

/// Returns the unit vector along the area that an outline encloses; zero where it encloses none.
Vec3 normal_of_outline(std::span<const Vec3> outline) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < outline.size(); ++i) {
    sum += accurate_normal(outline[0], outline[i - 1], outline[i]);
  }
  return sum.allFinite() ? sum.stableNormalized() : Vec3::Zero();
}

double cross_2d(const Vec2& a, const Vec2& b) {
  return a[0] * b[1] - a[1] * b[0];
}

double area(const std::vector<Vec2>& polygon) {
  double sum = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += cross_2d(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]) / 2;
  }
  return sum;
}

/// Returns the part of a convex polygon on the left of the line from a to b.
std::vector<Vec2> left_part(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& p = polygon[i];
    const Vec2& q = polygon[(i + 1) % polygon.size()];
    const double here = cross_2d(b - a, p - a);
    const double there = cross_2d(b - a, q - a);
    if (here >= 0.0) part.push_back(p);
    if ((here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0)) {
      part.push_back(p + (q - p) * (here / (here - there)));
    }
  }
  return part;
}

/// The plane in which an outline is measured: its middle is the origin, its extent about 1.
struct Plane {
  Vec3 origin;
  double scale;
  Vec3 u;
  Vec3 v;

  [[nodiscard]] Vec2 place(const Vec3& point) const {
    const Vec3 from = (point - origin) / scale;
    return {u.dot(from), v.dot(from)};
  }
  [[nodiscard]] Vec3 point(const Vec2& place) const {
    return origin + scale * (place[0] * u + place[1] * v);
  }
};

std::optional<Plane> plane_of(std::span<const Vec3> outline) {
  const Vec3 normal = normal_of_outline(outline);
  Plane plane{Vec3::Zero(), 0.0, normal.unitOrthogonal(), Vec3::Zero()};
  plane.v = normal.cross(plane.u);
  for (const Vec3& p : outline) plane.origin += p / static_cast<double>(outline.size());
  for (const Vec3& p : outline) {
    plane.scale = std::max(plane.scale, (p - plane.origin).cwiseAbs().maxCoeff());
  }
  if (normal.isZero(0.0) || !(plane.scale > 0.0)) return std::nullopt;
  return plane;
}

/// Returns the view along an axis in which an outline is counter-clockwise.
PlaneView view_of(std::span<const Vec3> outline) {
  const Vec3 normal = normal_of_outline(outline);
  const Axis axis = longest_axis(normal);
  return {axis, normal[static_cast<Eigen::Index>(axis)] > 0.0 ? 1 : -1};
}

}  // namespace

std::optional<Vec3> middle_of_kernel(std::span<const Vec3> outline) {
  const std::optional<Plane> plane = plane_of(outline);
  if (!plane) return std::nullopt;
  std::vector<Vec2> kernel{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    kernel = left_part(kernel, plane->place(outline[i]),
                       plane->place(outline[(i + 1) % outline.size()]));
  }
  // A smaller region would be lost in rounding.
  constexpr double kLeastArea = 1e-12;
  if (!(area(kernel) > kLeastArea)) return std::nullopt;
  Vec2 middle = Vec2::Zero();
  for (const Vec2& p : kernel) middle += p / static_cast<double>(kernel.size());
  return plane->point(middle);
}

std::vector<Triangle> cut_ears(std::span<const Vec3> outline, const MayJoin& may_join) {
  const EarRules best_shaped_first{
      .cost = [outline](const Triangle& t) { return -shape_quality(corners_of(outline, t)); },
      .allows = [&may_join](const Triangle& t) { return may_join(t[0], t[2]); }};
  EarCutter cutter(outline, {view_of(outline)}, best_shaped_first);
  while (cutter.n_left() > 2) {
    // One ear at a time, since each may make better ones possible.
    const std::size_t n_before = cutter.n_left();
    cutter.cut(EarDemand::ConvexAndEmpty, n_before - 1);
    if (cutter.n_left() == n_before) return {};
  }
  return cutter.triangles();
}

double shape_quality(const Corners& t) {
  const double longest = longest_side(t);
  if (!(longest > 0.0)) return 0.0;
  return accurate_normal(t).stableNorm() / longest / longest;
}

}  // namespace meshalyzer
