#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/facets/internal/collapse_edge.h"
#include "meshalyzer/repair/facets/internal/cut_neck.h"
#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/facets/internal/flat_components.h"
#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/retract_cap.h"
#include "meshalyzer/repair/facets/internal/step_contacts.h"
#include "meshalyzer/repair/facets/internal/step_journal.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The means of mending.
enum class Means : std::uint8_t {
  /// Edges are collapsed and caps retracted, whatever else is near: the step that is best by itself
  /// is proposed.
  Usual,
  /// The best step without contact is proposed; besides, necks are cut, and closed components
  /// without a body dropped.
  All,
};

/// The repairs that are permitted.
enum class Effort : std::uint8_t {
  /// Only the thin faces themselves change: short edges are collapsed, and caps are retracted.
  Least,
  /// Edges of any length are collapsed too, and edges between thin faces are flipped.
  Any,
};

/// Mends thin faces one after the other, and then those that become mendable: first with minimal
/// changes as far as that goes, then with any.
///
/// Each step leaves fewer vertices, or as many and fewer thin faces, or as many of both and a
/// shorter edge. Only the cut of a neck may add a vertex, but each raises the Euler characteristic,
/// which no other step lowers, and has an upper bound. So the process ends.
class Mender {
 public:
  Mender(const PassInput& input, std::span<const Index> thin_faces, Means means)
      : input_(input),
        means_(means),
        soup_(input.tracked.soup),
        mesh_(input.tracked.soup, thin_faces, input.tolerances.degeneracy),
        journal_(input.operation_size) {}

  void mend(std::span<const Index> faces) {
    for (const Index f : faces) push(f);
    mend_queue(Effort::Least);
    // The next round continues where this one had to stop.
    if (has_deferred_) return;
    std::vector<Index> left;
    for (const auto& [face, outcome] : failed_) left.push_back(face);
    std::sort(left.begin(), left.end());
    for (const Index f : left) push(f);
    mend_queue(Effort::Any);
  }

  [[nodiscard]] Edits edits() const { return journal_.edits(soup_, mesh_); }

  /// Appends those of the given faces that could not be mended.
  void report(const DefectList& defects, std::vector<Refusal>& refused) const {
    for (const Defect& defect : defects) {
      const Index face = defect.faces.front();
      const auto found = failed_.find(face);
      if (found == failed_.end() || !mesh_.is_thin(face)) continue;
      const bool is_too_far = found->second == MendOutcome::TooFar;
      refused.push_back({.code = defect.code,
                         .face = face,
                         .reason = std::string(mend_reason(found->second)),
                         .rejection = is_too_far ? Rejection::TooFar : Rejection::None});
    }
  }

 private:
  void push(Index face) {
    if (is_queued_.insert(face).second) queue_.push_back(face);
  }

  void mend_queue(Effort effort) {
    while (!queue_.empty() && !input_.wants_to_stop()) {
      const Index f = queue_.front();
      queue_.pop_front();
      is_queued_.erase(f);
      if (mesh_.is_thin(f)) mend(f, effort);
    }
  }

  void push_if_thin(Index face) {
    if (mesh_.is_thin(face)) push(face);
  }

  void mend(Index face, Effort effort) {
    const MendAttempt attempt = best_attempt(face, effort);
    if (!attempt.is_possible()) {
      failed_[face] = attempt.outcome;
      return;
    }
    failed_.erase(face);
    if (!journal_.record(mesh_, attempt.step)) {
      has_deferred_ = true;
      return;
    }
    const std::vector<Index> concerned = vertices_of(attempt.step);
    const std::size_t n_faces = mesh_.n_faces();
    mesh_.make(attempt.step);
    for (const MendStep::NewCorners& change : attempt.step.changed) push_if_thin(change.face);
    for (std::size_t f = n_faces; f < mesh_.n_faces(); ++f) push_if_thin(static_cast<Index>(f));
    for (const Index v : concerned) try_again_at(v);
  }

  [[nodiscard]] MendAttempt best_attempt(Index face, Effort effort) const {
    const Triangle& t = mesh_.triangle(face);
    const FacetShape shape = measure_facet(mesh_.corners(t));
    if (is_short(shape.lengths[shape.shortest_edge()])) return collapse_short_edge(t, shape);
    const MendAttempt retracted = retract_cap(
        mesh_, rules_, face,
        effort == Effort::Least ? RetractGain::FewerThin : RetractGain::FewerThinOrShorter);
    if (retracted.is_possible() || effort == Effort::Least) return retracted;
    MendAttempt best = retracted;
    for (std::size_t k = 0; k < 3; ++k) {
      const MendAttempt collapsed = collapse_edge(mesh_, rules_, {t[k], t[(k + 1) % 3]});
      best = better(best, collapsed);
    }
    return best;
  }

