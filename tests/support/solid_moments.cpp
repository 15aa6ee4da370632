#include "support/solid_moments.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer::test {
namespace {

using Point = RationalPoint;
using Numbers = std::vector<Rational>;

void sort_unique(Numbers& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// The integral of a polynomial of degree 3 at most from one number to another, by Milne's open
/// formula, which never looks at the ends.
template <typename Value>
Moments integral(const Rational& from, const Rational& to, const Value& value_at) {
  const Rational quarter = (to - from) / 4;
  const Moments first = value_at(from + quarter);
  const Moments middle = value_at(from + 2 * quarter);
  const Moments last = value_at(to - quarter);
  Moments sum;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k] = (to - from) * (2 * first[k] - middle[k] + 2 * last[k]) / 3;
  }
  return sum;
}

/// The integral over all intervals between numbers that follow each other, on each of which the
/// value is such a polynomial.
template <typename Value>
Moments integral(const Numbers& breaks, const Value& value_at) {
  Moments sum{};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const Moments part = integral(breaks[i], breaks[i + 1], value_at);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
  }
  return sum;
}

/// The heights where the cross-section of triangles changes its shape: those of corners, of the
/// ends of what two triangles have in common, and of what three have.
Numbers heights_of(const std::vector<RationalCorners>& triangles) {
  Numbers heights;
  std::vector<RationalFigure> figures;
  for (const RationalCorners& t : triangles) {
    figures.push_back(hull_of(t));
    for (const Point& p : t) heights.push_back(p.z());
  }
  const auto add = [&](const std::vector<Point>& points) {
    for (const Point& p : points) heights.push_back(p.z());
  };
  for (std::size_t i = 0; i < figures.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<Point> common = intersect(figures[i], figures[j]);
      add(common);
      for (std::size_t a = 0; a < common.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          if (common[a] == common[b]) continue;
          const RationalFigure segment = RationalSegment(common[a], common[b]);
          for (std::size_t k = 0; k < j; ++k) add(intersect(segment, figures[k]));
        }
      }
    }
  }
  sort_unique(heights);
  return heights;
}

/// A side of a cross-section: where the plane of a height crosses a triangle.
struct Side {
  std::array<Rational, 2> x;
  std::array<Rational, 2> y;
  /// The winding number on its right minus that on its left.
  int step = 0;

  [[nodiscard]] Rational x_at(const Rational& at) const {
    return x[0] + (x[1] - x[0]) * (at - y[0]) / (y[1] - y[0]);
  }
};

/// The sides at a height that no corner has, but those along x.
std::vector<Side> sides_at(const std::vector<RationalCorners>& triangles, const Rational& z) {
  std::vector<Side> sides;
  for (const RationalCorners& t : triangles) {
    Side side;
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = t[k];
      const Point& q = t[(k + 1) % 3];
      if ((p.z() < z) == (q.z() < z)) continue;
      const Rational share = (z - p.z()) / (q.z() - p.z());
      side.x[n] = p.x() + share * (q.x() - p.x());
      side.y[n] = p.y() + share * (q.y() - p.y());
      ++n;
    }
    if (n == 0 || side.y[0] == side.y[1]) continue;
    const Rational normal_x = CGAL::cross_product(t[1] - t[0], t[2] - t[0]).x();
    side.step = normal_x < 0 ? 1 : -1;
    sides.push_back(std::move(side));
  }
  return sides;
}

/// Where strips of a cross-section begin and end: at the ends of sides, and where sides cross.
Numbers strips_of(const std::vector<Side>& sides) {
  Numbers breaks;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& a = sides[i];
    breaks.insert(breaks.end(), a.y.begin(), a.y.end());
    for (std::size_t j = 0; j < i; ++j) {
      const Side& b = sides[j];
      // Their difference is linear in y, so that it is known from two places.
      const Rational at_0 = a.x_at(0) - b.x_at(0);
      const Rational at_1 = a.x_at(1) - b.x_at(1);
      if (at_0 != at_1) breaks.push_back(at_0 / (at_0 - at_1));
    }
  }
  sort_unique(breaks);
  return breaks;
}

/// The integrals of 1, x, y and z along a line, over what is gone round at least once.
Moments moments_of_line(const std::vector<Side>& sides, const Rational& y, const Rational& z) {
  std::vector<std::pair<Rational, int>> crossings;
  for (const Side& side : sides) {
    if ((side.y[0] < y) != (side.y[1] < y)) crossings.emplace_back(side.x_at(y), side.step);
  }
  std::sort(crossings.begin(), crossings.end());
  Moments sum{};
  int winding = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    winding += crossings[i].second;
    if (winding < 1) continue;
    const Rational& from = crossings[i].first;
    const Rational& to = crossings[i + 1].first;
    sum[0] += to - from;
    sum[1] += (to * to - from * from) / 2;
  }
  sum[2] = y * sum[0];
  sum[3] = z * sum[0];
  return sum;
}

}  // namespace

Moments moments_inside(const std::vector<RationalCorners>& triangles) {
  return integral(heights_of(triangles), [&](const Rational& z) {
    const std::vector<Side> sides = sides_at(triangles, z);
    return integral(strips_of(sides),
                    [&](const Rational& y) { return moments_of_line(sides, y, z); });
  });
}

Moments moments_enclosed(const std::vector<RationalCorners>& triangles) {
  Moments sum{};
  for (const auto& [a, b, c] : triangles) {
    const auto p = a - CGAL::ORIGIN;
    const auto q = b - CGAL::ORIGIN;
    const auto r = c - CGAL::ORIGIN;
    const Rational volume = CGAL::determinant(p, q, r) / 6;
    sum[0] += volume;
    for (int k = 0; k < 3; ++k) {
      sum[static_cast<std::size_t>(k) + 1] += volume * (p[k] + q[k] + r[k]) / 4;
    }
  }
  return sum;
}

}  // namespace meshalyzer::test
