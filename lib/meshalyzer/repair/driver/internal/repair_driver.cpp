#include "meshalyzer/repair/driver/internal/repair_driver.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/driver/internal/log_edits.h"
#include "meshalyzer/repair/driver/internal/log_refusals.h"
#include "meshalyzer/repair/driver/internal/round_progress.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// Rounds end after this number of them, or once so many in succession have made no progress:
/// passes may undo each other's work for ever.
constexpr std::size_t kMaxRounds = 20;
constexpr std::size_t kRoundsWithoutProgress = 3;
/// The maximum number of successive runs of a pass: each run leaves less to do, but a pass that
/// repairs one of a long chain of defects at a time must not take forever.
constexpr std::size_t kMaxRuns = 200;
/// Rejected operations are removed from a list this number of times before all of it is dropped.
constexpr std::size_t kMaxTrials = 10;
/// The number of attempts that ban the operations most likely responsible for a worse mesh; later
/// ones ban all that may be, and then pass after pass.
constexpr std::size_t kAttemptsByLast = 6;
constexpr std::size_t kAttemptsByAll = 10;
/// Once this number of faces and intersecting pairs has been examined without success, nothing more
/// is tried: the mesh at the beginning of the stage is kept.
constexpr std::size_t kMaxWork = 20'000'000;
/// In a mesh with at least this number of intersecting pairs, an operation that makes faces
/// intersect is not tried again, nor is a pass that takes time for each pair and has changed
/// nothing, while there are no more than this fraction more or less. Nor is anything tried again
/// that was banned.
constexpr std::size_t kManyPairs = 10'000;
constexpr double kAlikeShare = 0.1;
/// If at least this number of operations is banned, and so many times as many as were applied,
/// hardly anything of them would be possible after all: they stay banned.
constexpr std::size_t kManyBanned = 1'000;
constexpr std::size_t kBannedPerApplied = 4;
/// Once so many are banned, an attempt that bans less than this share more bans all that may be
/// responsible, too: otherwise attempt after attempt would ban a few more of thousands.
constexpr double kFewShare = 0.01;
/// If a mesh that a stage has made has more intersecting pairs than before, it is given up after
/// this number of rounds, unless the last one has made them fewer; and if they are as many as
/// kManyPairs, a round earlier in any case, and if they are also so many times as many as before,
/// as soon as a pass would take time for each of them. If it has no more than before, but still as
/// many as kPairsOfNoProgress, the stage ends then.
constexpr std::size_t kRoundsForPairs = 2;
constexpr std::size_t kTimesAsManyPairs = 10;
constexpr std::size_t kPairsOfNoProgress = 1'000;
/// After this number of stages, banned operations stay banned.
constexpr std::size_t kMaxStages = 10;
/// A stage after the first one, which tries what was banned, is given up after this number of
/// attempts: mostly it would ban the same operations again, one after the other.
constexpr std::size_t kAttemptsOfLaterStages = 3;

/// A mesh with at least this number of intersecting pairs, and so many for each of its faces, is a
/// heap of faces, as where indices were shifted. It cannot be cut, so that all other repairs are of
/// little use. In a heap, each pass runs at most this number of times in a round, one that has
/// changed nothing is not run again while the pairs are about as many, and rounds beyond this
/// number go on only if the last one has left notably fewer pairs.
constexpr std::size_t kPairsOfHeap = 30'000;
constexpr std::size_t kPairsAFaceOfHeap = 32;
constexpr std::size_t kRunsInHeap = 3;
constexpr std::size_t kRoundsInHeap = 2;

bool are_many_alike(std::size_t n_pairs, std::size_t n_before) {
  const auto n = static_cast<double>(n_pairs);
  return n_pairs >= kManyPairs && std::abs(n - static_cast<double>(n_before)) <= kAlikeShare * n;
}

bool have_multiplied(std::size_t n_pairs, std::size_t n_before) {
  return n_pairs >= kManyPairs && n_pairs >= kTimesAsManyPairs * n_before;
}

}  // namespace

