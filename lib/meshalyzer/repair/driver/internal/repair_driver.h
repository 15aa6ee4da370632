#pragma once

#include "meshalyzer/base/progress.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/repair/driver/internal/applied_operations.h"
#include "meshalyzer/repair/driver/internal/final_check.h"
#include "meshalyzer/repair/driver/internal/measured_mesh.h"
#include "meshalyzer/repair/driver/internal/operation_names.h"
#include "meshalyzer/repair/driver/internal/plan.h"
#include "meshalyzer/repair/driver/internal/worsening.h"
#include "meshalyzer/repair/driver/repair_log.h"
#include "meshalyzer/repair/internal/pass_memory.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The reaction of a plan to a mesh that it makes worse.
enum class OnWorse : std::uint8_t {
  /// The plan is run again without the operations that are responsible.
  TryAgain,
  /// The mesh stays as it was before.
  Leave,
};

/// What the runs of a driver depend on beside the limits of the repair.
struct DriverSettings {
  /// As MeasuredMesh takes them; their function stops the repair too.
  PairLimits pairs = {};
  /// The file that will hold the mesh, and the contact that counts.
  FinalCheck check = {};
  RepairListener on_progress = {};
};

/// Repairs a mesh: runs passes, and keeps the operations that are accepted.
class RepairDriver {
 public:
  /// Finds the vertices of a tracked mesh that must stay where they are; see
  /// RepairLimits::fixed_vertices.
  using FixedVertices =
      std::function<std::vector<std::uint8_t>(const TrackedMesh& tracked, const CutMesh& cut)>;

  /// @param limits  The limits without fixed vertices.
  /// @param fixed   Called before each round, because a border may have been closed since.
  RepairDriver(Soup input, const Tolerances& tolerances, RepairLimits limits, FixedVertices fixed,
               DriverSettings settings = {});

  [[nodiscard]] const MeasuredMesh& mesh() const { return mesh_; }
  [[nodiscard]] MeasuredMesh& mesh() { return mesh_; }

  /// Runs the passes in order, each until it proposes nothing more that is accepted, and starts
  /// over until no pass changes anything.
  ///
  /// If the resulting mesh is worse than the input, the responsible operations are banned, and all
  /// passes run again without them. Then they run once more from the result, with nothing banned,
  /// until no pass changes anything. If the repair is stopped while the mesh is worse, it returns
  /// to the mesh that it had before. If a plan was run before, the mesh that it has left takes the
  /// place of the input.
  ///
  /// @param on_worse  What happens if the mesh becomes worse.
  void run_plan(const std::vector<PlannedPass>& plan, OnWorse on_worse = OnWorse::TryAgain);

  /// Tells whether a mesh is good as its file will hold it, except for the numbers of its records.
  [[nodiscard]] bool is_good(const RepairState& state) const;

  /// Returns the counts that are larger than in the input.
  ///
  /// @complexity As list_defective(), if anything was changed.
  [[nodiscard]] std::vector<CountRise> rises() const;

  /// Runs a pass once and applies all its operations without checking them, because the user asks
  /// for it by name. If one of them would make coordinates overflow, it applies none.
  ///
  /// @param wants_to_stop  See MeasuredMesh::apply_unchecked().
  void apply_unchecked(const PlannedPass& pass, const StopQuery& wants_to_stop = {});

  /// Changes that are tried, and undone if their result is not wanted.
  struct Trial {
    /// If there are any, the trial starts from the input with these passes.
    std::vector<PlannedPass> from_input = {};
    /// The passes that are then applied unchecked, each once.
    std::vector<PlannedPass> changes;
    /// The passes that run afterwards, as those of run_plan() do.
    std::vector<PlannedPass> plan;
    /// Tells whether the resulting mesh is kept.
    std::function<bool(const RepairState&)> is_wanted;
  };

  /// Tries changes, and undoes them if the resulting mesh is not wanted.
  ///
  /// @return Whether they were kept.
  bool run_trial(const Trial& trial);

