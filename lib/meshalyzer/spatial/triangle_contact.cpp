#include "meshalyzer/spatial/triangle_contact.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/spatial/degenerate_contact.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

using Signs = std::array<Sign, 3>;

bool all_on_one_side(const Signs& s) {
  return s[0] * s[1] > 0 && s[1] * s[2] > 0;
}
bool straddles(const Signs& s) {
  return std::min({s[0], s[1], s[2]}) < 0 && std::max({s[0], s[1], s[2]}) > 0;
}

Signs sides(const Corners& plane, const Corners& points) {
  return {orient3d(plane[0], plane[1], plane[2], points[0]),
          orient3d(plane[0], plane[1], plane[2], points[1]),
          orient3d(plane[0], plane[1], plane[2], points[2])};
}

/// The relation of two coplanar convex figures.
enum class Planar { Apart, Touching, Overlapping };

/// Searches a line along an edge of `p` that has `q` on its outer side.
Planar separation(Axis axis, const Corners& p, const Corners& q) {
  const Sign turn = orient2d(axis, p[0], p[1], p[2]);
  Planar found = Planar::Overlapping;
  for (std::size_t i = 0; i < 3; ++i) {
    Sign innermost = -1;
    for (const Vec3& point : q) {
      innermost = std::max(innermost, turn * orient2d(axis, p[i], p[(i + 1) % 3], point));
    }
    if (innermost < 0) {
      return Planar::Apart;
    }
    if (innermost == 0) {
      found = Planar::Touching;
    }
  }
  return found;
}

/// Returns the relation of two coplanar triangles whose plane projects to non-zero area along
/// `axis` (separating axis theorem).
Planar planar_relation(Axis axis, const Corners& p, const Corners& q) {
  return std::min(separation(axis, p, q), separation(axis, q, p));
}

/// Tells whether x, seen from a, lies in the closed angle from b round to c (counter-clockwise,
/// below 180 degrees).
bool in_angle(Axis axis, const Vec3& a, const std::pair<Vec3, Vec3>& arms, const Vec3& x) {
  return orient2d(axis, a, arms.first, x) >= 0 && orient2d(axis, a, x, arms.second) >= 0;
}

std::pair<Vec3, Vec3> arms_of(Axis axis, const Corners& t) {
  return orient2d(axis, t[0], t[1], t[2]) > 0 ? std::pair(t[1], t[2]) : std::pair(t[2], t[1]);
}

std::optional<ContactKind> planar_contact(const Corners& p, const Corners& q) {
  switch (planar_relation(*projection_axis(p[0], p[1], p[2]), p, q)) {
    case Planar::Apart:
      return std::nullopt;
    case Planar::Touching:
      return ContactKind::Touching;
    case Planar::Overlapping:
      return ContactKind::CoplanarOverlap;
  }
  return std::nullopt;
}

std::optional<ContactKind> planar_contact_beyond_vertex(const Corners& p, const Corners& q) {
  const Axis axis = *projection_axis(p[0], p[1], p[2]);
  const auto arms_p = arms_of(axis, p);
  const auto arms_q = arms_of(axis, q);
  const bool beyond = in_angle(axis, p[0], arms_p, q[1]) || in_angle(axis, p[0], arms_p, q[2]) ||
                      in_angle(axis, p[0], arms_q, p[1]) || in_angle(axis, p[0], arms_q, p[2]);
  if (!beyond) {
    return std::nullopt;
  }
  return planar_relation(axis, p, q) == Planar::Overlapping ? ContactKind::CoplanarOverlap
                                                            : ContactKind::Touching;
}

/// A corner that is alone on its side of the other triangle's plane, and the other two in cyclic
/// order.
struct Lone {
  Corners corners;
  Sign side;
};

/// Returns the corner that is alone on its side. If one corner is alone strictly on a side, corners
/// in the plane go with the others; if two are, the third, which is in the plane, is alone and
/// counts as being on the far side.
Lone lone_corner(const Corners& t, const Signs& s) {
  const auto rotated = [&](std::size_t i) { return Corners{t[i], t[(i + 1) % 3], t[(i + 2) % 3]}; };
  for (const Sign side : {1, -1}) {
    if (std::count(s.begin(), s.end(), side) == 1) {
      return {rotated(static_cast<std::size_t>(std::find(s.begin(), s.end(), side) - s.begin())),
              side};
    }
  }
  const auto zero = static_cast<std::size_t>(std::find(s.begin(), s.end(), 0) - s.begin());
  return {rotated(zero), -s[(zero + 1) % 3]};
}