RepairDriver::RepairDriver(Soup input, const Tolerances& tolerances, RepairLimits limits,
                           FixedVertices fixed, DriverSettings settings)
    : mesh_(std::move(input), tolerances, limits.max_deviation, settings.pairs),
      limits_(std::move(limits)),
      fixed_(std::move(fixed)),
      settings_(std::move(settings)) {}

void RepairDriver::run_plan(const std::vector<PlannedPass>& plan, OnWorse on_worse) {
  DefectInventory before = is_inventory_known() ? std::move(known_->inventory) : inventory();
  known_.reset();
  if (input_counts_) {
    set_checkpoint();
  } else {
    note_input(before);
  }
  const bool turns_over = std::any_of(plan.begin(), plan.end(), [](const PlannedPass& pass) {
    return pass.may_create.contains(DefectCode::Inward);
  });
  if (turns_over) before.is_yes[static_cast<std::size_t>(Attribute::Outward)] = false;
  for (std::size_t stage = 0; stage < kMaxStages; ++stage) {
    const std::size_t max_attempts =
        stage == 0 ? std::numeric_limits<std::size_t>::max() : kAttemptsOfLaterStages;
    std::optional<DefectInventory> after = run_stage(plan, {before, on_worse, max_attempts});
    if (!after) break;
    before = std::move(*after);
    if (!is_worth_trying_banned()) break;
    set_checkpoint();
  }
  if (!turns_over) known_ = {mesh_.shared_state(), std::move(before)};
}

DefectInventory RepairDriver::inventory() const {
  return list_defective_in_file(mesh_.state(), mesh_.tolerances(), settings_.check);
}

bool RepairDriver::is_good(const RepairState& state) const {
  return is_good_in_file(state, mesh_.tolerances(), settings_.check);
}

void RepairDriver::note_input(const DefectInventory& inventory) {
  mesh_.note_input_pairs();
  input_counts_ = {{}, inventory.counts, inventory.is_yes};
}

std::vector<CountRise> RepairDriver::rises() const {
  if (!input_counts_ || log_.steps.empty()) return {};
  if (is_inventory_known()) return find_rises(*input_counts_, known_->inventory);
  return find_rises(*input_counts_, inventory());
}

/// Operations that were banned because of others may be possible now. In a heap of faces most are
/// banned each time.
bool RepairDriver::is_worth_trying_banned() const {
  const bool is_nearly_all_banned =
      banned_.size() >= kManyBanned && banned_.size() > kBannedPerApplied * runs_.applied.size();
  return banned_.size() != 0 && !is_nearly_all_banned && n_pairs() < kManyPairs;
}

void RepairDriver::set_checkpoint() {
  banned_ = {};
  checkpoint_ = checkpoint();
  runs_.applied.clear();
}

bool RepairDriver::run_trial(const Trial& trial) {
  if (!input_counts_) note_input(inventory());
  set_checkpoint();
  runs_.costly_idle_runs.clear();
  if (!trial.from_input.empty()) start_from_input(trial.from_input);
  const std::vector<Index> face_keys = mesh_.tracked().face_keys;
  for (const PlannedPass& change : trial.changes) {
    apply_unchecked(change, settings_.pairs.wants_to_stop);
  }
  if (!is_to_stop() && mesh_.tracked().face_keys != face_keys) {
    static_cast<void>(run_rounds(trial.plan));
    if (!is_stopped_ && trial.is_wanted(mesh_.state())) return true;
  }
  restart();
  return false;
}

void RepairDriver::start_from_input(const std::vector<PlannedPass>& plan) {
  std::vector<std::string_view> names;
  for (const PlannedPass& pass : plan) names.push_back(pass.name);
  if (start_ && start_->names == names) {
    return_to(start_->made);
    runs_ = start_->memory;
    limits_.fixed_vertices = start_->fixed_vertices;
    return;
  }
  runs_.hopeless.clear();
  return_to_input();
  static_cast<void>(run_rounds(plan));
  if (is_stopped_) return;
  start_ = {std::move(names), checkpoint(), runs_, limits_.fixed_vertices};
}