  /// A state to which the driver can return, as that from which a stage starts again.
  struct Checkpoint {
    MeasuredMesh::Snapshot mesh;
    RepairLog log;
  };

  /// Returns the present state, which may be that of a trial.
  [[nodiscard]] Checkpoint checkpoint() { return {mesh_.snapshot(), log_}; }
  /// Returns to a state, as if nothing had been applied since.
  void return_to(const Checkpoint& checkpoint);

  /// Returns the log until now.
  [[nodiscard]] const RepairLog& log() const { return log_; }
  /// Tells whether run_plan() was stopped.
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

  [[nodiscard]] RepairLog take_log() { return std::move(log_); }

  /// Adds refusals that an earlier plan has logged; each plan begins without any.
  void add_refusals(const std::vector<LoggedRefusal>& refusals) {
    log_.refusals.insert(log_.refusals.end(), refusals.begin(), refusals.end());
  }

 private:
  /// The operations that a pass proposes.
  struct Proposal {
    const Edits& edits;
    std::vector<OperationSignature> signatures;
    std::vector<OperationHash> hashes;
    std::vector<OperationSite> sites;
    /// Non-zero for each operation that is left out.
    std::vector<std::uint8_t> skipped;

    [[nodiscard]] bool are_all_skipped() const;
  };

  /// The operations that a pass proposes again, though they were rejected.
  struct ProposedBefore {
    /// Those that were rejected in this run of the pass.
    std::set<OperationSignature> rejected;
    /// Those that an earlier run has found to be hopeless.
    std::set<OperationSignature> hopeless;
  };

  /// What a pass has refused to repair in a state of the mesh.
  struct RefusedInState {
    /// Nothing if the pass has refused nothing yet.
    std::shared_ptr<const RepairState> state;
    std::vector<Refusal> refusals;
  };

  /// The state that the result of a stage must not be worse than. This holds references only.
  struct StageGate {
    const DefectInventory& before;
    OnWorse on_worse;
    /// If so many attempts end worse, the stage is given up.
    std::size_t max_attempts;
  };

  /// A run of a pass that changed nothing: it would change nothing again until the mesh changes.
  struct IdleRun {
    /// The number of runs before it that changed the mesh.
    std::size_t n_changes_before = 0;
    std::vector<LoggedRefusal> refusals;
  };

  /// A run of a pass that takes time for each intersecting pair and left nearly all of them, or
  /// that has changed nothing in a heap of faces.
  struct CostlyIdleRun {
    std::size_t n_pairs = 0;
    std::vector<LoggedRefusal> refusals;
  };

  /// The defective elements of the mesh that the last plan has left.
  struct KnownInventory {
    std::weak_ptr<const RepairState> state;
    DefectInventory inventory;
  };

  /// What is known from the runs of passes until now.
  struct RunMemory {
    /// The operations applied since the checkpoint.
    std::vector<AppliedOperation> applied;
    /// The operations that are not tried again, and the rule that they broke: what else is repaired
    /// hardly changes that.
    std::map<OperationHash, Rejection> hopeless;
    /// By the name of the pass, in order.
    std::map<std::string_view, std::vector<CostlyIdleRun>> costly_idle_runs;
  };

  /// What some passes make of the input, from which trials start.
  struct StartFromInput {
    /// The names of the passes; those of one name are the same in all trials of a repair.
    std::vector<std::string_view> names;
    Checkpoint made;
    RunMemory memory;
    std::vector<std::uint8_t> fixed_vertices;
  };

