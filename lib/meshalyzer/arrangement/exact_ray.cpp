#include "meshalyzer/arrangement/exact_ray.h"

#include "meshalyzer/exact/exact_point.h"
#include "meshalyzer/spatial/visit_meeting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// Follows a ray along an axis from a point inside a piece.
class ExactRay {
 public:
  /// @param start  A point inside `piece`.
  ExactRay(const ArrangedSoup& arranged, Index piece, Axis axis, const ExactPoint& start)
      : a_(arranged), piece_(piece), axis_(axis), start_(start) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Vec3 low = start.rounded;
    Vec3 high = start.rounded;
    for (Eigen::Index k = 0; k < 3; ++k) {
      low[k] = std::nextafter(low[k], -kFar);
      high[k] = k == static_cast<Eigen::Index>(axis) ? kFar : std::nextafter(high[k], kFar);
    }
    box_ = {a_.tree.map(low), a_.tree.map(high)};
  }

  /// @return  Nothing if the ray grazes an edge.
  std::optional<std::vector<RayCrossing>> follow() {
    visit_meeting(a_.tree, box_, [&](std::size_t slot) {
      meet_face(a_.cut.side.faces[a_.tree.mesh_face(slot)]);
      return !grazes_;
    });
    return grazes_ ? std::nullopt : std::optional(std::move(crossings_));
  }

 private:
  void meet_face(Index face) {
    const Index component = a_.component_of_face(face);
    if (component == kNoIndex || a_.cells.is_closed[component] == 0) return;
    for (const PieceSource& source : a_.arrangement.sources_of(piece_)) {
      if (source.face == face) return;
    }
    const Sign sign = crossing(corners_of(a_.soup, face));
    if (sign != 0) crossings_.push_back({face, sign});
  }

  /// Returns 1 if the ray leaves through a triangle, -1 if it enters, 0 if it misses it.
  Sign crossing(const std::array<Vec3, 3>& t) {
    std::array<Sign, 3> turns{};
    for (std::size_t k = 0; k < 3; ++k) {
      turns[k] = orient2d(axis_, exact_point(t[k]), exact_point(t[(k + 1) % 3]), start_);
    }
    const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
    if (*least * *most < 0) return 0;
    if (*least == 0 || *most == 0) {
      grazes_ = true;
      return 0;
    }
    // The normal of a triangle that is counter-clockwise along the axis points along it.
    return orient3d(t[0], t[1], t[2], start_) * *least < 0 ? *least : 0;
  }

  const ArrangedSoup& a_;
  Index piece_;
  Axis axis_;
  const ExactPoint& start_;
  TreeBox box_{};
  bool grazes_ = false;
  std::vector<RayCrossing> crossings_;
};

ExactPoint place_of(const ArrangedSoup& arranged, Index vertex) {
  const std::size_t n = arranged.arrangement.n_input_vertices;
  return vertex < n ? exact_point(arranged.soup.positions[vertex])
                    : arranged.arrangement.exact.made(vertex - n);
}

/// Returns a point inside a piece: the weighted mean of its corners.
ExactPoint inner_point(const ArrangedSoup& arranged, Index piece,
                       const std::array<int, 3>& weights) {
  const Triangle& t = arranged.arrangement.pieces[piece];
  const std::array<ExactPoint, 3> corner{place_of(arranged, t[0]), place_of(arranged, t[1]),
                                         place_of(arranged, t[2])};
  const CGAL::Mpzf all = corner[0].denominator * corner[1].denominator * corner[2].denominator;
  std::array<CGAL::Mpzf, 3> numerator;
  for (std::size_t i = 0; i < 3; ++i) {
    const CGAL::Mpzf scale =
        CGAL::Mpzf(weights[i]) * corner[(i + 1) % 3].denominator * corner[(i + 2) % 3].denominator;
    for (std::size_t k = 0; k < 3; ++k) {
      numerator[k] = numerator[k] + corner[i].numerator[k] * scale;
    }
  }
  return exact_point(std::move(numerator), CGAL::Mpzf(weights[0] + weights[1] + weights[2]) * all);
}

}  // namespace

PieceRay follow_ray(const ArrangedSoup& arranged, Index piece) {
  const auto plane = corners_of(arranged.soup, arranged.arrangement.sources_of(piece).front().face);
  const Axis axis = *projection_axis(plane[0], plane[1], plane[2]);
  const Sign turn = orient2d(axis, plane[0], plane[1], plane[2]);
  const Index cell = turn > 0 ? arranged.cells.front(piece) : arranged.cells.behind(piece);
  // Another point of the piece gives a ray that grazes other edges, if any.
  for (int i = 0;; ++i) {
    const ExactPoint start = inner_point(arranged, piece, {101, 89 + 2 * i, 97 + 3 * i * i});
    auto crossings = ExactRay(arranged, piece, axis, start).follow();
    if (crossings) return {cell, std::move(*crossings)};
  }
}

}  // namespace meshalyzer
