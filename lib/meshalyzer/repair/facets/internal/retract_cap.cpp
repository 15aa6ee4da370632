#include "meshalyzer/repair/facets/internal/retract_cap.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/facets/internal/link_condition.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// A face beyond the longest edge, and the two faces that it is split into.
struct SplitFace {
  Index face;
  /// The corner opposite to the edge.
  Index tip;
  std::array<Triangle, 2> halves;
};

class Retraction {
 public:
  Retraction(const WorkingMesh& mesh, const MendRules& rules, Index cap, RetractGain gain)
      : mesh_(mesh), rules_(rules), cap_(cap), gain_(gain) {
    const Triangle& t = mesh.triangle(cap);
    const FacetShape shape = measure_facet(mesh.corners(t));
    const std::size_t longest = shape.longest_edge();
    a_ = t[longest];
    b_ = t[(longest + 1) % 3];
    apex_ = t[(longest + 2) % 3];
    length_ = shape.lengths[longest];
    altitude_ = shape.altitude;
    for (const Index f : mesh.faces_at(a_, b_)) {
      if (f != cap) splits_.push_back(split(f));
    }
  }

  [[nodiscard]] MendAttempt run() {
    if (!(altitude_ <= rules_.max_deviation())) return {.outcome = MendOutcome::TooFar};
    if (!keeps_topology()) return {.outcome = MendOutcome::Topology};
    if (!keeps_group_borders()) return {.outcome = MendOutcome::GroupBorder};
    if (has_fixed_end_that_goes()) return {.outcome = MendOutcome::Fixed};
    const MendOutcome outcome = check();
    if (outcome != MendOutcome::Possible) return {.outcome = outcome};
    const double deviation = std::max(altitude_, height_of_ends_that_go());
    if (!(deviation <= rules_.max_deviation())) return {.outcome = MendOutcome::TooFar};
    write_step();
    if (rules_.forbids(step_)) return {.outcome = MendOutcome::Intersects};
    return {outcome, std::move(step_), deviation};
  }

 private:
  [[nodiscard]] SplitFace split(Index face) const {
    const Triangle& t = mesh_.triangle(face);
    SplitFace result{face, kNoIndex, {t, t}};
    result.tip = third_corner(t, a_, b_);
    std::replace(result.halves[0].begin(), result.halves[0].end(), b_, apex_);
    std::replace(result.halves[1].begin(), result.halves[1].end(), a_, apex_);
    return result;
  }

  /// This equals splitting the edge at a new vertex and merging that into the apex.
  [[nodiscard]] bool keeps_topology() {
    for (const SplitFace& split : splits_) {
      if (split.tip == apex_) return false;
      if (mesh_.are_joined(split.tip, apex_) && !look_for_ends_that_go(split.tip)) return false;
      step_.read_edges.push_back({split.tip, apex_});
    }
    step_.read_edges.push_back({a_, b_});
    if (splits_.size() == 1) return true;
    step_.read_vertices.push_back(apex_);
    return mesh_.faces_at(apex_).size() <= kMostFacesRoundVertex &&
           look_round(mesh_, apex_).kind == VertexKind::Plain;
  }

  /// Finds the ends of the edge that have three faces: the third joins apex and tip already.
  ///
  /// @return Whether apex and tip have no more than one edge in common without these.
  [[nodiscard]] bool look_for_ends_that_go(Index tip) {
    if (splits_.size() != 1 || mesh_.faces_at(tip, apex_).size() != 2) return false;
    const std::array<Index, 2> ends{a_, b_};
    for (std::size_t k = 0; k < 2; ++k) {
      if (mesh_.faces_at(ends[k]).size() != 3 ||
          look_round(mesh_, ends[k]).kind != VertexKind::Plain) {
        continue;
      }
      step_.read_vertices.push_back(ends[k]);
      goes_[k] = true;
    }
    return goes_[0] || goes_[1];
  }

  [[nodiscard]] bool has_fixed_end_that_goes() const {
    return (goes_[0] && rules_.is_fixed(mesh_, a_)) || (goes_[1] && rules_.is_fixed(mesh_, b_));
  }

  /// Returns the distance of an end that goes from the half that stays; 0 if none does.
  [[nodiscard]] double height_of_ends_that_go() const {
    if (goes_[0] == goes_[1]) return 0.0;
    const Corners half = mesh_.corners(splits_[0].halves[goes_[0] ? 1 : 0]);
    return closest_on_triangle(half, mesh_.position(goes_[0] ? a_ : b_)).distance;
  }

