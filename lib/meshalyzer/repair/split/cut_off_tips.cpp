#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/holes/internal/fill_loop.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/split/internal/contact_places.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
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

/// The faces round a vertex, cut off near it.
struct Tip {
  Index vertex = kNoIndex;
  /// By index into the soup.
  std::vector<Index> faces;
  /// What is left of the faces, each with the face that it is a part of.
  std::vector<std::pair<Triangle, Index>> sides;
  /// By number: the point on the edge to each vertex around.
  std::map<Index, Index> point_at;
};

/// Cuts one vertex at each place off.
class TipCutter {
 public:
  TipCutter(const PassInput& input, const ContactPlaces& contacts)
      : input_(input),
        contacts_(contacts),
        soup_(input.mesh.soup()),
        is_used_(soup_.n_faces(), 0),
        trimmed_(bare(soup_)) {}

  /// @param rank   The number of the unit that is cut off at each place, from the last.
  /// @param share  The share of the longest possible tip.
  PassResult run(std::size_t rank, double share) {
    for (const ContactPlace& place : contacts_.places) {
      if (rank >= place.units.size()) continue;
      const std::vector<Index>& unit = place.units[place.units.size() - 1 - rank];
      if (unit.size() == 1) cut_off(unit.front(), share);
    }
    if (tips_.empty()) return {};
    close();
    return std::move(result_);
  }

 private:
  [[nodiscard]] static Soup bare(const Soup& soup) {
    Soup result;
    result.positions = soup.positions;
    result.triangles = soup.triangles;
    return result;
  }

  void cut_off(Index vertex, double share) {
    const auto faces = contacts_.incident.faces(contacts_.incident.entry_of(vertex));
    const bool is_taken = std::any_of(faces.begin(), faces.end(), [&](Index face) {
      return is_used_[face] != 0 || input_.limits.has_fixed_corner(input_.tracked, face);
    });
    if (is_taken || faces.size() > kMostFacesAtTip) return;
    Tip tip{.vertex = vertex, .faces = {faces.begin(), faces.end()}, .sides = {}, .point_at = {}};
    const auto n_points = trimmed_.positions.size();
    for (const Index face : faces) {
      Triangle t = soup_.triangles[face];
      std::rotate(t.begin(), std::find(t.begin(), t.end(), vertex), t.end());
      const auto a = point_on_edge(tip, t[1], share);
      const auto b = point_on_edge(tip, t[2], share);
      if (!a || !b) return trimmed_.positions.resize(n_points);
      tip.sides.emplace_back(Triangle{t[1], t[2], *b}, face);
      tip.sides.emplace_back(Triangle{t[1], *b, *a}, face);
    }
    // Round the vertex of a closed fan there are as many vertices as faces.
    if (tip.point_at.size() != faces.size()) return trimmed_.positions.resize(n_points);
    for (const Index face : faces) {
      is_used_[face] = 1;
      trimmed_.triangles[face] = kNoTriangle;
    }
    for (const auto& [side, face] : tip.sides) trimmed_.triangles.push_back(side);
    tips_.push_back(std::move(tip));
  }

  /// Returns the number of the point where an edge is cut off; nothing if the edge is too short.
  std::optional<Index> point_on_edge(Tip& tip, Index other, double share) {
    const auto found = tip.point_at.find(other);
    if (found != tip.point_at.end()) return found->second;
    const Vec3& from = soup_.positions[tip.vertex];
    const Vec3 edge = soup_.positions[other] - from;
    const double of_deviation = kShareOfDeviation * input_.limits.max_deviation / edge.stableNorm();
    const Vec3 point = from + share * std::min(kLargestShareOfEdge, of_deviation) * edge;
    if (point == from || point == soup_.positions[other]) return std::nullopt;
    const auto number = static_cast<Index>(trimmed_.positions.size());
    trimmed_.positions.push_back(point);
    tip.point_at.emplace(other, number);
    return number;
  }

