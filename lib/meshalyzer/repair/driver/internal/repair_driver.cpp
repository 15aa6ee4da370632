#include "meshalyzer/repair/driver/internal/repair_driver.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/driver/internal/log_edits.h"
#include "meshalyzer/repair/driver/internal/log_refusals.h"
#include "meshalyzer/repair/edits/apply_edits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// The repair stops after this number of rounds, in case passes undo each other's work for ever.
constexpr std::size_t kMaxRounds = 20;
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
/// nothing, while there are no more than this fraction more or less.
constexpr std::size_t kManyPairs = 10'000;
constexpr double kAlikeShare = 0.1;
/// If a mesh that a stage has made has more intersecting pairs than before, it is given up after
/// this number of rounds, unless the last one has made them fewer.
constexpr std::size_t kRoundsForPairs = 2;
/// After this number of stages, banned operations stay banned.
constexpr std::size_t kMaxStages = 10;

bool are_many_alike(std::size_t n_pairs, std::size_t n_before) {
  const auto n = static_cast<double>(n_pairs);
  return n_pairs >= kManyPairs && std::abs(n - static_cast<double>(n_before)) <= kAlikeShare * n;
}

}  // namespace

RepairDriver::RepairDriver(Soup input, const Tolerances& tolerances, RepairLimits limits,
                           FixedVertices fixed, PairLimits pairs)
    : input_(std::move(input)),
      tolerances_(tolerances),
      limits_(std::move(limits)),
      fixed_(std::move(fixed)),
      meter_(std::in_place, input_),
      max_pairs_(pairs.max_found),
      state_(std::make_shared<RepairState>(track_mesh(input_), tolerances_, pairs)),
      wants_to_stop_(std::move(pairs.wants_to_stop)) {}

void RepairDriver::run_plan(const std::vector<PlannedPass>& plan, const RepairOptions& options,
                            OnWorse on_worse) {
  on_progress_ = options.on_progress;
  const FinalCheck check = final_check_for(options, input_.format);
  DefectInventory before = list_defective_in_file(*state_, tolerances_, check);
  const bool turns_over = std::any_of(plan.begin(), plan.end(), [](const PlannedPass& pass) {
    return pass.may_create.contains(DefectCode::Inward);
  });
  if (turns_over) before.is_yes[static_cast<std::size_t>(Attribute::Outward)] = false;
  if (input_counts_ || checkpoint_) {
    set_checkpoint();
  } else {
    input_pairs_ = known_pairs();
  }
  if (!input_counts_) input_counts_ = {{}, before.counts, before.is_yes};
  for (std::size_t stage = 0; stage < kMaxStages; ++stage) {
    std::optional<DefectInventory> after = run_stage(plan, {check, before, on_worse});
    if (!after) break;
    before = std::move(*after);
    // Operations that were banned because of others may be possible now; they are tried until none
    // is left.
    if (banned_.size() == 0) break;
    set_checkpoint();
  }
  rises_ = find_rises(*input_counts_, before);
}

std::vector<double> RepairDriver::measure_parts(std::span<const Index> part_of,
                                                std::size_t n_parts) const {
  return meter_->measure_parts({state_->tracked(), state_->mesh(), limits_.max_deviation, walls_},
                               part_of, n_parts);
}

void RepairDriver::update_deviation() {
  if (is_deviation_known_) return;
  // All that was applied was found to be within the maximum.
  deviation_ = std::min(measure_without(lost_), limits_.max_deviation);
  is_deviation_known_ = true;
}

double RepairDriver::deviation() {
  update_deviation();
  return deviation_;
}

double RepairDriver::measure_deviation() {
  deviation_ = measure_without({});
  is_deviation_known_ = true;
  return deviation_;
}

double RepairDriver::measure_without(std::span<const Index> lost) const {
  return meter_
      ->measure({.tracked = state_->tracked(),
                 .mesh = state_->mesh(),
                 .bound = limits_.max_deviation,
                 .walls = walls_,
                 .lost = lost})
      .largest;
}

void RepairDriver::raise_deviation(double deviation) {
  deviation_ = std::max(this->deviation(), deviation);
}

void RepairDriver::set_checkpoint() {
  banned_ = {};
  checkpoint_ = {state_->tracked(), known_pairs(), log_, deviation(), is_within_, walls_, lost_};
  applied_.clear();
}