  /// Returns the shortest edge that can be collapsed.
  [[nodiscard]] MendAttempt collapse_short_edge(const Triangle& t, const FacetShape& shape) const {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return shape.lengths[a] < shape.lengths[b];
    });
    MendAttempt best;
    for (const std::size_t k : order) {
      if (!is_short(shape.lengths[k]) || best.is_possible()) break;
      const std::array<Index, 2> edge{t[k], t[(k + 1) % 3]};
      best = better(best, collapse_edge(mesh_, rules_, edge));
      if (best.is_possible() || means_ == Means::Usual) continue;
      best = better(best, cut_neck(mesh_, rules_, edge));
    }
    return best;
  }

  [[nodiscard]] bool is_short(double length) const {
    return length < rules_.tolerance() || length == 0.0;
  }

  /// Lists the vertices of the faces of a step, before and after it.
  [[nodiscard]] std::vector<Index> vertices_of(const MendStep& step) const {
    std::vector<Index> vertices;
    for (const MendStep::NewCorners& change : step.changed) {
      const Triangle& old = mesh_.triangle(change.face);
      vertices.insert(vertices.end(), old.begin(), old.end());
      if (change.corners == kNoTriangle) continue;
      vertices.insert(vertices.end(), change.corners.begin(), change.corners.end());
    }
    sort_unique(vertices);
    return vertices;
  }

  /// Queues the faces at a vertex that could not be mended before, unless the vertex has so many
  /// that it would take too long.
  void try_again_at(Index vertex) {
    if (failed_.empty() || mesh_.faces_at(vertex).size() > kMostFacesRoundVertex) return;
    for (const Index f : mesh_.faces_at(vertex)) {
      if (failed_.contains(f)) push(f);
    }
  }

  const PassInput& input_;
  Means means_;
  const Soup& soup_;
  WorkingMesh mesh_;
  StepContacts contacts_{input_.mesh, mesh_};
  MendRules rules_{input_, means_ == Means::All ? &contacts_ : nullptr};
  StepJournal journal_;
  std::deque<Index> queue_;
  std::unordered_set<Index> is_queued_;
  /// Indexed by face: the reason why it was left when it was last examined.
  std::unordered_map<Index, MendOutcome> failed_;
  bool has_deferred_ = false;
};

/// Appends the operation of dropping some faces.
void drop(const std::vector<Index>& faces, Edits& edits) {
  const Index op = edits.begin_operation();
  for (const Index f : faces) edits.removed_faces.push_back({op, f});
}

/// Appends those of the thin faces of flat components that stay.
void refuse_flat(const DefectList& defects, const FlatComponents& flat,
                 std::vector<Refusal>& refused) {
  std::unordered_set<Index> dropped;
  for (const std::vector<Index>& faces : flat.needless) dropped.insert(faces.begin(), faces.end());
  for (const Defect& defect : defects) {
    const Index f = defect.faces.front();
    if (dropped.contains(f) || !std::binary_search(flat.faces.begin(), flat.faces.end(), f)) {
      continue;
    }
    refused.push_back({defect.code, kNoIndex, f,
                       "all faces of its component are flat, and no other surface is where it is"});
  }
}

void mend_in_complex(const PassInput& input, const DefectList& defects, Means means,
                     PassResult& result) {
  std::vector<Index> thin;
  for (const Defect& defect : defects) thin.push_back(defect.faces.front());
  const ThinComponents counted = count_thin_faces(input.mesh.cut(), thin);
  const FlatComponents flat = find_flat_components(input, thin, counted);
  std::vector<std::vector<Index>> needless = flat.needless;
  std::vector<Index> left_out = flat.faces;
  // Where dropping all of a component was rejected, its faces are mended one by one.
  if (means == Means::All && input.operation_size != OperationSize::Smallest) {
    for (std::vector<Index>& faces : find_needless_layers(input, counted)) {
      left_out.insert(left_out.end(), faces.begin(), faces.end());
      needless.push_back(std::move(faces));
    }
    sort_unique(left_out);
  }
  std::vector<Index> mendable;
  std::set_difference(thin.begin(), thin.end(), left_out.begin(), left_out.end(),
                      std::back_inserter(mendable));
  Mender mender(input, thin, means);
  mender.mend(mendable);
  result.edits = mender.edits();
  result.has_smaller_operations = true;
  for (const std::vector<Index>& faces : needless) drop(faces, result.edits);
  mender.report(defects, result.refused);
  refuse_flat(defects, flat, result.refused);
}

PassResult mend(const PassInput& input, Means means) {
  DefectList in_complex;
  std::vector<Index> rejected;
  for (const Defect& defect : find_thin_facets(input.mesh, input.tolerances)) {
    const Index f = defect.faces.front();
    if (is_in_complex(input.tracked.soup.triangles[f])) {
      in_complex.push_back(defect);
    } else {
      rejected.push_back(f);
    }
  }
  PassResult result;
  if (!in_complex.empty()) mend_in_complex(input, in_complex, means, result);
  for (const Index f : rejected) drop({f}, result.edits);
  return result;
}

}  // namespace

PassResult mend_facets(const PassInput& input) {
  return mend(input, Means::Usual);
}

PassResult mend_remaining_facets(const PassInput& input) {
  return mend(input, Means::All);
}

}  // namespace meshalyzer
