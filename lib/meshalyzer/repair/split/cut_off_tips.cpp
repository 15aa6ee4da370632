#include "meshalyzer/repair/edits/internal/closed_fan.h"
#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/split/internal/contact_places.h"
#include "meshalyzer/repair/split/internal/tip_lid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The edges of a tip are cut off at most at this share of their lengths, or at this share of the
/// deviation.
constexpr double kLargestShareOfEdge = 0.25;
constexpr double kShareOfDeviation = 0.5;
/// The shortest tips have this share of the largest length. Longer ones are tried if shorter ones
/// cannot be closed or would leave flat faces, each longer by this factor.
constexpr double kShortestShare = 0x1p-9;
constexpr double kLongerBy = 8.0;
/// As many vertices at a place are tried at most.
constexpr std::size_t kMostUnits = 4;
constexpr std::size_t kMostFacesAtTip = 256;

/// The faces round a vertex, in the order in which they surround it.
struct Tip {
  Index vertex = kNoIndex;
  /// By index into the soup: face i has the corners `vertex`, around[i] and around[i + 1].
  std::vector<Index> faces;
  std::vector<Index> around;

  [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) % faces.size(); }
};

/// What a tip is replaced by: points on its edges, in the order of Tip::around, and a lid.
struct CutTip {
  std::vector<Vec3> points;
  /// By number of the points.
  std::vector<Triangle> lid;
};

/// Cuts off one vertex at each place.
class TipCutter {
 public:
  TipCutter(const PassInput& input, const ContactPlaces& contacts)
      : input_(input),
        contacts_(contacts),
        soup_(input.mesh.soup()),
        is_used_(soup_.n_faces(), 0) {}

  PassResult run() {
    for (const ContactPlace& place : contacts_.places) cut_off_one(place);
    return std::move(result_);
  }

 private:
  /// Cuts off one of the last vertices of a place, which are the copies.
  void cut_off_one(const ContactPlace& place) {
    const std::size_t n_units = place.units.size();
    for (std::size_t rank = 0; rank < std::min(n_units, kMostUnits); ++rank) {
      const std::vector<Index>& unit = place.units[n_units - 1 - rank];
      if (unit.size() != 1) continue;
      const std::optional<Tip> tip = tip_at(unit.front());
      if (!tip) continue;
      const std::vector<Vec3> others = others_at(place, tip->vertex);
      for (double share = kShortestShare; share <= 1.0; share *= kLongerBy) {
        const std::optional<CutTip> cut = cut_off(*tip, share, others);
        if (!cut || leaves_flat_faces(*tip, *cut)) continue;
        propose(*tip, *cut);
        return;
      }
    }
  }

  [[nodiscard]] std::span<const Index> faces_round(Index vertex) const {
    return contacts_.incident.faces(contacts_.incident.entry_of(vertex));
  }

  /// Returns the tip of a vertex; nothing if it may not be cut off, or if its faces are no fan of
  /// one orientation that surrounds it.
  [[nodiscard]] std::optional<Tip> tip_at(Index vertex) const {
    const std::span<const Index> faces = faces_round(vertex);
    const bool is_taken = std::any_of(faces.begin(), faces.end(), [&](Index face) {
      return is_used_[face] != 0 || input_.limits.has_fixed_corner(input_.tracked, face);
    });
    if (is_taken || faces.size() > kMostFacesAtTip) return std::nullopt;
    std::vector<Triangle> triangles;
    for (const Index face : faces) triangles.push_back(soup_.triangles[face]);
    const std::optional<std::vector<Index>> fan = closed_fan(triangles, vertex);
    if (!fan) return std::nullopt;
    Tip tip{.vertex = vertex, .faces = {}, .around = {}};
    for (const Index i : *fan) {
      tip.faces.push_back(faces[i]);
      tip.around.push_back(with_first(triangles[i], vertex)[1]);
    }
    return tip;
  }

  /// Returns the other corners of the faces round the other vertices at a place.
  [[nodiscard]] std::vector<Vec3> others_at(const ContactPlace& place, Index vertex) const {
    std::vector<Vec3> others;
    for (const std::vector<Index>& unit : place.units) {
      for (const Index v : unit) {
        if (v == vertex) continue;
        for (const Index face : faces_round(v)) {
          const Triangle t = with_first(soup_.triangles[face], v);
          others.insert(others.end(), {soup_.positions[t[1]], soup_.positions[t[2]]});
        }
      }
    }
    return others;
  }

