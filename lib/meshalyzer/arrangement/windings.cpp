#include "meshalyzer/arrangement/windings.h"

#include "meshalyzer/exact/exact_point.h"

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// How often a ray leaves what faces enclose, counted for one component and for all others.
struct RayCount {
  int own = 0;
  int others = 0;
};

/// Follows a ray along an axis from a point inside a piece.
class ExactRay {
 public:
  /// @param start  In the inside of `piece`.
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

  /// @return  Nothing where the ray grazes an edge.
  std::optional<RayCount> follow() {
    descend(a_.tree.n_levels() - 1, 0);
    return grazes_ ? std::nullopt : std::optional(count_);
  }

 private:
  void descend(std::size_t level, std::size_t i) {
    for (unsigned bits = a_.tree.node(level, i).meeting(box_); bits != 0 && !grazes_;
         bits &= bits - 1) {
      const std::size_t child = 8 * i + static_cast<std::size_t>(std::countr_zero(bits));
      if (level == 0) {
        meet_face(a_.cut.side.faces[a_.tree.mesh_face(child)]);
      } else {
        descend(level - 1, child);
      }
    }
  }

  void meet_face(Index face) {
    const auto pieces = a_.arrangement.pieces_of(face);
    if (pieces.empty()) return;
    const Index component = a_.cells.component_of[pieces[0]];
    if (a_.cells.is_closed[component] == 0) return;
    for (const PieceSource& source : a_.arrangement.sources_of(piece_)) {
      if (source.face == face) return;
    }
    const Sign crossed = crossing(corners_of(a_.soup, face));
    (component == a_.cells.component_of[piece_] ? count_.own : count_.others) += crossed;
  }

  /// 1 where the ray leaves through a triangle, -1 where it enters.
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
    // Seen counter-clockwise along the axis, the normal points along it.
    return orient3d(t[0], t[1], t[2], start_) * *least < 0 ? *least : 0;
  }

  const ArrangedSoup& a_;
  Index piece_;
  Axis axis_;
  const ExactPoint& start_;
  TreeBox box_{};
  bool grazes_ = false;
  RayCount count_;
};

/// Finds winding numbers component by component.
class WindingSearch {
 public:
  WindingSearch(const ArrangedSoup& arranged, std::span<const std::uint8_t> wanted)
      : a_(arranged), wanted_(wanted) {
    windings_.own.assign(a_.cells.count, 0);
    windings_.others.assign(a_.cells.n_components, 0);
    is_known_.assign(a_.cells.count, 0);
    list_pieces();
  }

  Windings run() {
    std::vector<std::uint8_t> done(a_.cells.n_components, 0);
    for (Index piece = 0; piece < a_.arrangement.pieces.size(); ++piece) {
      const Index component = a_.cells.component_of[piece];
      if (wanted_[component] == 0 || a_.cells.is_closed[component] == 0) continue;
      if (std::exchange(done[component], 1) != 0) continue;
      begin_at(piece);
      spread();
    }
    return std::move(windings_);
  }

 private:
  /// The pieces at each cell.
  void list_pieces() {
    piece_begin_.assign(a_.cells.count + 1, 0);
    for (const Index cell : a_.cells.of_side) ++piece_begin_[cell + 1];
    std::partial_sum(piece_begin_.begin(), piece_begin_.end(), piece_begin_.begin());
    piece_at_.resize(a_.cells.of_side.size());
    std::vector<std::size_t> next(piece_begin_.begin(), piece_begin_.end() - 1);
    for (std::size_t side = 0; side < a_.cells.of_side.size(); ++side) {
      piece_at_[next[a_.cells.of_side[side]]++] = static_cast<Index>(side / 2);
    }
  }

  [[nodiscard]] ExactPoint place(Index vertex) const {
    const std::size_t n = a_.arrangement.n_input_vertices;
    return vertex < n ? exact_point(a_.soup.positions[vertex])
                      : a_.arrangement.exact.made(vertex - n);
  }

  /// A point inside a piece: the corners' mean by these weights.
  [[nodiscard]] ExactPoint inner_point(Index piece, const std::array<int, 3>& weights) const {
    const Triangle& t = a_.arrangement.pieces[piece];
    const std::array<ExactPoint, 3> corner{place(t[0]), place(t[1]), place(t[2])};
    const CGAL::Mpzf all = corner[0].denominator * corner[1].denominator * corner[2].denominator;
    std::array<CGAL::Mpzf, 3> numerator;
    for (std::size_t i = 0; i < 3; ++i) {
      const CGAL::Mpzf scale = CGAL::Mpzf(weights[i]) * corner[(i + 1) % 3].denominator *
                               corner[(i + 2) % 3].denominator;
      for (std::size_t k = 0; k < 3; ++k) {
        numerator[k] = numerator[k] + corner[i].numerator[k] * scale;
      }
    }
    return exact_point(std::move(numerator),
                       CGAL::Mpzf(weights[0] + weights[1] + weights[2]) * all);
  }

  /// Follows a ray from a piece. Rays from different points of it graze different edges.
  void begin_at(Index piece) {
    const auto plane = corners_of(a_.soup, a_.arrangement.sources_of(piece).front().face);
    const Axis axis = *projection_axis(plane[0], plane[1], plane[2]);
    for (int i = 0;; ++i) {
      const ExactPoint start = inner_point(piece, {101, 89 + 2 * i, 97 + 3 * i * i});
      const auto count = ExactRay(a_, piece, axis, start).follow();
      if (!count) continue;
      const Sign turn = orient2d(axis, plane[0], plane[1], plane[2]);
      set(turn > 0 ? a_.cells.front(piece) : a_.cells.behind(piece), count->own);
      windings_.others[a_.cells.component_of[piece]] = count->others;
      return;
    }
  }

  void set(Index cell, int winding) {
    if (std::exchange(is_known_[cell], 1) != 0) return;
    windings_.own[cell] = winding;
    pending_.push_back(cell);
  }

  /// Across pieces: behind each, what its faces enclose is one more.
  void spread() {
    while (!pending_.empty()) {
      const Index cell = pending_.back();
      pending_.pop_back();
      for (std::size_t i = piece_begin_[cell]; i < piece_begin_[cell + 1]; ++i) {
        const Index piece = piece_at_[i];
        const int step = a_.arrangement.multiplicity(piece);
        if (a_.cells.front(piece) == cell) set(a_.cells.behind(piece), windings_.own[cell] + step);
        if (a_.cells.behind(piece) == cell) set(a_.cells.front(piece), windings_.own[cell] - step);
      }
    }
  }

  const ArrangedSoup& a_;
  std::span<const std::uint8_t> wanted_;
  Windings windings_;
  std::vector<std::uint8_t> is_known_;
  std::vector<std::size_t> piece_begin_;
  std::vector<Index> piece_at_;
  std::vector<Index> pending_;
};

}  // namespace

Windings find_windings(const ArrangedSoup& arranged, std::span<const std::uint8_t> wanted) {
  return WindingSearch(arranged, wanted).run();
}

}  // namespace meshalyzer