  /// Closes the tips that were cut off, and proposes those that can be closed.
  void close() {
    const PreparedMesh mesh(trimmed_);
    const HoleLoops found = find_hole_loops(mesh);
    const ExistingEdges existing(mesh, found.loops);
    const FillTask task{.mesh = mesh,
                        .existing = existing,
                        .degeneracy = input_.tolerances.degeneracy,
                        .shape = FillShape::Linear,
                        .wants_to_stop = input_.wants_to_stop};
    std::map<Index, const HoleLoop*> loop_at;
    for (const HoleLoop& loop : found.loops) loop_at[loop.vertices.front()] = &loop;
    for (const Tip& tip : tips_) {
      for (const auto& [other, point] : tip.point_at) {
        const auto loop = loop_at.find(point);
        if (loop == loop_at.end() || loop->second->size() != tip.faces.size()) continue;
        const Filling lid = fill_loop(task, {.loop = *loop->second, .bridges = {}});
        if (lid.patch && !makes_flat_faces(tip, *lid.patch)) propose(tip, *lid.patch);
      }
    }
  }

  /// Tells whether more of the new faces than of those that they replace are flat.
  [[nodiscard]] bool makes_flat_faces(const Tip& tip, const Patch& lid) const {
    const auto is_flat = [&](const Corners& corners) {
      return !measure_facet(corners).is_sound(input_.tolerances.degeneracy);
    };
    const auto n_old = std::count_if(tip.faces.begin(), tip.faces.end(),
                                     [&](Index face) { return is_flat(corners_of(soup_, face)); });
    const auto n_sides = std::count_if(tip.sides.begin(), tip.sides.end(), [&](const auto& side) {
      return is_flat(corners_of(trimmed_, {}, side.first));
    });
    const auto n_of_lid =
        std::count_if(lid.triangles.begin(), lid.triangles.end(),
                      [&](const Triangle& t) { return is_flat(corners_of(trimmed_, lid, t)); });
    return n_sides + n_of_lid > n_old;
  }

  void propose(const Tip& tip, const Patch& lid) {
    Edits& edits = result_.edits;
    const Index op = edits.begin_operation();
    std::map<Index, Index> number_of;
    const auto add = [&](Triangle t, Index prototype) {
      for (Index& v : t) {
        if (v < soup_.n_vertices()) continue;
        const auto next = static_cast<Index>(soup_.n_vertices() + edits.added_vertices.size());
        const auto [entry, is_new] = number_of.emplace(v, next);
        if (is_new) edits.added_vertices.push_back({op, position_of(trimmed_, lid, v)});
        v = entry->second;
      }
      edits.added_faces.push_back({.op = op, .corners = t, .prototype = prototype});
    };
    for (const Index face : tip.faces) edits.removed_faces.push_back({op, face});
    for (const auto& [side, face] : tip.sides) add(side, face);
    for (const Triangle& t : lid.triangles) add(t, tip.faces.front());
  }

  const PassInput& input_;
  const ContactPlaces& contacts_;
  const Soup& soup_;
  /// #faces: 1 for those of tips.
  std::vector<std::uint8_t> is_used_;
  std::vector<Tip> tips_;
  /// The mesh without the tips.
  Soup trimmed_;
  PassResult result_;
};

}  // namespace

PassResult cut_off_tips(const PassInput& input) {
  if (input.limits.groups == Groups::Faces || !(input.limits.max_deviation > 0.0)) return {};
  const ContactPlaces contacts = find_contact_places(input.mesh);
  if (contacts.places.empty()) return {};
  for (std::size_t rank = 0; rank < kMostUnits; ++rank) {
    for (double share = kShortestShare; share <= 1.0; share *= kLongerBy) {
      PassResult result = TipCutter(input, contacts).run(rank, share);
      if (!result.edits.empty()) return result;
    }
  }
  return {};
}

}  // namespace meshalyzer
