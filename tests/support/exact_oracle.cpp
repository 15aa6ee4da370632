#include "support/exact_oracle.h"

#include "support/rational_figures.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace meshalyzer::test {
namespace {

using Point = RationalPoint;
using Segment = RationalSegment;

RationalFigure figure(const Corners& t) {
  return hull_of({rational_point(t[0]), rational_point(t[1]), rational_point(t[2])});
}

bool is_in_common_part(const Point& x, const Corners& p, Common common) {
  switch (common) {
    case Common::Nothing:
      return false;
    case Common::Vertex:
      return x == rational_point(p[0]);
    case Common::Edge:
      return rational_point(p[0]) == rational_point(p[1])
                 ? x == rational_point(p[0])
                 : Segment(rational_point(p[0]), rational_point(p[1])).has_on(x);
    case Common::All:
      return false;
  }
  return false;
}

bool is_inside(const RationalFigure& figure, const Point& x) {
  if (const auto* t = std::get_if<RationalTriangle>(&figure)) {
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
    return CGAL::coplanar(rational_point(p[0]), rational_point(p[1]), rational_point(p[2]),
                          rational_point(x));
  });
}

Point centre(const std::vector<Point>& corners) {
  RationalKernel::Vector_3 sum = CGAL::NULL_VECTOR;
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
  const RationalFigure a = figure(p);
  const RationalFigure b = figure(q);
  const std::vector<Point> shared = intersect(a, b);
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
  const bool flat = std::holds_alternative<RationalTriangle>(a) && are_coplanar(p, q);
  if (flat || (std::holds_alternative<RationalTriangle>(b) && are_coplanar(q, p))) {
    return shared.size() > 2 ? ContactKind::CoplanarOverlap : ContactKind::Touching;
  }
  const bool thin =
      !std::holds_alternative<RationalTriangle>(a) && !std::holds_alternative<RationalTriangle>(b);
  return !thin && is_inside(a, middle) && is_inside(b, middle) ? ContactKind::Crossing
                                                               : ContactKind::Touching;
}

}  // namespace meshalyzer::test
