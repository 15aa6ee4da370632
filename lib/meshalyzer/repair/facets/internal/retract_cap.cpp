#include "meshalyzer/repair/facets/internal/retract_cap.h"

#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/facets/internal/link_condition.h"

#include <algorithm>
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
    const MendOutcome outcome = check();
    if (outcome != MendOutcome::Possible) return {.outcome = outcome};
    write_step();
    return {outcome, std::move(step_), altitude_};
  }

 private:
  [[nodiscard]] SplitFace split(Index face) const {
    const Triangle& t = mesh_.triangle(face);
    SplitFace result{face, kNoIndex, {t, t}};
    result.tip = *std::find_if(t.begin(), t.end(), [&](Index v) { return v != a_ && v != b_; });
    std::replace(result.halves[0].begin(), result.halves[0].end(), b_, apex_);
    std::replace(result.halves[1].begin(), result.halves[1].end(), a_, apex_);
    return result;
  }

  /// This equals splitting the edge at a new vertex and merging that into the apex.
  [[nodiscard]] bool keeps_topology() {
    for (const SplitFace& split : splits_) {
      if (split.tip == apex_ || mesh_.are_joined(split.tip, apex_)) return false;
      step_.read_edges.push_back({split.tip, apex_});
    }
    step_.read_edges.push_back({a_, b_});
    if (splits_.size() == 1) return true;
    step_.read_vertices.push_back(apex_);
    return mesh_.faces_at(apex_).size() <= kMostFacesRoundVertex &&
           look_round(mesh_, apex_).kind == VertexKind::Plain;
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
      for (const Triangle& half : split.halves) {
        const FacetShape now = measure_facet(mesh_.corners(half));
        const bool is_sound = now.is_sound(rules_.tolerance());
        n_thin_after += is_sound ? 0U : 1U;
        const double agreement = now.normal.dot(old.normal);
        if (is_sound ? !(agreement > 0.0) : !mesh_.is_thin(split.face) && agreement < 0.0) {
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
  MendStep step_;
};

}  // namespace

MendAttempt retract_cap(const WorkingMesh& mesh, const MendRules& rules, Index cap,
                        RetractGain gain) {
  return Retraction(mesh, rules, cap, gain).run();
}

}  // namespace meshalyzer