std::optional<DefectInventory> RepairDriver::run_stage(const std::vector<PlannedPass>& plan,
                                                       const StageGate& gate) {
  std::size_t work = 0;
  for (std::size_t attempt = 0;; ++attempt) {
    // Copies that keep their contact are pairs, too.
    const bool may_be_given_up =
        gate.on_worse == OnWorse::Leave && settings_.check.unwelded == UnweldedPairs::Count;
    const bool is_given_up = !run_rounds(plan, may_be_given_up);
    if (runs_.applied.empty()) return std::nullopt;
    if (is_given_up) {
      restart();
      return std::nullopt;
    }
    DefectInventory after = inventory();
    const Worsening worsening = find_worsening(gate.before, after);
    if (worsening.empty()) return after;
    const bool is_last = attempt + 1 >= gate.max_attempts;
    if (is_stopped_ || gate.on_worse == OnWorse::Leave || is_last) {
      restart();
      return std::nullopt;
    }
    work += mesh_.tracked().soup.n_faces() + n_pairs();
    if (work > kMaxWork) {
      for (const PlannedPass& pass : plan) banned_.add(pass.name);
    } else {
      ban(gate.before, after, worsening, attempt);
    }
    restart();
  }
}

void RepairDriver::ban(const DefectInventory& before, const DefectInventory& after,
                       const Worsening& worsening, std::size_t attempt) {
  const std::size_t n_banned = banned_.size();
  std::vector<WorsePlace> places;
  for (const CountedElement& element : find_new_elements(before, after, worsening)) {
    places.push_back({element.kind, corners_of(mesh_.tracked(), element)});
  }
  if (attempt < kAttemptsByLast) {
    ban_responsible(runs_.applied, places, Responsible::Last, mesh_.input(), banned_);
  }
  const auto n_more = static_cast<double>(banned_.size() - n_banned);
  const bool are_few_more =
      n_banned >= kManyBanned && n_more < kFewShare * static_cast<double>(n_banned);
  if ((n_more == 0.0 || are_few_more) && attempt < kAttemptsByAll) {
    ban_responsible(runs_.applied, places, Responsible::All, mesh_.input(), banned_);
  }
  if (banned_.size() == n_banned) banned_.add(runs_.applied.back().pass);
}

void RepairDriver::restart() {
  runs_.hopeless.clear();
  if (!checkpoint_) return return_to_input();
  return_to(*checkpoint_);
}

void RepairDriver::return_to(const Checkpoint& checkpoint) {
  mesh_.restore(checkpoint.mesh);
  log_ = checkpoint.log;
  runs_.applied.clear();
}

void RepairDriver::return_to_input() {
  mesh_.return_to_input();
  log_ = {};
  runs_.applied.clear();
}

