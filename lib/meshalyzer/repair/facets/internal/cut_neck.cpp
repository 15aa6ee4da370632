#include "meshalyzer/repair/facets/internal/cut_neck.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/edits/internal/closed_fan.h"
#include "meshalyzer/repair/facets/internal/face_changes.h"
#include "meshalyzer/repair/facets/internal/link_condition.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The vertices round a neck.
using Ring = Triangle;

/// The faces at a ring, on either side of it.
using Sides = std::array<std::vector<Index>, 2>;

/// Joins the faces that have an edge in common with one end on the ring.
///
/// @return Nothing if there are not two sides, or an edge of the ring has not a face on each.
std::optional<Sides> sides_of_ring(const WorkingMesh& mesh, const Ring& ring) {
  std::vector<Index> faces;
  for (const Index v : ring) {
    const auto round = mesh.faces_at(v);
    faces.insert(faces.end(), round.begin(), round.end());
  }
  sort_unique(faces);
  const auto number = [&](Index face) {
    return static_cast<Index>(std::lower_bound(faces.begin(), faces.end(), face) - faces.begin());
  };
  DisjointSets sets(faces.size());
  for (const Index v : ring) {
    for (const Index other : mesh.neighbours(v)) {
      if (has_corner(ring, other)) continue;
      const std::vector<Index> at_edge = mesh.faces_at(v, other);
      for (const Index f : at_edge) sets.unite(number(at_edge.front()), number(f));
    }
  }
  Sides sides;
  for (Index i = 0; i < faces.size(); ++i) {
    const Index set = sets.find(i);
    if (set == sets.find(0)) {
      sides[0].push_back(faces[i]);
    } else {
      if (!sides[1].empty() && set != sets.find(number(sides[1].front()))) return std::nullopt;
      sides[1].push_back(faces[i]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<Index> at_edge = mesh.faces_at(ring[k], ring[(k + 1) % 3]);
    if (at_edge.size() != 2 || sets.find(number(at_edge[0])) == sets.find(number(at_edge[1]))) {
      return std::nullopt;
    }
  }
  return sides;
}

/// Each distance by which a copy is shifted is so many times the one tried before.
constexpr double kNextShift = 4.0;
/// Where the ends of an edge have more neighbours in common, none of the rings is tried, because
/// finding its sides takes a time that grows with the square of their faces.
constexpr std::size_t kMostCommonNeighbours = 16;

/// One way to close the surface on both sides of a cut.
struct NeckClosing {
  /// The vertex in which the ends of the edge are merged, on each side.
  std::array<Index, 2> kept;
  /// The third vertex of the ring, on each side.
  std::array<Index, 2> third;
  /// The new one among these, if any.
  std::optional<MendStep::NewVertex> added = std::nullopt;
};

/// A ring of edges along which the surface may be cut.
class Neck {
 public:
  /// @param edge  An edge shorter than the tolerance.
  Neck(const WorkingMesh& mesh, const MendRules& rules, const std::array<Index, 2>& edge,
       Index third)
      : mesh_(mesh), rules_(rules), edge_(edge), third_(third), ring_{edge[0], edge[1], third} {}

  [[nodiscard]] MendAttempt run() const {
    if (!has_plain_vertices()) return {.outcome = MendOutcome::Topology};
    const bool is_fixed =
        std::any_of(ring_.begin(), ring_.end(), [&](Index v) { return rules_.is_fixed(mesh_, v); });
    if (is_fixed) return {.outcome = MendOutcome::Fixed};
    const std::optional<Sides> sides = sides_of_ring(mesh_, ring_);
    if (!sides) return {.outcome = MendOutcome::Topology};
    MendAttempt best{.outcome = MendOutcome::Topology};
    for (const NeckClosing& closing : closings()) {
      best = better(best, attempt(*sides, closing));
      if (best.is_possible()) break;
    }
    return best;
  }

 private:
  [[nodiscard]] bool has_plain_vertices() const {
    return std::all_of(ring_.begin(), ring_.end(), [&](Index v) {
      return mesh_.faces_at(v).size() <= kMostFacesRoundVertex &&
             look_round(mesh_, v).kind == VertexKind::Plain;
    });
  }

  [[nodiscard]] double distance(Index a, Index b) const {
    return (mesh_.position(b) - mesh_.position(a)).stableNorm();
  }

  [[nodiscard]] std::vector<NeckClosing> closings() const {
    const bool is_near = distance(edge_[0], third_) < rules_.tolerance() &&
                         distance(edge_[1], third_) < rules_.tolerance();
    return is_near ? closings_at_vertices() : closings_with_copy();
  }

  /// Each side keeps another one of three vertices that are near each other.
  [[nodiscard]] std::vector<NeckClosing> closings_at_vertices() const {
    std::vector<NeckClosing> result;
    for (const Index first : ring_) {
      for (const Index second : ring_) {
        if (first != second) result.push_back({{first, second}, {first, second}});
      }
    }
    return result;
  }

  /// Each side keeps one end of the edge, and one gets a copy of the third vertex, which is shifted
  /// in the same direction as its end of the edge is from the other.
  [[nodiscard]] std::vector<NeckClosing> closings_with_copy() const {
    std::vector<NeckClosing> result;
    const double length = distance(edge_[0], edge_[1]);
    if (length == 0.0) return result;
    const auto added = static_cast<Index>(mesh_.n_vertices());
    for (double times = 1.0; times * length < rules_.tolerance(); times *= kNextShift) {
      for (const bool is_first : {true, false}) {
        const Index with_copy = edge_.at(is_first ? 0 : 1);
        const Index other = edge_.at(is_first ? 1 : 0);
        const Vec3 shift = times * (mesh_.position(with_copy) - mesh_.position(other));
        const Vec3 place = mesh_.position(third_) + shift;
        if (place == mesh_.position(third_)) continue;
        const MendStep::NewVertex copy{third_, place};
        result.push_back({{with_copy, other}, {added, third_}, copy});
        result.push_back({{other, with_copy}, {third_, added}, copy});
      }
    }
    return result;
  }

  /// Returns the corners of a face on one side once that is closed.
  [[nodiscard]] Triangle closed(Triangle t, const NeckClosing& closing, std::size_t side) const {
    for (Index& v : t) {
      if (v == third_) {
        v = closing.third.at(side);
      } else if (v == edge_[0] || v == edge_[1]) {
        v = closing.kept.at(side);
      }
    }
    return t;
  }

  [[nodiscard]] MendAttempt attempt(const Sides& sides, const NeckClosing& closing) const {
    MendStep step;
    step.added_vertex = closing.added;
    step.read_vertices.assign(ring_.begin(), ring_.end());
    std::vector<FaceChange> faces;
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<Triangle> stay;
      for (const Index f : sides.at(side)) {
        const Triangle t = closed(mesh_.triangle(f), closing, side);
        faces.push_back(change_of_face(mesh_, step, f, t));
        if (!faces.back().goes) stay.push_back(t);
      }
      if (!closed_fan(stay, closing.kept.at(side)) || !closed_fan(stay, closing.third.at(side))) {
        return {.outcome = MendOutcome::Topology};
      }
    }
    const MendOutcome outcome = check_shapes(mesh_, faces, 0, rules_.tolerance());
    if (outcome != MendOutcome::Possible) return {.outcome = outcome};
    if (!(rules_.tolerance() <= rules_.max_deviation())) return {.outcome = MendOutcome::TooFar};
    write_changes(mesh_, faces, step);
    if (rules_.forbids(step)) return {.outcome = MendOutcome::Intersects};
    return {outcome, std::move(step), rules_.tolerance()};
  }

  const WorkingMesh& mesh_;
  const MendRules& rules_;
  std::array<Index, 2> edge_;
  Index third_;
  Ring ring_;
};

}  // namespace

MendAttempt cut_neck(const WorkingMesh& mesh, const MendRules& rules,
                     const std::array<Index, 2>& edge) {
  const std::vector<Index> beside_first = mesh.neighbours(edge[0]);
  const std::vector<Index> beside_second = mesh.neighbours(edge[1]);
  std::vector<Index> common;
  std::set_intersection(beside_first.begin(), beside_first.end(), beside_second.begin(),
                        beside_second.end(), std::back_inserter(common));
  MendAttempt best{.outcome = MendOutcome::Topology};
  if (common.size() > kMostCommonNeighbours) return best;
  for (const Index v : common) best = better(best, Neck(mesh, rules, edge, v).run());
  return best;
}

}  // namespace meshalyzer
