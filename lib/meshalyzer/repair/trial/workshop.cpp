#include "meshalyzer/repair/trial/workshop.h"

#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/trial/log_edits.h"

#include <algorithm>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// So often passes may undo each other's work before the repair is called done.
constexpr std::size_t kMaxRounds = 20;
/// So often a pass is asked in a row: each time it comes nearer to its end, but one that deals with
/// one of a long chain of defects at a time must not take forever.
constexpr std::size_t kMaxAsked = 200;
/// So often harmful operations are taken out of a list before all of it is dropped.
constexpr std::size_t kMaxTrials = 10;

}  // namespace

Workshop::Workshop(Soup input, const Tolerances& tolerances, RepairLimits limits,
                   FixedVertices fixed)
    : input_(std::move(input)),
      tolerances_(tolerances),
      limits_(std::move(limits)),
      fixed_(std::move(fixed)),
      meter_(input_),
      state_(std::make_unique<RepairState>(make_draft(input_), tolerances_)) {}

void Workshop::work_off(const std::vector<PlannedPass>& plan, const PhaseListener& on_phase) {
  for (std::size_t round = 0; round < kMaxRounds; ++round) {
    bool has_changed = false;
    log_.refusals.clear();
    limits_.fixed_vertices = fixed_(state_->draft(), state_->mesh().cut());
    for (const PlannedPass& pass : plan) {
      if (round > 0 && pass.repeat == Repeat::Once) continue;
      if (on_phase) on_phase(pass.name);
      has_changed = run(pass) || has_changed;
    }
    if (!has_changed) return;
  }
}

void Workshop::obey(const PlannedPass& pass) {
  const PassResult result = ask(pass, limits_.most_steps);
  if (result.edits.empty()) return;
  Draft draft = apply_edits(state_->draft(), result.edits);
  const Touched touched = find_touched(state_->draft(), result.edits, SkippedOperations({}), draft);
  log_edits(std::string(pass.name), pass.code, {state_->draft(), result.edits, {}, draft, touched},
            log_);
  state_ = std::make_unique<RepairState>(std::move(draft), tolerances_);
}

PassResult Workshop::ask(const PlannedPass& pass, std::size_t most_steps) const {
  RepairLimits limits = limits_;
  limits.most_steps = most_steps;
  return pass.run({state_->draft(), state_->mesh(), tolerances_, limits});
}

bool Workshop::run(const PlannedPass& pass) {
  bool has_changed = false;
  std::set<Signature> harmful;
  const std::size_t max_asked = pass.repeat == Repeat::Once ? 1 : kMaxAsked;
  std::size_t most_steps = limits_.most_steps;
  for (std::size_t i = 0; i < max_asked; ++i) {
    const PassResult result = ask(pass, most_steps);
    if (!result.edits.empty() && try_edits(pass, result.edits, harmful)) {
      has_changed = true;
    } else if (!harmful.empty() && most_steps > 1) {
      // One bad step may have cost all those that were made with it.
      most_steps = 1;
    } else {
      log_refusals(pass, result.refused);
      return has_changed;
    }
  }
  return has_changed;
}

bool Workshop::try_edits(const PlannedPass& pass, const Edits& edits,
                         std::set<Signature>& harmful) {
  const std::vector<Signature> signature = signatures(edits);
  std::vector<std::uint8_t> skipped(edits.n_operations, 0);
  for (std::size_t op = 0; op < skipped.size(); ++op) skipped[op] = harmful.contains(signature[op]);
  const TrialRules rules{input_, meter_, limits_.max_deviation, pass.may_make};
  for (std::size_t trial = 0; trial < kMaxTrials; ++trial) {
    if (std::all_of(skipped.begin(), skipped.end(), [](auto s) { return s != 0; })) return false;
    Draft draft = apply_edits(state_->draft(), edits, skipped);
    const Touched touched = find_touched(state_->draft(), edits, SkippedOperations(skipped), draft);
    auto after = std::make_unique<RepairState>(std::move(draft), tolerances_, *state_, touched);
    const Verdict verdict = judge_trial(*state_, *after, touched, skipped.size(), rules);
    if (verdict.is_harmless()) {
      log_edits(std::string(pass.name), pass.code,
                {state_->draft(), edits, skipped, after->draft(), touched}, log_);
      state_ = std::move(after);
      deviation_ = verdict.deviation;
      lay_patches(edits);
      return true;
    }
    for (std::size_t op = 0; op < skipped.size(); ++op) {
      if (skipped[op] != 0 || verdict.harms[op] == Harm::None) continue;
      skipped[op] = 1;
      harmful.insert(signature[op]);
      log_harm(pass, signature[op], verdict.harms[op]);
    }
  }
  return false;
}

void Workshop::lay_patches(const Edits& edits) {
  const bool has_patches = std::any_of(edits.added_faces.begin(), edits.added_faces.end(),
                                       [](const auto& face) { return face.is_patch; });
  if (has_patches) meter_.lay_patches(state_->draft());
}

std::vector<Workshop::Signature> Workshop::signatures(const Edits& edits) const {
  std::vector<Signature> signatures(edits.n_operations);
  const Draft& draft = state_->draft();
  const auto add_face = [&](Index op, Index face) {
    signatures[op].push_back(draft.face_keys[face]);
  };
  for (const auto& edit : edits.removed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.changed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.added_faces) add_face(edit.op, edit.like);
  for (const auto& edit : edits.moved_vertices) {
    // Keys of vertices, told from those of faces by what stands before them.
    signatures[edit.op].push_back(kNoIndex);
    signatures[edit.op].push_back(draft.vertex_keys[edit.vertex]);
  }
  return signatures;
}

void Workshop::log_refusals(const PlannedPass& pass, const std::vector<Refusal>& refused) {
  const Draft& draft = state_->draft();
  for (const Refusal& refusal : refused) {
    LoggedRefusal& logged = log_.refusals.emplace_back();
    logged.pass = pass.name;
    logged.code = refusal.code;
    logged.vertex = refusal.vertex == kNoIndex ? kNoIndex : draft.vertex_keys[refusal.vertex];
    logged.face = refusal.face == kNoIndex ? kNoIndex : draft.face_keys[refusal.face];
    logged.reason = refusal.reason;
  }
}

void Workshop::log_harm(const PlannedPass& pass, const Signature& signature, Harm harm) {
  LoggedRefusal& logged = log_.refusals.emplace_back();
  logged.pass = pass.name;
  logged.code = pass.code;
  if (signature.size() > 1 && signature.front() == kNoIndex) {
    logged.vertex = signature[1];
  } else if (!signature.empty()) {
    logged.face = signature.front();
  }
  logged.reason = harm_reason(harm);
}

}  // namespace meshalyzer