  /// Lists the defective elements of the mesh as its file will hold it.
  [[nodiscard]] DefectInventory inventory() const;
  /// Tells whether the mesh is still the one that the last plan has left.
  [[nodiscard]] bool is_inventory_known() const {
    return known_ && known_->state.lock() == mesh_.shared_state();
  }
  /// Notes what rises() compares with, before the first change.
  void note_input(const DefectInventory& inventory);
  void set_checkpoint();
  /// Runs passes on the input, or returns to what they have made of it last.
  void start_from_input(const std::vector<PlannedPass>& plan);
  /// Runs the plan from the checkpoint, with more and more operations banned, until the mesh is not
  /// worse than it was there.
  ///
  /// @return  The defective elements of the result; nothing if nothing was changed.
  std::optional<DefectInventory> run_stage(const std::vector<PlannedPass>& plan,
                                           const StageGate& gate);
  /// Tells whether another stage is to try what the last one has banned.
  [[nodiscard]] bool is_worth_trying_banned() const;
  /// @return  False if the rounds were given up, because more faces intersect than before and no
  ///          fewer than a round ago.
  [[nodiscard]] bool run_rounds(const std::vector<PlannedPass>& plan, bool may_be_given_up = false);
  /// Runs a pass, unless it changed nothing when it ran last and nothing has changed since, or next
  /// to nothing if it would take long.
  ///
  /// @param n_changes  The number of runs that changed the mesh.
  /// @param idle_run   The last run of the pass that changed nothing.
  void run_unless_idle(const PlannedPass& pass, std::size_t& n_changes,
                       std::optional<IdleRun>& idle_run);
  /// Returns the number of intersecting pairs.
  [[nodiscard]] std::size_t n_pairs() const { return mesh_.prepared().intersecting_pairs().size(); }
  /// Tells whether so many faces intersect for each that little can be repaired.
  [[nodiscard]] bool is_heap() const;
  void note_costly_idle_run(const PlannedPass& pass, CostlyIdleRun idle_run);
  /// Asks whether to stop; once the answer is yes, it stays so.
  bool is_to_stop();
  bool run(const PlannedPass& pass);
  /// Runs a pass for one of its lengths until it proposes nothing more that is accepted.
  ///
  /// @param refused  Receives what it has refused last.
  /// @return         Whether it has changed the mesh.
  bool run_at(const PlannedPass& pass, double length, RefusedInState& refused);
  /// Returns the length that a pass goes on with after another one.
  [[nodiscard]] std::optional<double> length_after(const PlannedPass& pass, double length);
  [[nodiscard]] PassInput input_of_pass(OperationSize size, double length);
  /// Applies the operations that are accepted, and tells whether there were any.
  bool apply_accepted(const PlannedPass& pass, const Edits& edits, ProposedBefore& before);
  /// Leaves out the operations that are banned, or known to be rejected.
  void skip_known(const PlannedPass& pass, ProposedBefore& before, Proposal& proposal);
  /// Leaves out the operations of which which_overflow() tells.
  void skip_overflowing(const PlannedPass& pass, ProposedBefore& before, Proposal& proposal);
  void skip_rejected(const PlannedPass& pass, const Acceptance& acceptance, ProposedBefore& before,
                     Proposal& proposal);
  /// Notes the operations that are kept.
  void record(const PlannedPass& pass, Proposal proposal, const MeasuredMesh::Trial& trial);
  /// Bans operations that are responsible for a worse mesh; more of them with each attempt.
  void ban(const DefectInventory& before, const DefectInventory& after, const Worsening& worsening,
           std::size_t attempt);
  /// Returns to the checkpoint; banned operations stay banned.
  void restart();
  /// Returns to the input, and keeps the checkpoint.
  void return_to_input();
  /// Tells whether an operation that broke this rule is not tried again.
  [[nodiscard]] bool is_hopeless_after(Rejection rejection) const;

  MeasuredMesh mesh_;
  RepairLimits limits_;
  FixedVertices fixed_;
  DriverSettings settings_;
  PassMemory memory_;
  bool is_stopped_ = false;
  RepairLog log_;
  /// The vertices that a pass has changed since it began with a length, by key.
  std::vector<Index> changed_vertices_;
  BannedOperations banned_;
  RunMemory runs_;
  /// The state from which the present stage has started; nothing if that is the input.
  std::optional<Checkpoint> checkpoint_;
  std::optional<StartFromInput> start_;
  /// The inventory of the input without its elements, once a plan or trial was run.
  std::optional<DefectInventory> input_counts_;
  std::optional<KnownInventory> known_;
};

}  // namespace meshalyzer
