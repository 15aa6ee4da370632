#include "meshalyzer/repair/driver/internal/repair_driver.h"

#include "meshalyzer/repair/driver/internal/log_edits.h"
#include "meshalyzer/repair/edits/apply_edits.h"

#include <algorithm>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// The repair stops after so many rounds, in case passes undo each other's work for ever.
constexpr std::size_t kMaxRounds = 20;
/// A pass is run so many times in a row at most: each run leaves less to do, but a pass that treats
/// one of a long chain of defects at a time must not take forever.
constexpr std::size_t kMaxRuns = 200;
/// Rejected operations are removed from a list so many times before all of it is dropped.
constexpr std::size_t kMaxTrials = 10;

}  // namespace

RepairDriver::RepairDriver(Soup input, const Tolerances& tolerances, RepairLimits limits,
                           FixedVertices fixed)
    : input_(std::move(input)),
      tolerances_(tolerances),
      limits_(std::move(limits)),
      fixed_(std::move(fixed)),
      meter_(input_),
      state_(std::make_unique<RepairState>(track_mesh(input_), tolerances_)) {}

void RepairDriver::run_plan(const std::vector<PlannedPass>& plan, const RepairOptions& options) {
  wants_to_stop_ = options.wants_to_stop;
  for (std::size_t round = 0; round < kMaxRounds; ++round) {
    bool has_changed = false;
    log_.refusals.clear();
    limits_.fixed_vertices = fixed_(state_->tracked(), state_->mesh().cut());
    for (std::size_t i = 0; i < plan.size(); ++i) {
      if (round > 0 && plan[i].repeat == Repeat::Once) continue;
      if (is_to_stop()) return;
      if (options.on_progress) {
        options.on_progress({.pass = plan[i].name,
                             .round = round + 1,
                             .done = static_cast<double>(i) / static_cast<double>(plan.size())});
      }
      has_changed = run(plan[i]) || has_changed;
    }
    if (!has_changed) return;
  }
}

bool RepairDriver::is_to_stop() {
  is_stopped_ = is_stopped_ || (wants_to_stop_ && wants_to_stop_());
  return is_stopped_;
}

void RepairDriver::apply_unchecked(const PlannedPass& pass) {
  const PassResult result = propose(pass, OperationSize::Normal);
  if (result.edits.empty()) return;
  TrackedMesh tracked = apply_edits(state_->tracked(), result.edits);
  const AffectedElements affected =
      find_affected_elements(state_->tracked(), result.edits, SkippedOperations({}), tracked);
  log_edits(std::string(pass.name), pass.code,
            {state_->tracked(), result.edits, {}, tracked, affected}, log_);
  state_ = std::make_unique<RepairState>(std::move(tracked), tolerances_);
}

PassResult RepairDriver::propose(const PlannedPass& pass, OperationSize size) const {
  return pass.run({state_->tracked(), state_->mesh(), tolerances_, limits_, size});
}

bool RepairDriver::run(const PlannedPass& pass) {
  bool has_changed = false;
  std::set<Signature> rejected;
  const std::size_t max_runs = pass.repeat == Repeat::Once ? 1 : kMaxRuns;
  OperationSize size = OperationSize::Normal;
  for (std::size_t i = 0; i < max_runs && !is_to_stop(); ++i) {
    const PassResult result = propose(pass, size);
    if (!result.edits.empty() && apply_accepted(pass, result.edits, rejected)) {
      has_changed = true;
    } else if (!rejected.empty() && size != OperationSize::Smallest) {
      // One bad step may have caused the rejection of all steps of its operation.
      size = OperationSize::Smallest;
    } else {
      log_refusals(pass, result.refused);
      return has_changed;
    }
  }
  return has_changed;
}

bool RepairDriver::apply_accepted(const PlannedPass& pass, const Edits& edits,
                                  std::set<Signature>& rejected) {
  const std::vector<Signature> signature = signatures(edits);
  std::vector<std::uint8_t> skipped(edits.n_operations, 0);
  for (std::size_t op = 0; op < skipped.size(); ++op) {
    skipped[op] = rejected.contains(signature[op]);
  }
  const AcceptanceRules rules{input_, meter_, limits_.max_deviation, pass.may_create};
  for (std::size_t trial = 0; trial < kMaxTrials && !is_to_stop(); ++trial) {
    if (std::all_of(skipped.begin(), skipped.end(), [](auto s) { return s != 0; })) return false;
    TrackedMesh tracked = apply_edits(state_->tracked(), edits, skipped);
    const AffectedElements affected =
        find_affected_elements(state_->tracked(), edits, SkippedOperations(skipped), tracked);
    auto after = std::make_unique<RepairState>(std::move(tracked), tolerances_, *state_, affected);
    const Acceptance acceptance =
        check_acceptance(*state_, *after, affected, skipped.size(), rules);
    if (acceptance.all_accepted()) {
      log_edits(std::string(pass.name), pass.code,
                {state_->tracked(), edits, skipped, after->tracked(), affected}, log_);
      state_ = std::move(after);
      deviation_ = acceptance.deviation;
      include_patches(edits);
      return true;
    }
    for (std::size_t op = 0; op < skipped.size(); ++op) {
      if (skipped[op] != 0 || acceptance.rejections[op] == Rejection::None) continue;
      skipped[op] = 1;
      rejected.insert(signature[op]);
      log_rejection(pass, signature[op], acceptance.rejections[op]);
    }
  }
  return false;
}

void RepairDriver::include_patches(const Edits& edits) {
  const bool has_patches = std::any_of(edits.added_faces.begin(), edits.added_faces.end(),
                                       [](const auto& face) { return face.fills_hole; });
  if (has_patches) meter_.include_patches(state_->tracked());
}

std::vector<RepairDriver::Signature> RepairDriver::signatures(const Edits& edits) const {
  std::vector<Signature> signatures(edits.n_operations);
  const TrackedMesh& tracked = state_->tracked();
  const auto add_face = [&](Index op, Index face) {
    signatures[op].push_back(tracked.face_keys[face]);
  };
  for (const auto& edit : edits.removed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.changed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.added_faces) add_face(edit.op, edit.like);
  for (const auto& edit : edits.moved_vertices) {
    // Keys of vertices, told from those of faces by what stands before them.
    signatures[edit.op].push_back(kNoIndex);
    signatures[edit.op].push_back(tracked.vertex_keys[edit.vertex]);
  }
  return signatures;
}

void RepairDriver::log_refusals(const PlannedPass& pass, const std::vector<Refusal>& refused) {
  const TrackedMesh& tracked = state_->tracked();
  for (const Refusal& refusal : refused) {
    LoggedRefusal& logged = log_.refusals.emplace_back();
    logged.pass = pass.name;
    logged.code = refusal.code;
    logged.vertex = refusal.vertex == kNoIndex ? kNoIndex : tracked.vertex_keys[refusal.vertex];
    logged.face = refusal.face == kNoIndex ? kNoIndex : tracked.face_keys[refusal.face];
    logged.reason = refusal.reason;
  }
}

void RepairDriver::log_rejection(const PlannedPass& pass, const Signature& signature,
                                 Rejection rejection) {
  LoggedRefusal& logged = log_.refusals.emplace_back();
  logged.pass = pass.name;
  logged.code = pass.code;
  if (signature.size() > 1 && signature.front() == kNoIndex) {
    logged.vertex = signature[1];
  } else if (!signature.empty()) {
    logged.face = signature.front();
  }
  logged.reason = rejection_reason(rejection);
}

}  // namespace meshalyzer
