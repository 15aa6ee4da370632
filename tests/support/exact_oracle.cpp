#include "support/exact_oracle.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <algorithm>
#include <variant>
#include <vector>

namespace meshalyzer::test {
namespace {

using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<Rational>;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle3 = Kernel::Triangle_3;
using Figure = std::variant<Point, Segment, Triangle3>;

Point point(const Vec3& v) {
  return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

/// The convex hull of three points as the simplest figure.
Figure figure(const Corners& t) {
  const std::array<Point, 3> p{point(t[0]), point(t[1]), point(t[2])};
  if (!CGAL::collinear(p[0], p[1], p[2])) {
    return Triangle3(p[0], p[1], p[2]);
  }
  const auto [low, high] = std::minmax_element(p.begin(), p.end());
  if (*low == *high) {
    return *low;
  }
  return Segment(*low, *high);
}

/// The corners of the intersection of two figures (a convex set).
struct Collect {
  using result_type = void;
  std::vector<Point>& corners;
  void operator()(const Point& p) const { corners.push_back(p); }
  void operator()(const Segment& s) const {
    corners.insert(corners.end(), {s.source(), s.target()});
  }
  void operator()(const Triangle3& t) const { corners.insert(corners.end(), {t[0], t[1], t[2]}); }
  void operator()(const std::vector<Point>& polygon) const {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
  }
};

template <typename A, typename B>
std::vector<Point> intersect(const A& a, const B& b) {
  std::vector<Point> corners;
  if constexpr (std::is_same_v<A, Point>) {
    if constexpr (std::is_same_v<B, Point>) {
      if (a == b) {
        corners.push_back(a);
      }
    } else if (b.has_on(a)) {
      corners.push_back(a);
    }
  } else if constexpr (std::is_same_v<B, Point>) {
    return intersect(b, a);
  } else if (const auto result = CGAL::intersection(a, b)) {
    boost::apply_visitor(Collect{corners}, *result);
  }
  return corners;
}

bool is_in_common_part(const Point& x, const Corners& p, Common common) {
  switch (common) {
    case Common::Nothing:
      return false;
    case Common::Vertex:
      return x == point(p[0]);
    case Common::Edge:
      return point(p[0]) == point(p[1]) ? x == point(p[0])
                                        : Segment(point(p[0]), point(p[1])).has_on(x);
    case Common::All:
      return false;
  }
  return false;
}

bool is_inside(const Figure& figure, const Point& x) {
  if (const auto* t = std::get_if<Triangle3>(&figure)) {
    const bool on_border = Segment((*t)[0], (*t)[1]).has_on(x) ||
                           Segment((*t)[1], (*t)[2]).has_on(x) ||
                           Segment((*t)[2], (*t)[0]).has_on(x);
    return t->has_on(x) && !on_border;
  }
  if (const auto* s = std::get_if<Segment>(&figure)) {
    return s->has_on(x) && x != s->source() && x != s->target();
  }
  return false;
}

bool are_coplanar(const Corners& p, const Corners& q) {
  return std::all_of(q.begin(), q.end(), [&](const Vec3& x) {
    return CGAL::coplanar(point(p[0]), point(p[1]), point(p[2]), point(x));
  });
}

Point centre(const std::vector<Point>& corners) {
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  for (const Point& p : corners) {
    sum = sum + (p - CGAL::ORIGIN);
  }
  return CGAL::ORIGIN + sum / Rational(static_cast<int>(corners.size()));
}

}  // namespace

std::optional<ContactKind> oracle_contact(const Corners& p, const Corners& q, Common common) {
  if (common == Common::All) {
    return ContactKind::Duplicate;
  }
  const Figure a = figure(p);
  const Figure b = figure(q);
  const std::vector<Point> shared =
      std::visit([](const auto& x, const auto& y) { return intersect(x, y); }, a, b);
  const bool contact = std::any_of(shared.begin(), shared.end(), [&](const Point& x) {
    return !is_in_common_part(x, p, common);
  });
  if (!contact) {
    return std::nullopt;
  }
  if (common == Common::Edge) {
    return ContactKind::FoldOver;
  }
  const Point middle = centre(shared);
  const bool flat = std::holds_alternative<Triangle3>(a) && are_coplanar(p, q);
  if (flat || (std::holds_alternative<Triangle3>(b) && are_coplanar(q, p))) {
    return shared.size() > 2 ? ContactKind::CoplanarOverlap : ContactKind::Touching;
  }
  const bool thin = !std::holds_alternative<Triangle3>(a) && !std::holds_alternative<Triangle3>(b);
  return !thin && is_inside(a, middle) && is_inside(b, middle) ? ContactKind::Crossing
                                                               : ContactKind::Touching;
}

}  // namespace meshalyzer::test