bool RepairDriver::run_rounds(const std::vector<PlannedPass>& plan, bool may_be_given_up) {
  const std::size_t n_pairs_at_first = n_pairs();
  std::vector<std::optional<IdleRun>> idle_runs(plan.size());
  std::size_t n_changes = 0;
  RoundProgress progress;
  for (std::size_t round = 0; round < kMaxRounds; ++round) {
    const std::size_t n_changes_before = n_changes;
    const std::size_t n_pairs_before = n_pairs();
    log_.refusals.clear();
    std::vector<std::uint8_t> fixed = fixed_(mesh_.tracked(), mesh_.prepared().cut());
    if (fixed != limits_.fixed_vertices) idle_runs.assign(plan.size(), std::nullopt);
    limits_.fixed_vertices = std::move(fixed);
    for (std::size_t i = 0; i < plan.size(); ++i) {
      if (round > 0 && plan[i].repeat == Repeat::Once) continue;
      if (is_to_stop()) return true;
      if (may_be_given_up && plan[i].takes_time_for_pairs &&
          have_multiplied(n_pairs(), n_pairs_at_first)) {
        return false;
      }
      if (settings_.on_progress) {
        settings_.on_progress({.pass = plan[i].name,
                               .round = round + 1,
                               .done = static_cast<double>(i) / static_cast<double>(plan.size())});
      }
      run_unless_idle(plan[i], n_changes, idle_runs[i]);
    }
    if (n_changes == n_changes_before) return true;
    progress.note(mesh_.state());
    if (progress.n_rounds_without() >= kRoundsWithoutProgress) return true;
    if (round + 1 >= kRoundsInHeap && is_heap() && are_many_alike(n_pairs(), n_pairs_before)) {
      return true;
    }
    if (!may_be_given_up) continue;
    const bool has_more = n_pairs() > n_pairs_at_first;
    if (has_more && n_pairs() >= kManyPairs && round + 1 >= kRoundsForPairs) return false;
    if (round >= kRoundsForPairs && n_pairs() >= n_pairs_before) {
      if (has_more) return false;
      if (n_pairs() >= kPairsOfNoProgress) return true;
    }
  }
  return true;
}

void RepairDriver::run_unless_idle(const PlannedPass& pass, std::size_t& n_changes,
                                   std::optional<IdleRun>& idle_run) {
  std::vector<LoggedRefusal>& refusals = log_.refusals;
  if (idle_run && idle_run->n_changes_before == n_changes) {
    refusals.insert(refusals.end(), idle_run->refusals.begin(), idle_run->refusals.end());
    return;
  }
  const std::size_t n_pairs_before = n_pairs();
  const std::vector<CostlyIdleRun>& costly = runs_.costly_idle_runs[pass.name];
  const auto alike = std::find_if(costly.rbegin(), costly.rend(), [&](const CostlyIdleRun& known) {
    return are_many_alike(n_pairs_before, known.n_pairs);
  });
  if (alike != costly.rend()) {
    refusals.insert(refusals.end(), alike->refusals.begin(), alike->refusals.end());
    return;
  }
  const auto n_refusals = static_cast<std::ptrdiff_t>(refusals.size());
  const bool has_changed = run(pass);
  std::vector<LoggedRefusal> refused(refusals.begin() + n_refusals, refusals.end());
  const bool leaves_pairs = !has_changed || are_many_alike(n_pairs(), n_pairs_before);
  if (leaves_pairs && (pass.takes_time_for_pairs || (!has_changed && is_heap()))) {
    note_costly_idle_run(pass, {n_pairs_before, refused});
  }
  if (has_changed) {
    ++n_changes;
  } else {
    idle_run = {n_changes, std::move(refused)};
  }
}

bool RepairDriver::is_heap() const {
  return n_pairs() >= kPairsOfHeap &&
         n_pairs() >= kPairsAFaceOfHeap * mesh_.tracked().soup.n_faces();
}

void RepairDriver::note_costly_idle_run(const PlannedPass& pass, CostlyIdleRun idle_run) {
  // Only keys of the input name the same faces after a restart.
  std::erase_if(idle_run.refusals, [&](const LoggedRefusal& refusal) {
    return refusal.face >= mesh_.tracked().n_input_faces;
  });
  runs_.costly_idle_runs[pass.name].push_back(std::move(idle_run));
}

bool RepairDriver::is_to_stop() {
  is_stopped_ = is_stopped_ || settings_.pairs.wants_to_stop();
  return is_stopped_;
}

