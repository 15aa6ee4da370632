#include "support/arrangement_oracle.h"

#include "meshalyzer/exact/exact_point.h"
#include "support/rational_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <vector>

namespace meshalyzer::test {
namespace {

using Point = RationalPoint;
using Vector = RationalVector;

/// Judges one arrangement.
class Judge {
 public:
  Judge(const Soup& soup, const Arrangement& arrangement) : soup_(soup), a_(arrangement) {
    for (std::size_t v = 0; v < a_.positions.size(); ++v) places_.push_back(place(v));
  }

  std::string fault() {
    check_vertices();
    check_sources();
    check_areas();
    check_uncut();
    check_curves();
    check_pairs();
    return fault_;
  }

  [[nodiscard]] const std::vector<Point>& places() const { return places_; }

 private:
  using Corners3 = std::array<Point, 3>;

  [[nodiscard]] Point place(std::size_t v) const {
    if (v < a_.n_input_vertices) return rational_point(a_.positions[v]);
    const ExactPoint& exact = a_.exact.made(v - a_.n_input_vertices);
    const Rational w(exact.denominator);
    return {Rational(exact.numerator[0]) / w, Rational(exact.numerator[1]) / w,
            Rational(exact.numerator[2]) / w};
  }

  void blame(const std::string& what, std::size_t number) {
    if (fault_.empty()) fault_ = what + " " + std::to_string(number);
  }

  [[nodiscard]] Corners3 corners(const Triangle& t) const {
    return {places_[t[0]], places_[t[1]], places_[t[2]]};
  }
  static Vector area(const Corners3& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]); }

  void check_vertices() {
    std::map<Point, Index> at;
    std::set<Index> used;
    for (std::size_t i = 0; i < a_.pieces.size(); ++i) {
      const Triangle& piece = a_.pieces[i];
      const Index face = a_.sources_of(i).front().face;
      const bool is_cut = std::binary_search(a_.cut_faces.begin(), a_.cut_faces.end(), face);
      const bool is_flat = area(corners(piece)) == CGAL::NULL_VECTOR;
      if (is_cut || !is_flat) used.insert(piece.begin(), piece.end());
    }
    for (const Index v : used) {
      if (!at.emplace(places_[v], v).second) blame("two vertices at the place of", v);
    }
    for (std::size_t v = a_.n_input_vertices; v < places_.size(); ++v) {
      for (int k = 0; k < 3; ++k) {
        if (!is_nearest(places_[v][k], a_.positions[v][k])) blame("not the nearest double:", v);
      }
    }
  }

