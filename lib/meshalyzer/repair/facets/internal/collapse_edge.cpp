#include "meshalyzer/repair/facets/internal/collapse_edge.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/facets/internal/face_changes.h"
#include "meshalyzer/repair/facets/internal/link_condition.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Beyond this number of faces, surfaces are compared by the movement of the vertex alone.
constexpr std::size_t kMostFacesCompared = 64;

/// A merge of the ends of an edge.
struct Merge {
  Index gone;
  Index kept;
  /// The new position of `kept`, if it moves.
  std::optional<Vec3> middle = std::nullopt;
};

/// A merge, and the faces round the edge before and after it.
class MergeCandidate {
 public:
  MergeCandidate(const WorkingMesh& mesh, const Merge& merge, const std::vector<FinTip>& fins)
      : mesh_(mesh), merge_(merge), fins_(fins) {
    if (merge.middle) move_.moved = {merge.kept, *merge.middle};
    for (const FinTip& fin : fins) {
      const auto faces = mesh.faces_at(fin.tip);
      fin_faces_.insert(fin_faces_.end(), faces.begin(), faces.end());
    }
    sort_unique(fin_faces_);
    for (const Index f : mesh.faces_at(merge.gone)) {
      if (!is_of_fin(f)) add(f, with_corner(mesh.triangle(f), merge.gone, merge.kept));
    }
    if (!merge.middle) return;
    for (const Index f : mesh.faces_at(merge.kept)) {
      if (!has_corner(mesh.triangle(f), merge.gone) && !is_of_fin(f)) add(f, mesh.triangle(f));
    }
  }

  /// Tells whether the faces round the edge stay sound.
  [[nodiscard]] MendOutcome check(double tolerance) const {
    const auto n_thin_fins = static_cast<std::size_t>(std::count_if(
        fin_faces_.begin(), fin_faces_.end(), [&](Index f) { return mesh_.is_thin(f); }));
    return check_shapes(mesh_, faces_, n_thin_fins, tolerance);
  }

  /// Returns the approximate distance of the new surface from the old one; never less than 0 or
  /// more than the movement of the vertices and the height of the fins.
  [[nodiscard]] double deviation() const {
    return std::max(deviation_beside_fins(), height_of_fins());
  }

  [[nodiscard]] MendStep step(MendStep begun) const {
    write_changes(mesh_, faces_, begun);
    for (const Index f : fin_faces_) begun.changed.push_back({f, kNoTriangle});
    begun.moved = move_.moved;
    return begun;
  }

 private:
  void add(Index number, const Triangle& corners) {
    faces_.push_back(change_of_face(mesh_, move_, number, corners));
  }

  [[nodiscard]] bool is_of_fin(Index face) const {
    return std::binary_search(fin_faces_.begin(), fin_faces_.end(), face);
  }

  /// Returns the largest distance of the tip of a fin from the faces that stay.
  [[nodiscard]] double height_of_fins() const {
    double largest = 0.0;
    for (const FinTip& fin : fins_) {
      const Vec3& tip = mesh_.position(fin.tip);
      double nearest = std::numeric_limits<double>::infinity();
      for (const FaceChange& face : faces_) {
        if (face.goes) continue;
        nearest = std::min(nearest, closest_on_triangle(face.after, tip).distance);
      }
      largest = std::max(largest, nearest);
    }
    return largest;
  }

  [[nodiscard]] double deviation_beside_fins() const {
    const double moved = largest_move();
    if (faces_.size() > kMostFacesCompared) return moved;
    double largest = to_new_faces(mesh_.position(merge_.gone));
    if (merge_.middle) largest = std::max(largest, to_new_faces(mesh_.position(merge_.kept)));
    for (const FaceChange& face : faces_) {
      if (face.goes) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& from = face.after[k];
        const Vec3& to = face.after[(k + 1) % 3];
        for (const double share : {0.25, 0.5, 0.75}) {
          largest = std::max(largest, to_old_faces(from * (1.0 - share) + to * share));
        }
      }
    }
    return std::min(largest, moved);
  }

  [[nodiscard]] double largest_move() const {
    const Vec3& gone = mesh_.position(merge_.gone);
    const Vec3& kept = mesh_.position(merge_.kept);
    if (!merge_.middle) return (kept - gone).stableNorm();
    return std::max((*merge_.middle - gone).stableNorm(), (*merge_.middle - kept).stableNorm());
  }

  [[nodiscard]] double to_new_faces(const Vec3& point) const {
    double nearest = largest_move();
    for (const FaceChange& face : faces_) {
      if (face.goes) continue;
      nearest = std::min(nearest, closest_on_triangle(face.after, point).distance);
    }
    return nearest;
  }

  [[nodiscard]] double to_old_faces(const Vec3& point) const {
    double nearest = largest_move();
    for (const FaceChange& face : faces_) {
      nearest = std::min(nearest, closest_on_triangle(face.before, point).distance);
    }
    return nearest;
  }

  const WorkingMesh& mesh_;
  Merge merge_;
  /// A step that has the movement of the vertex, and nothing else yet.
  MendStep move_;
  const std::vector<FinTip>& fins_;
  /// The faces at the tips of fins, all of which go, ascending.
  std::vector<Index> fin_faces_;
  /// The other faces.
  std::vector<FaceChange> faces_;
};