bool RepairDriver::run_trial(const Trial& trial) {
  set_checkpoint();
  costly_idle_runs_.clear();
  if (!trial.from_input.empty()) {
    return_to_input();
    static_cast<void>(run_rounds(trial.from_input));
  }
  const std::vector<Index> face_keys = state_->tracked().face_keys;
  apply_unchecked(trial.change);
  if (state_->tracked().face_keys != face_keys) {
    static_cast<void>(run_rounds(trial.plan));
    if (!is_stopped_ && trial.is_wanted(*state_)) return true;
  }
  restart();
  return false;
}

std::optional<DefectInventory> RepairDriver::run_stage(const std::vector<PlannedPass>& plan,
                                                       const StageGate& gate) {
  std::size_t work = 0;
  for (std::size_t attempt = 0;; ++attempt) {
    // Copies that keep their contact are pairs, too.
    const bool may_be_given_up =
        gate.on_worse == OnWorse::Leave && gate.check.unwelded == UnweldedPairs::Count;
    const bool is_given_up = !run_rounds(plan, may_be_given_up);
    if (applied_.empty()) return std::nullopt;
    if (is_given_up) {
      restart();
      return std::nullopt;
    }
    DefectInventory after = list_defective_in_file(*state_, tolerances_, gate.check);
    const Worsening worsening = find_worsening(gate.before, after);
    if (worsening.empty()) return after;
    if (is_stopped_ || gate.on_worse == OnWorse::Leave) {
      restart();
      return std::nullopt;
    }
    work += state_->tracked().soup.n_faces() + state_->mesh().intersecting_pairs().size();
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
    places.push_back({element.kind, corners_of(state_->tracked(), element)});
  }
  if (attempt < kAttemptsByLast) {
    ban_responsible(applied_, places, Blame::Last, input_, banned_);
  }
  if (banned_.size() == n_banned && attempt < kAttemptsByAll) {
    ban_responsible(applied_, places, Blame::All, input_, banned_);
  }
  if (banned_.size() == n_banned) banned_.add(applied_.back().pass);
}

void RepairDriver::restart() {
  hopeless_.clear();
  if (!checkpoint_) return return_to_input();
  restore(*checkpoint_);
}

void RepairDriver::return_to_input() {
  restore({.tracked = track_mesh(input_),
           .pairs = input_pairs_,
           .log = {},
           .deviation = 0.0,
           .is_within = true,
           .walls = {},
           .lost = {}});
}

void RepairDriver::restore(const Checkpoint& checkpoint) {
  meter_.emplace(input_);
  state_ = checkpoint.pairs
               ? std::make_shared<RepairState>(checkpoint.tracked, tolerances_, *checkpoint.pairs)
               : search_all(checkpoint.tracked);
  meter_->include_patches(state_->tracked());
  log_ = checkpoint.log;
  deviation_ = checkpoint.deviation;
  is_within_ = checkpoint.is_within;
  walls_ = checkpoint.walls;
  lost_ = checkpoint.lost;
  is_deviation_known_ = true;
  applied_.clear();
}

std::shared_ptr<const RepairState> RepairDriver::search_all(TrackedMesh tracked) const {
  return std::make_shared<RepairState>(std::move(tracked), tolerances_,
                                       PairLimits{.max_found = max_pairs_, .wants_to_stop = {}});
}

std::optional<std::vector<IntersectingPair>> RepairDriver::known_pairs() const {
  const std::vector<IntersectingPair>& pairs = state_->mesh().intersecting_pairs();
  if (state_->mesh().was_intersection_search_cut()) return std::nullopt;
  return pairs;
}