  static bool is_nearest(const Rational& x, double rounded) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const Rational error = CGAL::abs(x - Rational(rounded));
    return error <= CGAL::abs(x - Rational(std::nextafter(rounded, kFar))) &&
           error <= CGAL::abs(x - Rational(std::nextafter(rounded, -kFar)));
  }

  void check_sources() {
    for (std::size_t i = 0; i < a_.pieces.size(); ++i) {
      const Corners3 piece = corners(a_.pieces[i]);
      if (a_.sources_of(i).empty() || a_.sources_of(i).front().sign != 1) {
        blame("no first source of piece", i);
      }
      for (const auto& [face, sign] : a_.sources_of(i)) {
        const Corners3 whole = corners(soup_.triangles[face]);
        const RationalFigure figure = hull_of(whole);
        for (const Point& p : piece) {
          if (intersect(RationalFigure(p), figure).empty()) blame("outside its face: piece", i);
        }
        const Rational dot = area(piece) * area(whole);
        const bool flat = area(whole) == CGAL::NULL_VECTOR;
        if (flat ? area(piece) != CGAL::NULL_VECTOR : dot * sign <= 0) {
          blame("turned the wrong way: piece", i);
        }
      }
    }
  }

  void check_areas() {
    for (Index f = 0; f < soup_.n_faces(); ++f) {
      if (!is_in_complex(soup_.triangles[f])) continue;
      Vector sum = CGAL::NULL_VECTOR;
      for (const Index piece : a_.pieces_of(f)) {
        for (const auto& [face, sign] : a_.sources_of(piece)) {
          if (face == f) sum = sum + Rational(sign) * area(corners(a_.pieces[piece]));
        }
      }
      if (sum != area(corners(soup_.triangles[f]))) blame("pieces do not add up to face", f);
    }
  }

  void check_uncut() {
    for (Index f = 0; f < soup_.n_faces(); ++f) {
      const Triangle& t = soup_.triangles[f];
      if (!is_in_complex(t) || std::binary_search(a_.cut_faces.begin(), a_.cut_faces.end(), f) ||
          area(corners(t)) == CGAL::NULL_VECTOR) {
        continue;
      }
      if (a_.pieces_of(f).size() != 1 || a_.pieces[a_.pieces_of(f)[0]] != t) {
        blame("cut without need: face", f);
      }
    }
  }

  void check_curves() {
    std::set<std::array<Index, 2>> edges;
    for (const Triangle& t : a_.pieces) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
        edges.insert({low, high});
      }
    }
    for (std::size_t i = 0; i < a_.curves.size(); ++i) {
      if (edges.count(a_.curves[i]) == 0) blame("no edge of pieces: curve", i);
    }
  }

  void check_pairs() {
    std::vector<RationalFigure> figures;
    std::vector<Box3> boxes;
    for (const Triangle& t : a_.pieces) {
      figures.push_back(hull_of(corners(t)));
      Box3 box;
      for (const Index v : t) box.extend(a_.positions[v]);
      boxes.push_back(box);
    }
    for (std::size_t i = 0; i < figures.size(); ++i) {
      for (std::size_t j = i + 1; j < figures.size(); ++j) {
        // Rounding to the nearest is monotone: what meets has boxes that meet.
        if (boxes[i].intersects(boxes[j]) && meet_beyond_common({i, j}, figures)) {
          blame("piece " + std::to_string(i) + " meets piece", j);
        }
      }
    }
  }

  [[nodiscard]] bool meet_beyond_common(std::array<std::size_t, 2> pair,
                                        const std::vector<RationalFigure>& figures) const {
    std::vector<Point> common;
    for (const Index v : a_.pieces[pair[0]]) {
      const Triangle& other = a_.pieces[pair[1]];
      if (std::find(other.begin(), other.end(), v) != other.end()) common.push_back(places_[v]);
    }
    if (common.size() == 3) return true;
    if (are_apart(pair[0], pair[1]) || are_apart(pair[1], pair[0])) return false;
    const std::vector<Point> shared = intersect(figures[pair[0]], figures[pair[1]]);
    return std::any_of(shared.begin(), shared.end(), [&](const Point& x) {
      if (common.size() == 2) return !RationalSegment(common[0], common[1]).has_on(x);
      return common.empty() || x != common[0];
    });
  }

  /// Tells whether the plane of one piece, or the line along one of its edges in that plane, has
  /// all of the other beyond it but for common vertices on it.
  [[nodiscard]] bool are_apart(std::size_t i, std::size_t j) const {
    const Corners3 p = corners(a_.pieces[i]);
    if (CGAL::collinear(p[0], p[1], p[2])) return false;
    const auto beyond = [&](const auto& side_of) {
      int side = 0;
      for (const Index v : a_.pieces[j]) {
        const auto found = std::find(a_.pieces[i].begin(), a_.pieces[i].end(), v);
        const int here = side_of(places_[v]);
        if (found != a_.pieces[i].end() ? here != 0 : here == 0 || here * side < 0) return 0;
        if (here != 0) side = here;
      }
      return side;
    };
    const auto side_of_plane = [&](const Point& x) {
      return static_cast<int>(CGAL::orientation(p[0], p[1], p[2], x));
    };
    if (beyond(side_of_plane) != 0) return true;
    if (side_of_plane(places_[a_.pieces[j][0]]) != 0 ||
        side_of_plane(places_[a_.pieces[j][1]]) != 0 ||
        side_of_plane(places_[a_.pieces[j][2]]) != 0) {
      return false;
    }
    const Vector normal = area(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector inwards = CGAL::cross_product(normal, p[(k + 1) % 3] - p[k]);
      const auto side_of_edge = [&](const Point& x) {
        return static_cast<int>(CGAL::sign(inwards * (x - p[k])));
      };
      if (beyond(side_of_edge) < 0) return true;
    }
    return false;
  }

  const Soup& soup_;
  const Arrangement& a_;
  std::vector<Point> places_;
  std::string fault_;
};