  /// Cuts a tip off at a share of the longest possible lengths; nothing if an edge is too short for
  /// that, or if no lid is found.
  [[nodiscard]] std::optional<CutTip> cut_off(const Tip& tip, double share,
                                              std::span<const Vec3> others) const {
    CutTip cut;
    for (const Index other : tip.around) {
      const std::optional<Vec3> point = point_on_edge(tip.vertex, other, share);
      if (!point) return std::nullopt;
      cut.points.push_back(*point);
    }
    std::optional<std::vector<Triangle>> lid =
        close_tip(soup_.positions[tip.vertex], cut.points, others);
    if (!lid) return std::nullopt;
    cut.lid = std::move(*lid);
    return cut;
  }

  /// Returns the point where an edge is cut off; nothing if the edge is too short.
  [[nodiscard]] std::optional<Vec3> point_on_edge(Index vertex, Index other, double share) const {
    const Vec3& from = soup_.positions[vertex];
    const Vec3 edge = soup_.positions[other] - from;
    const double of_deviation = kShareOfDeviation * input_.limits.max_deviation / edge.stableNorm();
    const Vec3 point = from + share * std::min(kLargestShareOfEdge, of_deviation) * edge;
    if (point == from || point == soup_.positions[other]) return std::nullopt;
    return point;
  }

  /// Returns the two triangles that are left of face i of a tip. Points are numbered after the
  /// vertices, from `first_point`.
  [[nodiscard]] static std::array<Triangle, 2> sides_of(const Tip& tip, std::size_t i,
                                                        Index first_point) {
    const Index a = tip.around[i];
    const Index b = tip.around[tip.after(i)];
    const Index point_a = first_point + static_cast<Index>(i);
    const Index point_b = first_point + static_cast<Index>(tip.after(i));
    return {{{a, b, point_b}, {a, point_b, point_a}}};
  }

  /// Tells whether more of the new faces than of those that they replace are flat.
  [[nodiscard]] bool leaves_flat_faces(const Tip& tip, const CutTip& cut) const {
    const auto n_vertices = static_cast<Index>(soup_.n_vertices());
    const auto position = [&](Index v) {
      return v < n_vertices ? soup_.positions[v] : cut.points[v - n_vertices];
    };
    const auto is_flat = [&](const Corners& corners) {
      return !measure_facet(corners).is_sound(input_.tolerances.degeneracy);
    };
    std::size_t n_old = 0;
    std::size_t n_new = 0;
    for (std::size_t i = 0; i < tip.faces.size(); ++i) {
      n_old += is_flat(corners_of(soup_, tip.faces[i])) ? 1 : 0;
      for (const auto& [a, b, c] : sides_of(tip, i, n_vertices)) {
        n_new += is_flat({position(a), position(b), position(c)}) ? 1 : 0;
      }
    }
    for (const auto& [a, b, c] : cut.lid) {
      n_new += is_flat({cut.points[a], cut.points[b], cut.points[c]}) ? 1 : 0;
    }
    return n_new > n_old;
  }

  void propose(const Tip& tip, const CutTip& cut) {
    Edits& edits = result_.edits;
    const Index op = edits.begin_operation();
    const auto first_point = static_cast<Index>(soup_.n_vertices() + edits.added_vertices.size());
    for (const Vec3& point : cut.points) edits.added_vertices.push_back({op, point});
    for (std::size_t i = 0; i < tip.faces.size(); ++i) {
      const Index face = tip.faces[i];
      is_used_[face] = 1;
      edits.removed_faces.push_back({op, face});
      for (const Triangle& side : sides_of(tip, i, first_point)) {
        edits.added_faces.push_back({.op = op, .corners = side, .prototype = face});
      }
    }
    for (Triangle t : cut.lid) {
      for (Index& v : t) v += first_point;
      edits.added_faces.push_back({.op = op, .corners = t, .prototype = tip.faces.front()});
    }
  }

  const PassInput& input_;
  const ContactPlaces& contacts_;
  const Soup& soup_;
  /// #faces: 1 for those of tips.
  std::vector<std::uint8_t> is_used_;
  PassResult result_;
};

}  // namespace

PassResult cut_off_tips(const PassInput& input) {
  if (input.limits.groups == Groups::Faces || !(input.limits.max_deviation > 0.0)) return {};
  const ContactPlaces contacts = find_contact_places(input.tracked, input.mesh);
  if (contacts.places.empty()) return {};
  return TipCutter(input, contacts).run();
}

}  // namespace meshalyzer
