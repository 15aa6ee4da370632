#include "meshalyzer/picture/internal/highlights.h"

#include "meshalyzer/picture/internal/contact_segments.h"
#include "meshalyzer/picture/internal/drawn_surface.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// The width of the visible margin round a highlight, in mean edge lengths.
constexpr double kEdgesRound = 3.0;
/// The smallest radius that can be viewed in single precision, as a share of the radius of the
/// scene.
constexpr double kSmallestView = 1e-5;

/// Returns the place of each face of the soup in the drawn surface.
std::vector<std::uint32_t> places_in(const DrawnSurface& surface, std::size_t n_faces) {
  std::vector<std::uint32_t> places(n_faces, kNoIndex);
  for (std::uint32_t i = 0; i < surface.n_faces(); ++i) places[surface.faces[i]] = i;
  return places;
}

/// Makes the highlight of one defect or change.
class HighlightMaker {
 public:
  HighlightMaker(const HighlightContext& place, std::span<const std::uint32_t> drawn_face,
                 const HighlightedElements& elements)
      : place_(place), drawn_face_(drawn_face), elements_(elements) {
    highlight_.number = elements.number;
    highlight_.is_cut = elements.is_cut;
  }

  [[nodiscard]] Highlight make() {
    for (const Index f : elements_.faces) add_face(f);
    for (const auto& [a, b] : elements_.edges) add_edge(a, b);
    for (const IntersectingPair& pair : elements_.pairs) add_contact(pair);
    for (const Index v : elements_.vertices) add_vertex(v);
    if (box_.isEmpty() || elements_.is_thin) add_positions();
    set_view();
    return std::move(highlight_);
  }

 private:
  void add_face(Index face) {
    if (!is_drawable(place_.soup, face)) {
      highlight_.is_cut = true;
      return;
    }
    const Triangle& t = place_.soup.triangles[face];
    for (const Index v : t) look_at_vertex(v);
    if (drawn_face_[face] == kNoIndex) {
      highlight_.is_cut = true;
    } else {
      highlight_.faces.push_back(drawn_face_[face]);
    }
    if (!elements_.is_thin) return;
    for (std::size_t i = 0; i < 3; ++i) add_segment(drawn(t[i]), drawn(t[(i + 1) % 3]));
  }

  void add_edge(Index a, Index b) {
    if (!is_finite(a) || !is_finite(b)) return;
    look_at_vertex(a);
    look_at_vertex(b);
    add_segment(drawn(a), drawn(b));
  }

  void add_contact(const IntersectingPair& pair) {
    const Corners a = corners_of(place_.soup, pair.face_a);
    const Corners b = corners_of(place_.soup, pair.face_b);
    for (const auto& [from, to] : contact_segments(a, b, pair.kind)) {
      if (from == to) {
        add_point(place_.frame(from));
      } else {
        add_segment(place_.frame(from), place_.frame(to));
      }
    }
  }

  void add_vertex(Index vertex) {
    if (!is_finite(vertex)) return;
    look_at_vertex(vertex);
    add_point(drawn(vertex));
  }

  void add_positions() {
    for (const Vec3& position : elements_.positions) {
      if (position.allFinite()) add_point(place_.frame(position));
    }
  }

  [[nodiscard]] bool is_finite(Index vertex) const {
    return place_.soup.positions[vertex].allFinite();
  }
  [[nodiscard]] Vec3 drawn(Index vertex) const {
    return place_.frame(place_.soup.positions[vertex]);
  }

  void add_point(const Vec3& point) {
    box_.extend(point);
    append_point(highlight_.points, point);
  }

  void add_segment(const Vec3& from, const Vec3& to) {
    box_.extend(from);
    box_.extend(to);
    append_point(highlight_.segments, from);
    append_point(highlight_.segments, to);
  }

  void look_at_vertex(Index vertex) {
    box_.extend(drawn(vertex));
    sum_of_lengths_ += place_.lengths.at(vertex);
    n_lengths_ += 1.0;
  }

  /// Sets the view: the sphere round the box of the highlight, with a margin.
  void set_view() {
    const Vec3 centre = box_.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box_.center());
    const double ball = box_.isEmpty() ? place_.frame.radius() : box_.sizes().norm() / 2;
    const double length = n_lengths_ > 0.0 ? sum_of_lengths_ / n_lengths_ : place_.lengths.mean();
    const double whole = std::max(ball, place_.frame.radius());
    const double smallest = kSmallestView * std::max(place_.frame.radius(), centre.norm());
    const double radius = std::max(std::min(ball + kEdgesRound * length, whole), smallest);
    for (std::size_t i = 0; i < 3; ++i) {
      highlight_.focus[i] = static_cast<float>(centre[static_cast<Eigen::Index>(i)]);
    }
    highlight_.radius = static_cast<float>(radius);
  }

  const HighlightContext& place_;
  std::span<const std::uint32_t> drawn_face_;
  const HighlightedElements& elements_;
  Highlight highlight_;
  /// The box of the highlight, in drawn coordinates.
  Box3 box_;
  double sum_of_lengths_ = 0.0;
  double n_lengths_ = 0.0;
};

}  // namespace

std::vector<Highlight> make_highlights(const HighlightContext& place,
                                       std::span<const HighlightedElements> elements) {
  if (elements.empty()) return {};
  const std::vector<std::uint32_t> drawn_face = places_in(place.detail, place.soup.n_faces());
  std::vector<Highlight> highlights;
  highlights.reserve(elements.size());
  for (const HighlightedElements& one : elements) {
    highlights.push_back(HighlightMaker(place, drawn_face, one).make());
  }
  return highlights;
}

}  // namespace meshalyzer