/// A point, and the doubles nearest to it.
struct Spot {
  Point exact;
  Vec3 rounded;
};

/// The exact orientation. For coordinates up to some ten, floating point is sure of it but near
/// zero.
int orientation(const Spot& a, const Spot& b, const Spot& c, const Spot& d) {
  const Vec3 normal = (b.rounded - a.rounded).cross(c.rounded - a.rounded);
  const double determinant = normal.dot(d.rounded - a.rounded);
  if (std::abs(determinant) > 1e-6) return determinant > 0.0 ? 1 : -1;
  return static_cast<int>(CGAL::orientation(a.exact, b.exact, c.exact, d.exact));
}

/// Returns how often a segment crosses a triangle against its normal; nothing where it grazes.
std::optional<int> crossing(const std::array<Spot, 3>& t, const Spot& from, const Spot& to) {
  const int before = orientation(t[0], t[1], t[2], from);
  const int behind = orientation(t[0], t[1], t[2], to);
  if (before == 0 || behind == 0) return std::nullopt;
  if (before == behind) return 0;
  const int u = orientation(from, to, t[0], t[1]);
  const int v = orientation(from, to, t[1], t[2]);
  const int w = orientation(from, to, t[2], t[0]);
  if (u * v < 0 || v * w < 0 || w * u < 0) return 0;
  if (u == 0 || v == 0 || w == 0) return std::nullopt;
  return behind;
}

/// Returns how often a segment crosses triangles, each counted as often as it is listed.
template <typename Multiplicity>
std::optional<int> crossings(const std::vector<Spot>& spots, std::span<const Triangle> triangles,
                             const Multiplicity& multiplicity, const std::array<Spot, 2>& ends) {
  int sum = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const auto one = crossing({spots[t[0]], spots[t[1]], spots[t[2]]}, ends[0], ends[1]);
    if (!one) return std::nullopt;
    sum += multiplicity(i) * *one;
  }
  return sum;
}

}  // namespace

std::string arrangement_fault(const Soup& soup, const Arrangement& arrangement) {
  return Judge(soup, arrangement).fault();
}

std::string winding_fault(const Soup& soup, const Arrangement& arrangement, std::size_t n) {
  const std::vector<Point> places = Judge(soup, arrangement).places();
  std::vector<Spot> spots;
  for (std::size_t v = 0; v < places.size(); ++v) {
    spots.push_back({places[v], arrangement.positions[v]});
  }
  Box3 box;
  for (const Vec3& p : soup.positions) box.extend(p);
  std::mt19937 random(7);
  const auto spot = [&](double widening) {
    Vec3 t;
    for (double& x : t) x = std::uniform_real_distribution<>(-widening, 1 + widening)(random);
    const Vec3 place = box.min() + t.cwiseProduct(box.sizes());
    return Spot{rational_point(place), place};
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<Spot, 2> ends{spot(0.1), spot(4.0)};
    const auto expected = crossings(
        spots, soup.triangles, [](std::size_t) { return 1; }, ends);
    const auto found = crossings(
        spots, arrangement.pieces, [&](std::size_t k) { return arrangement.multiplicity(k); },
        ends);
    if (expected && found && *expected != *found) {
      return "winding number of point " + std::to_string(i);
    }
  }
  return {};
}

}  // namespace meshalyzer::test