/// Tells whether and how two triangles in different planes meet, neither of which is wholly on one
/// side of the other's plane: the intervals that they cut from the common line of the planes must
/// meet. (Guigue and Devillers 2003, with the two orientations at the end.)
std::optional<ContactKind> line_contact(const Corners& p, const Corners& q, const Signs& of_p,
                                        const Signs& of_q) {
  Lone a = lone_corner(p, of_p);
  Lone b = lone_corner(q, of_q);
  // Turn each triangle so that the other's lone corner is on its positive side.
  if (a.side < 0) {
    std::swap(b.corners[1], b.corners[2]);
  }
  if (b.side < 0) {
    std::swap(a.corners[1], a.corners[2]);
  }
  const Sign first = orient3d(a.corners[1], b.corners[0], a.corners[0], b.corners[1]);
  if (first > 0) {
    return std::nullopt;
  }
  const Sign second = orient3d(a.corners[0], b.corners[0], a.corners[2], b.corners[2]);
  if (second > 0) {
    return std::nullopt;
  }
  const bool interiors = first < 0 && second < 0 && straddles(of_p) && straddles(of_q);
  return interiors ? ContactKind::Crossing : ContactKind::Touching;
}

/// Returns the sides of a plane on which three points are, if floating point is sure that each is
/// on one.
std::optional<Signs> strict_sides_if_sure(const Corners& plane, const Corners& points) {
  Signs signs{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto side = orient3d_if_sure(plane[0], plane[1], plane[2], points[i]);
    if (!side || *side == 0) {
      return std::nullopt;
    }
    signs[i] = *side;
  }
  return signs;
}

std::optional<ContactKind> contact_of_strangers(const Corners& p, const Corners& q) {
  const Signs of_q = sides(p, q);
  if (all_on_one_side(of_q)) {
    return std::nullopt;
  }
  if (of_q == Signs{0, 0, 0}) {
    return planar_contact(p, q);
  }
  const Signs of_p = sides(q, p);
  if (all_on_one_side(of_p)) {
    return std::nullopt;
  }
  return line_contact(p, q, of_p, of_q);
}

/// Finds a contact of p = a b c and q = a d e beyond a. A point beyond a is shared exactly when the
/// line d e meets the plane of p inside the angle of p at a, for then the segment from a to that
/// point lies in q and begins in p.
std::optional<ContactKind> contact_beyond_vertex(const Corners& p, const Corners& q) {
  Sign below = orient3d(p[0], p[1], p[2], q[1]);
  Sign above = orient3d(p[0], p[1], p[2], q[2]);
  if (below * above > 0) {
    return std::nullopt;
  }
  if (below == 0 && above == 0) {
    return planar_contact_beyond_vertex(p, q);
  }
  Vec3 d = q[1];
  Vec3 e = q[2];
  if (below > above) {
    std::swap(d, e);
    std::swap(below, above);
  }
  const Sign left_of_first = orient3d(d, e, p[0], p[1]);
  const Sign left_of_second = orient3d(d, e, p[2], p[0]);
  if (left_of_first < 0 || left_of_second < 0) {
    return std::nullopt;
  }
  const bool interiors = left_of_first > 0 && left_of_second > 0 && below < 0 && above > 0;
  return interiors ? ContactKind::Crossing : ContactKind::Touching;
}

/// Finds a contact of p = a b c and q = a b d beyond the edge. They share more than the edge
/// exactly when they lie in one plane on the same side of it.
std::optional<ContactKind> contact_beyond_edge(const Corners& p, const Corners& q) {
  if (orient3d(p[0], p[1], p[2], q[2]) != 0) {
    return std::nullopt;
  }
  const Axis axis = *projection_axis(p[0], p[1], p[2]);
  const bool same_side = orient2d(axis, p[0], p[1], p[2]) * orient2d(axis, p[0], p[1], q[2]) > 0;
  return same_side ? std::optional(ContactKind::FoldOver) : std::nullopt;
}

/// Tells whether the projections along `axis` surely share only the common edge.
bool folds_apart(Axis axis, const Corners& p, const Corners& q) {
  const auto s = orient2d_if_sure(axis, p[0], p[1], p[2]);
  const auto t = orient2d_if_sure(axis, p[0], p[1], q[2]);
  return s && t && *s * *t < 0;
}