  /// Tells whether the step bends no common border of groups that are faces of a body.
  [[nodiscard]] bool keeps_group_borders() const {
    const Index group = rules_.group(mesh_, cap_);
    return rules_.groups() == Groups::Names ||
           std::all_of(splits_.begin(), splits_.end(), [&](const SplitFace& split) {
             return rules_.group(mesh_, split.face) == group;
           });
  }

  [[nodiscard]] MendOutcome check() const {
    std::size_t n_thin_before = 1;
    std::size_t n_thin_after = 0;
    for (const SplitFace& split : splits_) {
      n_thin_before += mesh_.is_thin(split.face) ? 1U : 0U;
      const FacetShape old = measure_facet(mesh_.corners(mesh_.triangle(split.face)));
      for (std::size_t k = 0; k < 2; ++k) {
        if (goes_[k]) continue;
        const FacetShape now = measure_facet(mesh_.corners(split.halves[k]));
        const bool is_sound = now.is_sound(rules_.tolerance());
        n_thin_after += is_sound ? 0U : 1U;
        const double agreement = now.normal.dot(old.normal);
        if (is_sound ? !(agreement > 0.0) : agreement < 0.0) {
          return MendOutcome::TurnsOver;
        }
      }
    }
    const bool gains = n_thin_after < n_thin_before ||
                       (gain_ == RetractGain::FewerThinOrShorter && n_thin_after == n_thin_before &&
                        splits_.size() == 1 && is_shorter());
    return gains ? MendOutcome::Possible : MendOutcome::MakesThin;
  }

  [[nodiscard]] bool is_shorter() const {
    return (mesh_.position(splits_[0].tip) - mesh_.position(apex_)).stableNorm() < length_;
  }

  /// The cap's record becomes one of the new faces if it is of their group.
  void write_step() {
    if (goes_[0] || goes_[1]) return write_step_without_ends();
    bool is_cap_free = true;
    const Index group = rules_.group(mesh_, cap_);
    for (const SplitFace& split : splits_) {
      step_.changed.push_back({split.face, split.halves[0]});
      if (is_cap_free && rules_.group(mesh_, split.face) == group) {
        step_.changed.push_back({cap_, aligned(split.halves[1])});
        is_cap_free = false;
      } else {
        step_.added.push_back({split.halves[1], split.face});
      }
    }
    if (is_cap_free) step_.changed.push_back({cap_, kNoTriangle});
  }

  void write_step_without_ends() {
    const SplitFace& split = splits_[0];
    if (!goes_[0] || !goes_[1]) {
      step_.changed.push_back({split.face, split.halves[goes_[0] ? 1 : 0]});
    }
    std::vector<Index> faces;
    for (std::size_t k = 0; k < 2; ++k) {
      if (!goes_[k]) continue;
      const auto round = mesh_.faces_at(k == 0 ? a_ : b_);
      faces.insert(faces.end(), round.begin(), round.end());
    }
    sort_unique(faces);
    for (const Index f : faces) {
      if (f != split.face || (goes_[0] && goes_[1])) step_.changed.push_back({f, kNoTriangle});
    }
  }

  /// Begins with the corner that leaves most of the cap's corners in place.
  [[nodiscard]] Triangle aligned(Triangle t) const {
    const Triangle& old = mesh_.triangle(cap_);
    const auto place = std::find(old.begin(), old.end(), apex_) - old.begin();
    while (t[static_cast<std::size_t>(place)] != apex_) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
    }
    return t;
  }

  const WorkingMesh& mesh_;
  const MendRules& rules_;
  Index cap_;
  RetractGain gain_;
  Index a_ = kNoIndex;
  Index b_ = kNoIndex;
  Index apex_ = kNoIndex;
  double length_ = 0.0;
  double altitude_ = 0.0;
  std::vector<SplitFace> splits_;
  /// Whether each end of the edge goes.
  std::array<bool, 2> goes_{};
  MendStep step_;
};

}  // namespace

MendAttempt retract_cap(const WorkingMesh& mesh, const MendRules& rules, Index cap,
                        RetractGain gain) {
  return Retraction(mesh, rules, cap, gain).run();
}

}  // namespace meshalyzer
