#include "meshalyzer/spatial/triangle_distance.h"

#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace meshalyzer {
namespace {

/// The squared sine of an angle between two edges below which a plain cross product has too few
/// digits.
constexpr double kSliver = 1e-3;
/// The squared sine below which not even the careful product determines the plane: no point inside
/// such a triangle is farther than 1e-15 of its size from an edge.
constexpr double kFlat = 1e-30;

/// A number as an unevaluated sum of two doubles: about 106 bits.
struct Twofold {
  double high;
  double low;
};

/// Returns a - b exactly.
Twofold difference(double a, double b) {
  const double high = a - b;
  const double tail = high - a;
  return {high, (a - (high - tail)) - (b + tail)};
}

Twofold product(const Twofold& a, const Twofold& b) {
  const double high = a.high * b.high;
  return {high, std::fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high)};
}

/// Returns a b - c d, rounded once except for cancellation beyond 106 bits.
double determinant(const std::array<Twofold, 4>& m) {
  const Twofold ab = product(m[0], m[1]);
  const Twofold cd = product(m[2], m[3]);
  const Twofold high = difference(ab.high, cd.high);
  return high.high + (high.low + (ab.low - cd.low));
}

/// Returns (b - a) x (c - a), accurate for slivers.
Vec3 careful_normal(const Corners& t) {
  Vec3 normal;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index i = (k + 1) % 3;
    const Eigen::Index j = (k + 2) % 3;
    normal[k] = determinant({difference(t[1][i], t[0][i]), difference(t[2][j], t[0][j]),
                             difference(t[1][j], t[0][j]), difference(t[2][i], t[0][i])});
  }
  return normal;
}

/// A candidate for the closest point of the triangle.
struct Candidate {
  Vec3 point = Vec3::Zero();
  /// The vector from the query point to it.
  Vec3 offset = Vec3::Zero();
  double squared = std::numeric_limits<double>::infinity();
};

/// One edge, from its end that is nearer to the query point.
struct Edge {
  std::size_t from;
  Vec3 along;
  /// The position of the closest point on the line of the edge, in multiples of `along`.
  double foot;
  double squared_length;
};

/// A triangle relative to the query point, which is the origin here. It is scaled so that nothing
/// overflows, and any underflow is negligible.
class View {
 public:
  View(const Corners& t, const Vec3& p) : t_(t), p_(p) {
    for (std::size_t i = 0; i < 3; ++i) {
      corner_[i] = t[i] - p;
      // This is not the difference of two corners relative to a distant point, each of which would
      // be rounded.
      edge_[i] = t[(i + 1) % 3] - t[i];
      squared_[i] = corner_[i].squaredNorm();
      squared_length_[i] = edge_[i].squaredNorm();
    }
    nearest_ = squared_[1] < squared_[0] ? 1 : 0;
    nearest_ = squared_[2] < squared_[nearest_] ? 2 : nearest_;
    set_plane();
  }

  /// Returns the squared distance of the farthest corner.
  [[nodiscard]] double squared_size() const {
    return std::max({squared_[0], squared_[1], squared_[2]});
  }
  /// Returns (b - a) x (c - a), or zero if the triangle has no reliable plane.
  [[nodiscard]] const Vec3& normal() const { return normal_; }
  [[nodiscard]] double squared_normal() const { return squared_normal_; }
  /// Returns the dot product of normal() and any point of the plane.
  [[nodiscard]] double height() const { return normal_.dot(corner_[nearest_]); }

  [[nodiscard]] Candidate at_corner(std::size_t i) const {
    return {t_[i], corner_[i], squared_[i]};
  }
  [[nodiscard]] const Vec3& corner(std::size_t i) const { return corner_[i]; }

  [[nodiscard]] Edge edge(std::size_t i) const {
    const std::size_t next = i == 2 ? 0 : i + 1;
    const bool turned = squared_[next] < squared_[i];
    Edge edge{turned ? next : i, turned ? Vec3(-edge_[i]) : edge_[i], 0.0, squared_length_[i]};
    edge.foot = -corner_[edge.from].dot(edge.along) /
                std::max(edge.squared_length, std::numeric_limits<double>::min());
    return edge;
  }

  /// Returns the point of an edge at a multiple of its vector.
  [[nodiscard]] Candidate on_edge(const Edge& edge, double at) const {
    const Vec3 step = at * edge.along;
    const Vec3 offset = corner_[edge.from] + step;
    return {t_[edge.from] + step, offset, offset.squaredNorm()};
  }

