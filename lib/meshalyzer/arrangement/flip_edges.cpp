#include "meshalyzer/arrangement/flip_edges.h"

#include <array>
#include <cmath>

namespace meshalyzer {
namespace {

/// The largest number of flips. In theory flipping ends; this bound ends it in spite of rounding.
constexpr std::size_t kFlipsPerTriangle = 64;

/// A point in the projection.
using Vec2 = Eigen::Vector2d;

class Flips {
 public:
  explicit Flips(Triangulation& triangulation) : t_(triangulation) {
    const auto dropped = static_cast<Eigen::Index>(t_.dropped);
    const Eigen::Index i = (dropped + 1) % 3;
    const Eigen::Index j = (dropped + 2) % 3;
    const Vec3& origin = t_.points.front()->rounded;
    places_.reserve(t_.points.size());
    for (const ExactPoint* const p : t_.points) {
      places_.emplace_back(p->rounded[i] - origin[i], p->rounded[j] - origin[j]);
    }
  }

  void run() {
    for (Index h = 0; h < t_.origin.size(); ++h) pending_.push_back(h);
    std::size_t left = kFlipsPerTriangle * t_.n_triangles();
    while (!pending_.empty() && left != 0) {
      const Index h = pending_.back();
      pending_.pop_back();
      if (!is_worth_flipping(h)) continue;
      flip(h);
      --left;
    }
  }

 private:
  /// The corners of the two triangles at an edge: its ends a and b, c on its left, d on its right.
  struct Quad {
    Index a, b, c, d;
  };

  [[nodiscard]] Quad quad(Index h) const {
    return {t_.origin[h], t_.target(h), t_.origin[Triangulation::previous(h)],
            t_.origin[Triangulation::previous(t_.twin[h])]};
  }

  [[nodiscard]] bool is_worth_flipping(Index h) const {
    if (t_.twin[h] == kNoIndex || t_.constrained[h] != 0) return false;
    const auto [a, b, c, d] = quad(h);
    return is_in_circle({a, b, c}, d) && t_.turn(a, d, c) > 0 && t_.turn(d, b, c) > 0;
  }

  /// Tells whether d lies clearly inside the circle through a triangle's corners.
  [[nodiscard]] bool is_in_circle(const std::array<Index, 3>& triangle, Index d) const {
    double determinant = 0.0;
    double magnitude = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 p = places_[triangle[i]] - places_[d];
      const Vec2 q = places_[triangle[(i + 1) % 3]] - places_[d];
      const Vec2 r = places_[triangle[(i + 2) % 3]] - places_[d];
      const double first = q.x() * r.y();
      const double second = q.y() * r.x();
      determinant += p.squaredNorm() * (first - second);
      magnitude += p.squaredNorm() * (std::abs(first) + std::abs(second));
    }
    return determinant > 0x1p-48 * magnitude;
  }

  /// Replaces the edge a b of the triangles a b c and b a d by d c.
  void flip(Index h) {
    const Index g = t_.twin[h];
    const auto [a, b, c, d] = quad(h);
    const Index bc = Triangulation::next(h);
    const Index ca = Triangulation::previous(h);
    const Index ad = Triangulation::next(g);
    const Index db = Triangulation::previous(g);
    const Index outer_bc = t_.twin[bc];
    const Index outer_ad = t_.twin[ad];
    const std::uint8_t mark_bc = t_.constrained[bc];
    const std::uint8_t mark_ad = t_.constrained[ad];
    // h's triangle becomes d c a, with c a where it was; g's becomes c d b.
    t_.origin[h] = d;
    t_.origin[bc] = c;
    t_.origin[ca] = a;
    t_.origin[g] = c;
    t_.origin[ad] = d;
    t_.origin[db] = b;
    relink(t_.twin[ca], bc, t_.constrained[ca]);
    relink(outer_ad, ca, mark_ad);
    relink(t_.twin[db], ad, t_.constrained[db]);
    relink(outer_bc, db, mark_bc);
    t_.leaving[a] = ca;
    t_.leaving[b] = db;
    t_.leaving[c] = g;
    t_.leaving[d] = h;
    pending_.insert(pending_.end(), {bc, ca, ad, db});
  }

  void relink(Index outer, Index h, std::uint8_t mark) {
    t_.twin[h] = kNoIndex;
    t_.link(h, outer);
    t_.constrained[h] = mark;
  }

  Triangulation& t_;
  std::vector<Vec2> places_;
  std::vector<Index> pending_;
};

}  // namespace

void flip_edges(Triangulation& triangulation) {
  Flips(triangulation).run();
}

}  // namespace meshalyzer