void RepairDriver::apply_unchecked(const PlannedPass& pass, const StopQuery& wants_to_stop) {
  const std::shared_ptr<const RepairState> before = mesh_.shared_state();
  const PassResult result = pass.run(input_of_pass(OperationSize::Normal, 0.0));
  const std::vector<std::uint8_t> overflows = which_overflow(result.edits);
  const bool any_overflows =
      std::any_of(overflows.begin(), overflows.end(), [](auto o) { return o != 0; });
  if (result.edits.empty() || any_overflows) return;
  const AffectedElements affected = mesh_.apply_unchecked(result.edits, wants_to_stop);
  log_edits(std::string(pass.name), pass.code,
            {before->tracked(), result.edits, {}, mesh_.tracked(), affected}, log_);
}

PassInput RepairDriver::input_of_pass(OperationSize size, double length) {
  return {.original = mesh_.input(),
          .tracked = mesh_.tracked(),
          .mesh = mesh_.prepared(),
          .tolerances = mesh_.tolerances(),
          .limits = limits_,
          .operation_size = size,
          .wants_to_stop = settings_.pairs.wants_to_stop,
          .length = length,
          .mesh_number = mesh_.number(),
          .memory = &memory_};
}

bool RepairDriver::run(const PlannedPass& pass) {
  bool has_changed = false;
  RefusedInState refused;
  for (std::optional<double> length = 0.0; length;) {
    changed_vertices_.clear();
    has_changed = run_at(pass, *length, refused) || has_changed;
    length = length_after(pass, *length);
  }
  if (refused.state) log_refusals(pass, refused.refusals, refused.state->tracked(), log_);
  return has_changed;
}

std::optional<double> RepairDriver::length_after(const PlannedPass& pass, double length) {
  if (!pass.lengths || is_to_stop()) return std::nullopt;
  sort_unique(changed_vertices_);
  return pass.lengths(input_of_pass(OperationSize::Normal, length), changed_vertices_);
}

bool RepairDriver::run_at(const PlannedPass& pass, double length, RefusedInState& refused) {
  bool has_changed = false;
  ProposedBefore before;
  const std::size_t max_runs = pass.repeat == Repeat::Once ? 1 : is_heap() ? kRunsInHeap : kMaxRuns;
  OperationSize size = OperationSize::Normal;
  for (std::size_t i = 0; i < max_runs && !is_to_stop(); ++i) {
    const std::shared_ptr<const RepairState> examined = mesh_.shared_state();
    PassResult result = pass.run(input_of_pass(size, length));
    const bool is_applied = !result.edits.empty() && apply_accepted(pass, result.edits, before);
    has_changed = has_changed || is_applied;
    const bool is_last = i + 1 == max_runs;
    if (is_applied && pass.repeat != Repeat::OncePerRound && !is_last) continue;
    // One bad step may have caused the rejection of all steps of its operation. What is left after
    // others were applied may have smaller operations, too.
    const bool has_more = !before.rejected.empty() && size != OperationSize::Smallest &&
                          (result.has_smaller_operations || is_applied);
    if (!has_more || is_last) {
      refused = {examined, std::move(result.refused)};
      return has_changed;
    }
    size = OperationSize::Smallest;
  }
  return has_changed;
}

bool RepairDriver::apply_accepted(const PlannedPass& pass, const Edits& edits,
                                  ProposedBefore& before) {
  Proposal proposal{.edits = edits,
                    .signatures = signatures_of(mesh_.tracked(), edits),
                    .hashes = hashes_of(mesh_.tracked(), edits),
                    .sites = sites_of(mesh_.tracked(), edits),
                    .skipped = std::vector<std::uint8_t>(edits.n_operations, 0)};
  skip_known(pass, before, proposal);
  skip_overflowing(pass, before, proposal);
  std::shared_ptr<const RepairState> tried_before;
  for (std::size_t i = 0; i < kMaxTrials && !is_to_stop(); ++i) {
    if (proposal.are_all_skipped()) return false;
    MeasuredMesh::Trial trial = mesh_.try_edits(edits, proposal.skipped, tried_before.get());
    const Acceptance acceptance = mesh_.check(trial, edits.n_operations, pass);
    if (acceptance.all_accepted()) {
      for (const AffectedElement& e : trial.affected.vertices) changed_vertices_.push_back(e.key);
      record(pass, std::move(proposal), trial);
      mesh_.keep(std::move(trial), edits);
      return true;
    }
    skip_rejected(pass, acceptance, before, proposal);
    // Where few faces intersect, their pairs are found again sooner than the memory is worth.
    const bool is_crowded = trial.after->affected_pairs().size() >= kManyPairs;
    if (is_crowded) tried_before = std::move(trial.after);
  }
  return false;
}