  /// Returns the position of a point of the plane if it is in the triangle.
  [[nodiscard]] std::optional<Vec3> place(const Vec3& offset) const {
    std::array<double, 3> inside;
    for (std::size_t i = 0; i < 3; ++i) {
      inside[i] = normal_.cross(edge_[i]).dot(offset - corner_[i]);
      if (!(inside[i] > 0.0)) {
        return std::nullopt;
      }
    }
    const double longest = std::max({squared_length_[0], squared_length_[1], squared_length_[2]});
    if (squared_normal_ < kSliver * longest * longest) {
      // Across a thin triangle the barycentric coordinates have no correct digits.
      return p_ + offset;
    }
    // It is computed from barycentric coordinates, so that it is on the triangle even for a distant
    // query point.
    const double sum = inside[0] + inside[1] + inside[2];
    return t_[0] + (inside[2] / sum) * edge_[0] - (inside[0] / sum) * edge_[2];
  }

 private:
  void set_plane() {
    const double limit = squared_length_[0] * squared_length_[1];
    normal_ = edge_[0].cross(edge_[1]);
    squared_normal_ = normal_.squaredNorm();
    if (squared_normal_ < kSliver * limit) [[unlikely]] {
      normal_ = careful_normal(t_);
      squared_normal_ = normal_.squaredNorm();
    }
    if (!(squared_normal_ > kFlat * limit) ||
        squared_normal_ < std::numeric_limits<double>::min()) {
      normal_.setZero();
      squared_normal_ = 0.0;
    }
  }

  const Corners& t_;
  const Vec3& p_;
  Corners corner_;
  Corners edge_;
  std::array<double, 3> squared_;
  std::array<double, 3> squared_length_;
  std::size_t nearest_;
  Vec3 normal_;
  double squared_normal_;
};

Candidate closest(const View& view) {
  Candidate best;
  for (std::size_t i = 0; i < 3; ++i) {
    const Edge edge = view.edge(i);
    const Candidate candidate = view.on_edge(edge, std::clamp(edge.foot, 0.0, 1.0));
    best = candidate.squared < best.squared ? candidate : best;
  }
  if (view.squared_normal() > 0.0) {
    const double share = view.height() / view.squared_normal();
    const Vec3 foot = share * view.normal();
    if (const auto point = view.place(foot)) {
      // It is nearer than any edge up to rounding; a point on an edge keeps its distance of 0.
      return {*point, foot, std::min(best.squared, share * view.height())};
    }
  }
  return best;
}

bool is_in(const Cone& cone, const Vec3& offset) {
  return offset.dot(cone.axis) >= cone.cos_half_angle * offset.norm();
}

/// Returns the direction in a cone that is nearest to one of length 1 outside it.
std::optional<Vec3> nearest_side(const Cone& cone, const Vec3& direction) {
  const double along = direction.dot(cone.axis);
  const Vec3 across = direction - along * cone.axis;
  const double length = across.norm();
  if (along >= cone.cos_half_angle) {
    return direction;
  }
  if (length == 0.0) {
    return std::nullopt;
  }
  const double sine = std::sqrt(1.0 - cone.cos_half_angle * cone.cos_half_angle);
  return cone.cos_half_angle * cone.axis + (sine / length) * across;
}

/// Returns the closest common point of plane and cone, which lies on the side of the cone that
/// leans most to the plane, if it is in the triangle.
Candidate on_plane(const View& view, const Cone& cone) {
  Candidate none;
  if (view.squared_normal() == 0.0 || view.height() == 0.0) {
    return none;
  }
  const Vec3 towards =
      view.normal() * (std::copysign(1.0, view.height()) / std::sqrt(view.squared_normal()));
  const double distance = std::abs(view.height()) / std::sqrt(view.squared_normal());
  const std::optional<Vec3> side = nearest_side(cone, towards);
  const double slope = side ? side->dot(towards) : 0.0;
  if (!(slope > 0.0)) {
    return none;
  }
  const Vec3 offset = *side * (distance / slope);
  const std::optional<Vec3> point = view.place(offset);
  return point ? Candidate{*point, offset, offset.squaredNorm()} : none;
}

