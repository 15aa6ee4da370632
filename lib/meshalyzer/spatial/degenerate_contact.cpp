#include "meshalyzer/spatial/degenerate_contact.h"

#include "meshalyzer/base/lexicographic.h"
#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// The segment that collinear corners span; u == v for a point.
struct CollinearHull {
  Vec3 u;
  Vec3 v;
};

/// Returns the hull of collinear corners. Lexicographic order is the order along the line.
CollinearHull hull(const Corners& t) {
  const auto [low, high] = std::minmax_element(t.begin(), t.end(), lexicographically_less);
  return {*low, *high};
}

bool is_point(const CollinearHull& s) {
  return s.u == s.v;
}

/// Tells whether x, which is on the line of s, lies in s.
bool is_within(const CollinearHull& s, const Vec3& x) {
  return !lexicographically_less(x, s.u) && !lexicographically_less(s.v, x);
}

bool is_on(const CollinearHull& s, const Vec3& x) {
  return are_collinear(s.u, s.v, x) && is_within(s, x);
}

/// Tells whether b and c lie in the same direction from a, none of them at a itself.
bool same_direction(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (a == b || a == c || !are_collinear(a, b, c)) {
    return false;
  }
  return lexicographically_less(a, b) == lexicographically_less(a, c);
}

/// Tells whether two coplanar segments that are not collinear cross; their plane projects to an
/// area along `axis`.
bool cross_in_plane(Axis axis, const CollinearHull& s, const CollinearHull& t) {
  return orient2d(axis, s.u, s.v, t.u) * orient2d(axis, s.u, s.v, t.v) <= 0 &&
         orient2d(axis, t.u, t.v, s.u) * orient2d(axis, t.u, t.v, s.v) <= 0;
}

bool segments_meet(const CollinearHull& s, const CollinearHull& t) {
  if (is_point(s)) {
    return is_on(t, s.u);
  }
  if (is_point(t)) {
    return is_on(s, t.u);
  }
  if (orient3d(s.u, s.v, t.u, t.v) != 0) {
    return false;
  }
  auto axis = projection_axis(s.u, s.v, t.u);
  if (!axis) {
    axis = projection_axis(s.u, s.v, t.v);
  }
  if (!axis) {
    return is_within(s, t.u) || is_within(s, t.v) || is_within(t, s.u);
  }
  return cross_in_plane(*axis, s, t);
}

/// A triangle of non-zero area, projected along an axis so that it is counter-clockwise.
struct PlanarTriangle {
  Corners corners;
  Axis axis;
};

PlanarTriangle planar(const Corners& t) {
  const Axis axis = *projection_axis(t[0], t[1], t[2]);
  return orient2d(axis, t[0], t[1], t[2]) > 0 ? PlanarTriangle{t, axis}
                                              : PlanarTriangle{{t[0], t[2], t[1]}, axis};
}

/// Tells whether a segment in the plane of t meets it: no edge of t, nor the segment itself,
/// separates the two.
bool meets_in_plane(const PlanarTriangle& t, const CollinearHull& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = t.corners[i];
    const Vec3& b = t.corners[(i + 1) % 3];
    if (orient2d(t.axis, a, b, s.u) < 0 && orient2d(t.axis, a, b, s.v) < 0) {
      return false;
    }
  }
  if (is_point(s)) {
    return true;
  }
  Sign low = 1;
  Sign high = -1;
  for (const Vec3& corner : t.corners) {
    const Sign side = orient2d(t.axis, s.u, s.v, corner);
    low = std::min(low, side);
    high = std::max(high, side);
  }
  return low <= 0 && high >= 0;
}

/// The position relative to t of the point where the line of a segment passes the plane of t.
enum class Pass { Outside, Border, Inside };

Pass pass_of_line(const Corners& t, const CollinearHull& s) {
  Sign low = 1;
  Sign high = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign side = orient3d(s.u, s.v, t[i], t[(i + 1) % 3]);
    low = std::min(low, side);
    high = std::max(high, side);
  }
  if (low < 0 && high > 0) {
    return Pass::Outside;
  }
  return low == 0 || high == 0 ? Pass::Border : Pass::Inside;
}

std::optional<ContactKind> contact_with_segment(const Corners& t, const CollinearHull& s) {
  const Sign at_u = orient3d(t[0], t[1], t[2], s.u);
  const Sign at_v = orient3d(t[0], t[1], t[2], s.v);
  if (at_u * at_v > 0) {
    return std::nullopt;
  }
  if (at_u == 0 && at_v == 0) {
    return meets_in_plane(planar(t), s) ? std::optional(ContactKind::Touching) : std::nullopt;
  }
  const Pass pass = pass_of_line(t, s);
  if (pass == Pass::Outside) {
    return std::nullopt;
  }
  return pass == Pass::Inside && at_u != 0 && at_v != 0 ? ContactKind::Crossing
                                                        : ContactKind::Touching;
}

/// Tells whether s continues inside t. t has non-zero area, and its first corner is a point of s.
bool segment_goes_into(const Corners& t, const CollinearHull& s) {
  const PlanarTriangle flat = planar(t);
  const Vec3& a = flat.corners[0];
  const auto is_inside = [&](const Vec3& end) {
    return end != a && orient3d(t[0], t[1], t[2], end) == 0 &&
           orient2d(flat.axis, a, flat.corners[1], end) >= 0 &&
           orient2d(flat.axis, a, end, flat.corners[2]) >= 0;
  };
  return is_inside(s.u) || is_inside(s.v);
}

/// Tells whether two segments through the point a continue in the same direction.
bool segments_go_together(const Vec3& a, const CollinearHull& s, const CollinearHull& t) {
  return same_direction(a, s.u, t.u) || same_direction(a, s.u, t.v) ||
         same_direction(a, s.v, t.u) || same_direction(a, s.v, t.v);
}

/// Tells whether two segments that both contain the common edge a b extend beyond the same end of
/// it.
bool segments_outreach(const Corners& p, const Corners& q) {
  const auto [low, high] = std::minmax(p[0], p[1], lexicographically_less);
  const CollinearHull s = hull(p);
  const CollinearHull t = hull(q);
  const bool below = lexicographically_less(s.u, low) && lexicographically_less(t.u, low);
  const bool above = lexicographically_less(high, s.v) && lexicographically_less(high, t.v);
  return below || above;
}

std::optional<ContactKind> found_if(bool contact, ContactKind kind) {
  return contact ? std::optional(kind) : std::nullopt;
}

}  // namespace

std::optional<ContactKind> find_degenerate_contact(const Corners& p, const Corners& q,
                                                   Common common) {
  const bool thin_p = are_collinear(p);
  const bool thin_q = are_collinear(q);
  if (!thin_p) {
    return find_degenerate_contact(q, p, common);
  }
  const bool edge_has_length = common == Common::Edge && p[0] != p[1];
  if (thin_q) {
    if (common == Common::Nothing) {
      return found_if(segments_meet(hull(p), hull(q)), ContactKind::Touching);
    }
    if (edge_has_length) {
      return found_if(segments_outreach(p, q), ContactKind::FoldOver);
    }
    const ContactKind kind = common == Common::Edge ? ContactKind::FoldOver : ContactKind::Touching;
    return found_if(segments_go_together(p[0], hull(p), hull(q)), kind);
  }
  switch (common) {
    case Common::Nothing:
      return contact_with_segment(q, hull(p));
    case Common::Vertex:
      return found_if(segment_goes_into(q, hull(p)), ContactKind::Touching);
    default:
      // The line of p and the triangle q share exactly the edge.
      return std::nullopt;
  }
}

}  // namespace meshalyzer