bool RepairDriver::Proposal::are_all_skipped() const {
  return std::all_of(skipped.begin(), skipped.end(), [](auto s) { return s != 0; });
}

void RepairDriver::skip_known(const PlannedPass& pass, ProposedBefore& before, Proposal& proposal) {
  for (std::size_t op = 0; op < proposal.skipped.size(); ++op) {
    const OperationSignature& signature = proposal.signatures[op];
    const bool is_banned = banned_.contains(pass.name, proposal.sites[op]);
    if (is_banned && before.rejected.insert(signature).second) {
      log_rejection(pass, signature, Rejection::EndsWorse, log_);
    }
    const bool is_rejected = before.rejected.contains(signature);
    const auto known = runs_.hopeless.find(proposal.hashes[op]);
    const bool is_hopeless = !is_rejected && known != runs_.hopeless.end();
    if (is_hopeless && before.hopeless.insert(signature).second) {
      log_rejection(pass, signature, known->second, log_);
    }
    proposal.skipped[op] = is_rejected || is_hopeless;
  }
}

void RepairDriver::skip_overflowing(const PlannedPass& pass, ProposedBefore& before,
                                    Proposal& proposal) {
  Acceptance acceptance;
  for (const std::uint8_t overflows : which_overflow(proposal.edits)) {
    acceptance.rejections.push_back(overflows != 0 ? Rejection::TooFar : Rejection::None);
  }
  skip_rejected(pass, acceptance, before, proposal);
}

void RepairDriver::skip_rejected(const PlannedPass& pass, const Acceptance& acceptance,
                                 ProposedBefore& before, Proposal& proposal) {
  for (std::size_t op = 0; op < proposal.skipped.size(); ++op) {
    const Rejection rejection = acceptance.rejections[op];
    if (proposal.skipped[op] != 0 || rejection == Rejection::None) continue;
    proposal.skipped[op] = 1;
    before.rejected.insert(proposal.signatures[op]);
    if (is_hopeless_after(rejection)) runs_.hopeless.emplace(proposal.hashes[op], rejection);
    log_rejection(pass, proposal.signatures[op], rejection, log_);
  }
}

bool RepairDriver::is_hopeless_after(Rejection rejection) const {
  const bool is_crowded = n_pairs() >= kManyPairs;
  return rejection == Rejection::TooFar || (rejection == Rejection::Intersects && is_crowded);
}

void RepairDriver::record(const PlannedPass& pass, Proposal proposal,
                          const MeasuredMesh::Trial& trial) {
  const TrackedMesh& after = trial.after->tracked();
  log_edits(std::string(pass.name), pass.code,
            {mesh_.tracked(), proposal.edits, proposal.skipped, after, trial.affected}, log_);
  std::vector<AppliedOperation> applied(proposal.sites.size());
  for (std::size_t op = 0; op < applied.size(); ++op) {
    applied[op] = {pass.name, pass.may_create, std::move(proposal.sites[op]), {}};
  }
  for (const AffectedElement& entry : trial.affected.vertices) {
    applied[entry.operation].vertices.push_back(vertex_identity(after, entry.key));
  }
  for (std::size_t op = 0; op < applied.size(); ++op) {
    if (proposal.skipped[op] != 0) continue;
    sort_unique(applied[op].vertices);
    runs_.applied.push_back(std::move(applied[op]));
  }
}

}  // namespace meshalyzer