/// Returns the multiples of an edge, counted from its foot, at which its line goes through the
/// double cone: the roots of a x^2 + 2 b x + c. Roots that do not exist are NaN or infinite.
std::array<double, 2> crossings(const View& view, const Edge& edge, const Cone& cone) {
  // Relative to the foot of the perpendicular, |offset|^2 has no mixed term: nothing cancels where
  // the line passes close to the apex.
  const Vec3 foot = view.corner(edge.from) + edge.foot * edge.along;
  const double cos_squared = cone.cos_half_angle * cone.cos_half_angle;
  const double u = foot.dot(cone.axis);
  const double v = edge.along.dot(cone.axis);
  const double a = v * v - cos_squared * edge.squared_length;
  const double b = u * v;
  const double c = u * u - cos_squared * foot.squaredNorm();
  const double sum = -(b + std::copysign(std::sqrt(b * b - a * c), b));
  return {sum / a, c / sum};
}

/// Returns the closest common point of edge and cone other than the ends.
Candidate on_edge(const View& view, std::size_t i, const Cone& cone) {
  const Edge edge = view.edge(i);
  Candidate best = view.on_edge(edge, std::clamp(edge.foot, 0.0, 1.0));
  if (is_in(cone, best.offset)) {
    return best;
  }
  best = {};
  for (const double crossing : crossings(view, edge, cone)) {
    const double at = edge.foot + crossing;
    if (at >= 0.0 && at <= 1.0) {
      const Candidate candidate = view.on_edge(edge, at);
      // Otherwise it is on the opposite half of the double cone.
      if (candidate.offset.dot(cone.axis) >= 0.0 && candidate.squared < best.squared) {
        best = candidate;
      }
    }
  }
  return best;
}

/// Returns the closest point in the cone. If that of the whole triangle is not in the cone, the
/// closest one is on the side of the cone or on an edge, because triangle and cone are convex.
Candidate closest(const View& view, const Cone& cone) {
  Candidate best = closest(view);
  if (is_in(cone, best.offset)) {
    return best;
  }
  best = on_plane(view, cone);
  for (std::size_t i = 0; i < 3; ++i) {
    const Candidate candidate = on_edge(view, i, cone);
    best = candidate.squared < best.squared ? candidate : best;
    if (view.at_corner(i).squared < best.squared && is_in(cone, view.at_corner(i).offset)) {
      best = view.at_corner(i);
    }
  }
  return best;
}

/// Tells whether products of four lengths and squares of their quotients neither overflow nor
/// underflow.
bool is_in_range(const View& view) {
  return view.squared_size() > 1e-100 && view.squared_size() < 1e120;
}

/// The same triangle and point, scaled to a size near 1.
struct Rescaled {
  Corners t;
  Vec3 p;
  int exponent;

  Rescaled(const Corners& corners, const Vec3& point) {
    double size = 0.0;
    for (const Vec3& corner : corners) {
      size = std::max(size, (corner - point).cwiseAbs().maxCoeff());
    }
    exponent = size == 0.0 ? 0 : length_exponent(size);
    const auto scale = [this](const Vec3& v) {
      return Vec3(v.unaryExpr([this](double x) { return std::ldexp(x, -exponent); }));
    };
    t = {scale(corners[0]), scale(corners[1]), scale(corners[2])};
    p = scale(point);
  }
  [[nodiscard]] TrianglePoint undone(const TrianglePoint& scaled) const {
    return {scaled.point.unaryExpr([this](double x) { return std::ldexp(x, exponent); }),
            std::ldexp(scaled.distance, exponent)};
  }
};

TrianglePoint finished(const Candidate& candidate) {
  return {candidate.point, std::sqrt(candidate.squared)};
}

}  // namespace

TrianglePoint closest_on_triangle(const Corners& t, const Vec3& p) {
  const View view(t, p);
  if (is_in_range(view)) [[likely]] {
    return finished(closest(view));
  }
  const Rescaled scaled(t, p);
  return scaled.undone(finished(closest(View(scaled.t, scaled.p))));
}

std::optional<TrianglePoint> closest_on_triangle(const Corners& t, const Vec3& p,
                                                 const Cone& cone) {
  const View view(t, p);
  if (is_in_range(view)) [[likely]] {
    const Candidate best = closest(view, cone);
    return std::isfinite(best.squared) ? std::optional(finished(best)) : std::nullopt;
  }
  const Rescaled scaled(t, p);
  const Candidate best = closest(View(scaled.t, scaled.p), cone);
  return std::isfinite(best.squared) ? std::optional(scaled.undone(finished(best))) : std::nullopt;
}

}  // namespace meshalyzer