bool RepairDriver::run_rounds(const std::vector<PlannedPass>& plan, bool may_be_given_up) {
  const auto n_pairs = [&] { return state_->mesh().intersecting_pairs().size(); };
  const std::size_t n_pairs_at_first = n_pairs();
  std::vector<std::optional<IdleRun>> idle_runs(plan.size());
  std::size_t n_changes = 0;
  for (std::size_t round = 0; round < kMaxRounds; ++round) {
    const std::size_t n_changes_before = n_changes;
    const std::size_t n_pairs_before = n_pairs();
    log_.refusals.clear();
    std::vector<std::uint8_t> fixed = fixed_(state_->tracked(), state_->mesh().cut());
    if (fixed != limits_.fixed_vertices) idle_runs.assign(plan.size(), std::nullopt);
    limits_.fixed_vertices = std::move(fixed);
    for (std::size_t i = 0; i < plan.size(); ++i) {
      if (round > 0 && plan[i].repeat == Repeat::Once) continue;
      if (is_to_stop()) return true;
      if (on_progress_) {
        on_progress_({.pass = plan[i].name,
                      .round = round + 1,
                      .done = static_cast<double>(i) / static_cast<double>(plan.size())});
      }
      run_unless_idle(plan[i], n_changes, idle_runs[i]);
    }
    if (n_changes == n_changes_before) return true;
    if (may_be_given_up && round >= kRoundsForPairs && n_pairs() > n_pairs_at_first &&
        n_pairs() >= n_pairs_before) {
      return false;
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
  const std::size_t n_pairs = n_pairs_for(pass);
  const auto costly = costly_idle_runs_.find(pass.name);
  if (costly != costly_idle_runs_.end() && are_many_alike(n_pairs, costly->second.n_pairs)) {
    refusals.insert(refusals.end(), costly->second.refusals.begin(), costly->second.refusals.end());
    return;
  }
  const auto n_refusals = static_cast<std::ptrdiff_t>(refusals.size());
  const bool has_changed = run(pass);
  std::vector<LoggedRefusal> refused(refusals.begin() + n_refusals, refusals.end());
  if (pass.takes_time_for_pairs && (!has_changed || are_many_alike(n_pairs_for(pass), n_pairs))) {
    note_costly_idle_run(pass, {n_pairs, refused});
  }
  if (has_changed) {
    ++n_changes;
  } else {
    idle_run = {n_changes, std::move(refused)};
  }
}

std::size_t RepairDriver::n_pairs_for(const PlannedPass& pass) const {
  return pass.takes_time_for_pairs ? state_->mesh().intersecting_pairs().size() : 0;
}

void RepairDriver::note_costly_idle_run(const PlannedPass& pass, CostlyIdleRun idle_run) {
  // Only keys of the input name the same faces after a restart.
  std::erase_if(idle_run.refusals, [&](const LoggedRefusal& refusal) {
    return refusal.face >= state_->tracked().n_input_faces;
  });
  costly_idle_runs_[pass.name] = std::move(idle_run);
}

bool RepairDriver::is_to_stop() {
  is_stopped_ = is_stopped_ || wants_to_stop_();
  return is_stopped_;
}

void RepairDriver::apply_unchecked(const PlannedPass& pass) {
  const PassResult result = propose(pass, OperationSize::Normal);
  if (result.edits.empty()) return;
  // A change that is not checked is not measured either: the deviation stays as it was before.
  update_deviation();
  TrackedMesh tracked = apply_edits(state_->tracked(), result.edits);
  const AffectedElements affected =
      find_affected_elements(state_->tracked(), result.edits, SkippedOperations({}), tracked);
  log_edits(std::string(pass.name), pass.code,
            {state_->tracked(), result.edits, {}, tracked, affected}, log_);
  walls_ = walls_with(result.edits, std::vector<std::uint8_t>(result.edits.n_operations, 0));
  state_ = search_all(std::move(tracked));
  include_patches(result.edits);
  find_lost_faces();
}

void RepairDriver::find_lost_faces() {
  FarFaces far = meter_->find_far({.tracked = state_->tracked(),
                                   .mesh = state_->mesh(),
                                   .bound = limits_.max_deviation,
                                   .walls = walls_});
  lost_ = std::move(far.of_input);
  is_within_ = far.of_repaired.empty();
}

PassResult RepairDriver::propose(const PlannedPass& pass, OperationSize size) const {
  return pass.run(
      {input_, state_->tracked(), state_->mesh(), tolerances_, limits_, size, wants_to_stop_});
}

bool RepairDriver::run(const PlannedPass& pass) {
  bool has_changed = false;
  ProposedBefore before;
  const std::size_t max_runs = pass.repeat == Repeat::Once ? 1 : kMaxRuns;
  OperationSize size = OperationSize::Normal;
  for (std::size_t i = 0; i < max_runs && !is_to_stop(); ++i) {
    const std::shared_ptr<const RepairState> examined = state_;
    const PassResult result = propose(pass, size);
    const bool is_applied = !result.edits.empty() && apply_accepted(pass, result.edits, before);
    has_changed = has_changed || is_applied;
    if (is_applied && pass.repeat != Repeat::OncePerRound) continue;
    // One bad step may have caused the rejection of all steps of its operation. What is left after
    // others were applied may have smaller operations, too.
    const bool has_more = !before.rejected.empty() && size != OperationSize::Smallest &&
                          (result.has_smaller_operations || is_applied);
    if (!has_more) {
      log_refusals(pass, result.refused, examined->tracked(), log_);
      return has_changed;
    }
    size = OperationSize::Smallest;
  }
  return has_changed;
}

bool RepairDriver::apply_accepted(const PlannedPass& pass, const Edits& edits,
                                  ProposedBefore& before) {
  const TrackedMesh& tracked_before = state_->tracked();
  const std::vector<OperationSignature> signature = signatures_of(tracked_before, edits);
  const std::vector<OperationHash> hash = hashes_of(tracked_before, edits);
  const std::vector<OperationSite> site = sites_of(tracked_before, edits);
  std::vector<std::uint8_t> skipped(edits.n_operations, 0);
  for (std::size_t op = 0; op < skipped.size(); ++op) {
    const bool is_banned = banned_.contains(pass.name, site[op]);
    if (is_banned && before.rejected.insert(signature[op]).second) {
      log_rejection(pass, signature[op], Rejection::EndsWorse, log_);
    }
    const bool is_rejected = before.rejected.contains(signature[op]);
    const auto known = hopeless_.find(hash[op]);
    const bool is_hopeless = !is_rejected && known != hopeless_.end();
    if (is_hopeless && before.hopeless.insert(signature[op]).second) {
      log_rejection(pass, signature[op], known->second, log_);
    }
    skipped[op] = is_rejected || is_hopeless;
  }
  for (std::size_t trial = 0; trial < kMaxTrials && !is_to_stop(); ++trial) {
    if (std::all_of(skipped.begin(), skipped.end(), [](auto s) { return s != 0; })) return false;
    TrackedMesh tracked = apply_edits(state_->tracked(), edits, skipped);
    const AffectedElements affected =
        find_affected_elements(state_->tracked(), edits, SkippedOperations(skipped), tracked);
    auto after = std::make_shared<RepairState>(std::move(tracked), tolerances_, *state_, affected);
    std::vector<InteriorWall> walls = walls_with(edits, skipped);
    const AcceptanceRules rules{.input = input_,
                                .meter = *meter_,
                                .max_deviation = limits_.max_deviation,
                                .may_create = pass.may_create,
                                .must_mend = pass.must_mend,
                                .walls = walls,
                                .lost = lost_,
                                .was_within = is_within_};
    const Acceptance acceptance =
        check_acceptance(*state_, *after, affected, skipped.size(), rules);
    if (acceptance.all_accepted()) {
      log_edits(std::string(pass.name), pass.code,
                {state_->tracked(), edits, skipped, after->tracked(), affected}, log_);
      record_applied({pass, site, skipped, affected, after->tracked()});
      state_ = std::move(after);
      walls_ = std::move(walls);
      is_deviation_known_ = false;
      is_within_ = true;
      include_patches(edits);
      return true;
    }
    for (std::size_t op = 0; op < skipped.size(); ++op) {
      if (skipped[op] != 0 || acceptance.rejections[op] == Rejection::None) continue;
      skipped[op] = 1;
      before.rejected.insert(signature[op]);
      if (is_hopeless_after(acceptance.rejections[op])) {
        hopeless_.emplace(hash[op], acceptance.rejections[op]);
      }
      log_rejection(pass, signature[op], acceptance.rejections[op], log_);
    }
  }
  return false;
}

bool RepairDriver::is_hopeless_after(Rejection rejection) const {
  const bool is_crowded = state_->mesh().intersecting_pairs().size() >= kManyPairs;
  return rejection == Rejection::TooFar || (rejection == Rejection::Intersects && is_crowded);
}

void RepairDriver::record_applied(const MadeOperations& made) {
  std::vector<AppliedOperation> applied(made.sites.size());
  for (std::size_t op = 0; op < applied.size(); ++op) {
    applied[op] = {made.pass.name, made.pass.may_create, made.sites[op], {}};
  }
  for (const AffectedElement& entry : made.affected.vertices) {
    applied[entry.operation].vertices.push_back(vertex_identity(made.after, entry.key));
  }
  for (std::size_t op = 0; op < applied.size(); ++op) {
    if (made.skipped[op] != 0) continue;
    sort_unique(applied[op].vertices);
    applied_.push_back(std::move(applied[op]));
  }
}

std::vector<InteriorWall> RepairDriver::walls_with(const Edits& edits,
                                                   std::span<const std::uint8_t> skipped) const {
  std::vector<InteriorWall> walls = walls_;
  for (const auto& [op, wall] : edits.interior_walls) {
    if (skipped[op] != 0) continue;
    const Index origin =
        wall.face == kNoIndex ? kNoIndex : state_->tracked().origin_of_face(wall.face);
    walls.push_back({wall.corners, origin});
  }
  return walls;
}

void RepairDriver::include_patches(const Edits& edits) {
  const bool has_patches = std::any_of(edits.added_faces.begin(), edits.added_faces.end(),
                                       [](const auto& face) { return face.fills_hole; });
  if (has_patches) meter_->include_patches(state_->tracked());
}

}  // namespace meshalyzer