/// Tells whether a line through the corner q[0] == p[0] along an edge of p has p surely on one side
/// and q's other corners surely on the other, in the projection along `axis`.
bool wedges_apart(Axis axis, const Corners& p, const Corners& q) {
  const auto turn = orient2d_if_sure(axis, p[0], p[1], p[2]);
  if (!turn || *turn == 0) {
    return false;
  }
  for (std::size_t arm = 1; arm < 3; ++arm) {
    const Sign inner = arm == 1 ? *turn : -*turn;
    const auto d = orient2d_if_sure(axis, p[0], p[arm], q[1]);
    const auto e = orient2d_if_sure(axis, p[0], p[arm], q[2]);
    if (d && e && *d * inner < 0 && *e * inner < 0) {
      return true;
    }
  }
  return false;
}

/// Tells whether a line along an edge of p surely has all of q on its outer side, in the projection
/// along `axis`.
bool edges_apart(Axis axis, const Corners& p, const Corners& q) {
  const auto turn = orient2d_if_sure(axis, p[0], p[1], p[2]);
  if (!turn || *turn == 0) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const bool apart = std::all_of(q.begin(), q.end(), [&](const Vec3& point) {
      const auto side = orient2d_if_sure(axis, p[i], p[(i + 1) % 3], point);
      return side && *side * *turn < 0;
    });
    if (apart) {
      return true;
    }
  }
  return false;
}

/// Tells whether the box of the edge opposite to the first corner of p stays off the box of q.
bool opposite_edge_is_apart(const Corners& p, const Corners& q) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax(p[1][k], p[2][k]);
    if (high < std::min({q[0][k], q[1][k], q[2][k]}) ||
        low > std::max({q[0][k], q[1][k], q[2][k]})) {
      return true;
    }
  }
  return false;
}

/// Tells whether the corners of q from `first` on lie surely and strictly on one side of the plane
/// of p.
bool surely_beside(const Corners& p, const Corners& q, std::size_t first) {
  const auto side = orient3d_if_sure(p[0], p[1], p[2], q[first]);
  if (!side || *side == 0) {
    return false;
  }
  for (std::size_t i = first + 1; i < 3; ++i) {
    if (orient3d_if_sure(p[0], p[1], p[2], q[i]) != side) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool are_clearly_apart(const Corners& p, const Corners& q, Common common) {
  if (common == Common::All) {
    return false;
  }
  // A segment that two triangles share from their common corner on ends on the edge opposite to it
  // in one of them. So the many neighbours round a vertex, whose boxes all contain it, are
  // separated by comparisons alone.
  if (common == Common::Vertex && opposite_edge_is_apart(p, q) && opposite_edge_is_apart(q, p)) {
    return true;
  }
  const auto n_common = static_cast<std::size_t>(common);
  if (surely_beside(p, q, n_common) || (common != Common::Edge && surely_beside(q, p, n_common))) {
    return true;
  }
  const Axis axis = longest_axis(normal_of(p));
  switch (common) {
    case Common::Nothing:
      return edges_apart(axis, p, q) || edges_apart(axis, q, p);
    case Common::Vertex:
      return wedges_apart(axis, p, q) || wedges_apart(axis, q, p);
    default:
      return folds_apart(axis, p, q);
  }
}

std::optional<ContactKind> find_contact(const Corners& p, const Corners& q, Common common) {
  if (common == Common::All) {
    return ContactKind::Duplicate;
  }
  if (common == Common::Nothing) {
    // In general position, which most pairs that do meet are in, nothing else is to be tested
    // first: with a corner off its plane, neither triangle is degenerate.
    const std::optional<Signs> of_q = strict_sides_if_sure(p, q);
    if (of_q && all_on_one_side(*of_q)) {
      return std::nullopt;
    }
    const std::optional<Signs> of_p = of_q ? strict_sides_if_sure(q, p) : std::nullopt;
    if (of_p) {
      return all_on_one_side(*of_p) ? std::nullopt : line_contact(p, q, *of_p, *of_q);
    }
    // The boxes of a search are in single precision: where some faces are a million times larger
    // than others, all small ones are at one place there, and exact signs take long.
    if (!box_of(p).intersects(box_of(q))) {
      return std::nullopt;
    }
  }
  if (are_clearly_apart(p, q, common)) {
    return std::nullopt;
  }
  if (are_collinear(p) || are_collinear(q)) {
    return find_degenerate_contact(p, q, common);
  }
  switch (common) {
    case Common::Vertex:
      return contact_beyond_vertex(p, q);
    case Common::Edge:
      return contact_beyond_edge(p, q);
    default:
      return contact_of_strangers(p, q);
  }
}

}  // namespace meshalyzer
