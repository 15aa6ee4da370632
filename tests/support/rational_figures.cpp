#include "support/rational_figures.h"

#include <CGAL/intersections.h>
#include <algorithm>

namespace meshalyzer::test {
namespace {

using Point = RationalPoint;
using Segment = RationalSegment;

struct Collect {
  using result_type = void;
  std::vector<Point>& corners;
  void operator()(const Point& p) const { corners.push_back(p); }
  void operator()(const Segment& s) const {
    corners.insert(corners.end(), {s.source(), s.target()});
  }
  void operator()(const RationalTriangle& t) const {
    corners.insert(corners.end(), {t[0], t[1], t[2]});
  }
  void operator()(const std::vector<Point>& polygon) const {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
  }
};

template <typename A, typename B>
std::vector<Point> corners_of_intersection(const A& a, const B& b) {
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
    return corners_of_intersection(b, a);
  } else if (const auto result = CGAL::intersection(a, b)) {
    boost::apply_visitor(Collect{corners}, *result);
  }
  return corners;
}

}  // namespace

RationalPoint rational_point(const Vec3& v) {
  return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

RationalFigure hull_of(const std::array<RationalPoint, 3>& p) {
  if (!CGAL::collinear(p[0], p[1], p[2])) {
    return RationalTriangle(p[0], p[1], p[2]);
  }
  const auto [low, high] = std::minmax_element(p.begin(), p.end());
  if (*low == *high) {
    return *low;
  }
  return Segment(*low, *high);
}

std::vector<RationalPoint> intersect(const RationalFigure& a, const RationalFigure& b) {
  return std::visit([](const auto& x, const auto& y) { return corners_of_intersection(x, y); }, a,
                    b);
}

}  // namespace meshalyzer::test