/// Tries the ways to merge the ends of one edge.
class EdgeCollapse {
 public:
  EdgeCollapse(const WorkingMesh& mesh, const MendRules& rules, const std::array<Index, 2>& ends)
      : mesh_(mesh),
        rules_(rules),
        ends_{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])},
        fins_(fin_tips_at(mesh, ends_[0], ends_[1], begun_)) {
    for (std::size_t k = 0; k < 2; ++k) {
      is_crowded_[k] = mesh.faces_at(ends_[k]).size() > kMostFacesRoundVertex;
      is_fixed_[k] = rules.is_fixed(mesh, ends_[k]);
    }
  }

  [[nodiscard]] MendAttempt run() {
    if (is_fixed_[0] && is_fixed_[1]) return {.outcome = MendOutcome::Fixed};
    if (has_fixed_tip()) return {.outcome = MendOutcome::Fixed};
    if (!is_permitted()) return {.outcome = MendOutcome::Topology};
    const MendAttempt keep_first = attempt(1, 0);
    const MendAttempt keep_second = attempt(0, 1);
    if (keep_first.is_possible() && keep_second.is_possible()) {
      if (is_between(1) != is_between(0)) return is_between(0) ? keep_first : keep_second;
    }
    const MendAttempt& at_end = better(keep_first, keep_second);
    if (at_end.is_possible() || is_fixed_[0] || is_fixed_[1]) return at_end;
    return better(at_end, attempt_middle());
  }

 private:
  [[nodiscard]] bool is_between(std::size_t end) const {
    return rules_.is_between_groups(mesh_, ends_[end]);
  }

  [[nodiscard]] bool has_fixed_tip() const {
    return std::any_of(fins_.begin(), fins_.end(),
                       [&](const FinTip& fin) { return rules_.is_fixed(mesh_, fin.tip); });
  }

  /// Merging either end into the other has the same effect on the topology.
  [[nodiscard]] bool is_permitted() {
    for (const std::size_t gone : {std::size_t{1}, std::size_t{0}}) {
      MendStep step = begun_;
      if (is_crowded_[gone] || !may_merge(mesh_, {ends_[gone], ends_[1 - gone]}, fins_, step)) {
        continue;
      }
      begun_ = std::move(step);
      return true;
    }
    return false;
  }

  [[nodiscard]] MendAttempt attempt(std::size_t gone, std::size_t kept) const {
    if (is_fixed_[gone]) return {.outcome = MendOutcome::Fixed};
    if (is_crowded_[gone]) return {};
    return checked({.gone = ends_[gone], .kept = ends_[kept]});
  }

  /// Returns the merge at the midpoint, in which the lower vertex stays.
  [[nodiscard]] MendAttempt attempt_middle() const {
    const Vec3& a = mesh_.position(ends_[0]);
    const Vec3& b = mesh_.position(ends_[1]);
    const double length = (b - a).stableNorm();
    if (!(length < rules_.tolerance()) || is_crowded_[0] || is_crowded_[1]) return {};
    return checked({.gone = ends_[1], .kept = ends_[0], .middle = a / 2 + b / 2});
  }

  [[nodiscard]] MendAttempt checked(const Merge& merge) const {
    const MergeCandidate candidate(mesh_, merge, fins_);
    const MendOutcome outcome = candidate.check(rules_.tolerance());
    if (outcome != MendOutcome::Possible) return {.outcome = outcome};
    const double deviation = candidate.deviation();
    if (!(deviation <= rules_.max_deviation())) return {.outcome = MendOutcome::TooFar};
    MendStep step = candidate.step(begun_);
    if (rules_.forbids(step)) return {.outcome = MendOutcome::Intersects};
    return {outcome, std::move(step), deviation};
  }

  const WorkingMesh& mesh_;
  const MendRules& rules_;
  std::array<Index, 2> ends_;
  /// The facts that the permission relies on.
  MendStep begun_;
  std::vector<FinTip> fins_;
  std::array<bool, 2> is_crowded_{};
  std::array<bool, 2> is_fixed_{};
};

}  // namespace

MendAttempt collapse_edge(const WorkingMesh& mesh, const MendRules& rules,
                          const std::array<Index, 2>& ends) {
  return EdgeCollapse(mesh, rules, ends).run();
}

}  // namespace meshalyzer
