#pragma once

#include "meshalyzer/base/progress.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/repair/driver/deviation.h"
#include "meshalyzer/repair/driver/internal/acceptance.h"
#include "meshalyzer/repair/driver/internal/applied_operations.h"
#include "meshalyzer/repair/driver/internal/final_check.h"
#include "meshalyzer/repair/driver/internal/operation_names.h"
#include "meshalyzer/repair/driver/internal/plan.h"
#include "meshalyzer/repair/driver/internal/repair_state.h"
#include "meshalyzer/repair/driver/internal/worsening.h"
#include "meshalyzer/repair/driver/repair_log.h"

#include <algorithm>
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

/// Repairs a mesh: runs passes, applies their edits to a copy, and keeps the operations that are
/// accepted.
class RepairDriver {
 public:
  /// Finds the vertices of a tracked mesh that must stay where they are; see
  /// RepairLimits::fixed_vertices.
  using FixedVertices =
      std::function<std::vector<std::uint8_t>(const TrackedMesh& tracked, const CutMesh& cut)>;

  /// @param limits  The limits without fixed vertices.
  /// @param fixed   Called before each round, because a border may have been closed since.
  /// @param pairs   The limits of each search of the whole mesh for intersecting pairs; only the
  ///                first one is stopped by its function, which stops the repair too.
  RepairDriver(Soup input, const Tolerances& tolerances, RepairLimits limits, FixedVertices fixed,
               PairLimits pairs = {});

  [[nodiscard]] const TrackedMesh& tracked() const { return state_->tracked(); }
  /// Returns the mesh before all repairs.
  [[nodiscard]] const Soup& input() const { return input_; }
  [[nodiscard]] const PreparedMesh& mesh() const { return state_->mesh(); }
  /// Returns the mesh for use after the end of this driver.
  [[nodiscard]] std::shared_ptr<const PreparedMesh> shared_mesh() const {
    return {state_, &state_->mesh()};
  }
  /// Returns an upper bound of the distance between the input and the tracked mesh, hole patches
  /// left out. It is measured when it is asked for.
  [[nodiscard]] double deviation();
  /// Measures this distance even if it may be larger than the maximum, after a change that was
  /// applied unchecked; what that has lost counts too.
  double measure_deviation();

  /// Runs the passes in order, each until it proposes nothing more that is accepted, and starts
  /// over until no pass changes anything.
  ///
  /// If the resulting mesh is worse than the input, the responsible operations are banned, and all
  /// passes run again without them. Then they run once more from the result, with nothing banned,
  /// until no pass changes anything. If the repair is stopped while the mesh is worse, it returns
  /// to the mesh that it had before. If a plan was run before, the mesh that it has left takes the
  /// place of the input.
  ///
  /// @param options   The receiver of the progress, and the format that is written.
  /// @param on_worse  What happens if the mesh becomes worse.
  void run_plan(const std::vector<PlannedPass>& plan, const RepairOptions& options,
                OnWorse on_worse = OnWorse::TryAgain);

  /// Returns the counts that all plans have increased, all of which find_worsening() excepts.
  [[nodiscard]] const std::vector<CountRise>& rises() const { return rises_; }

  /// Runs a pass once and applies all its operations without checking them, because the user asks
  /// for it by name.
  void apply_unchecked(const PlannedPass& pass);

  /// A change that is tried, and undone if its result is not wanted.
  struct Trial {
    /// If there are any, the trial starts from the input with these passes.
    std::vector<PlannedPass> from_input = {};
    /// The pass that is then applied unchecked.
    PlannedPass change;
    /// The passes that run afterwards, as those of run_plan() do.
    std::vector<PlannedPass> plan;
    /// Tells whether the resulting mesh is kept.
    std::function<bool(const RepairState&)> is_wanted;
  };

  /// Tries a change, and undoes it if the resulting mesh is not wanted.
  ///
  /// @return Whether it was kept.
  bool run_trial(const Trial& trial);

  [[nodiscard]] const RepairState& state() const { return *state_; }
  /// Returns the log until now.
  [[nodiscard]] const RepairLog& log() const { return log_; }
  /// Measures parts of the input as DeviationMeter::measure_parts() does.
  [[nodiscard]] std::vector<double> measure_parts(std::span<const Index> part_of,
                                                  std::size_t n_parts) const;
  [[nodiscard]] double max_deviation() const { return limits_.max_deviation; }
  /// Returns the largest number of intersecting pairs that is searched for.
  [[nodiscard]] std::size_t max_pairs() const { return max_pairs_; }
  /// Notes a deviation that was measured outside.
  void raise_deviation(double deviation);
  /// Tells whether run_plan() was stopped.
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

  [[nodiscard]] RepairLog take_log() { return std::move(log_); }

 private:
  /// The operations that a pass proposes again, though they were rejected.
  struct ProposedBefore {
    /// Those that were rejected in this run of the pass.
    std::set<OperationSignature> rejected;
    /// Those that an earlier run has found to be hopeless.
    std::set<OperationSignature> hopeless;
  };

  /// The operations of a pass that were applied. This holds references only.
  struct MadeOperations {
    const PlannedPass& pass;
    const std::vector<OperationSite>& sites;
    std::span<const std::uint8_t> skipped;
    const AffectedElements& affected;
    const TrackedMesh& after;
  };

  /// The state that the result of a stage must not be worse than. This holds references only.
  struct StageGate {
    const FinalCheck& check;
    const DefectInventory& before;
    OnWorse on_worse;
  };

  /// The state from which a stage starts again.
  struct Checkpoint {
    TrackedMesh tracked;
    /// Its intersecting pairs, if all of them are known.
    std::optional<std::vector<IntersectingPair>> pairs;
    RepairLog log;
    double deviation = 0.0;
    bool is_within = true;
    std::vector<InteriorWall> walls;
    std::vector<Index> lost;
  };

  /// A run of a pass that changed nothing: it would change nothing again until the mesh changes.
  struct IdleRun {
    /// The number of runs before it that changed the mesh.
    std::size_t n_changes_before = 0;
    std::vector<LoggedRefusal> refusals;
  };

  /// The last run of a pass that takes time for each intersecting pair and left nearly all of them.
  struct CostlyIdleRun {
    std::size_t n_pairs = 0;
    std::vector<LoggedRefusal> refusals;
  };

  /// Finds the faces that a change that was applied unchecked has lost.
  void find_lost_faces();
  [[nodiscard]] double measure_without(std::span<const Index> lost) const;
  /// Measures the deviation if it is not known.
  void update_deviation();
  void set_checkpoint();
  /// Runs the plan from the checkpoint, with more and more operations banned, until the mesh is not
  /// worse than it was there.
  ///
  /// @return  The defective elements of the result; nothing if nothing was changed.
  std::optional<DefectInventory> run_stage(const std::vector<PlannedPass>& plan,
                                           const StageGate& gate);
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
  /// Returns the number of intersecting pairs if the pass takes time for them, else 0.
  [[nodiscard]] std::size_t n_pairs_for(const PlannedPass& pass) const;
  void note_costly_idle_run(const PlannedPass& pass, CostlyIdleRun idle_run);
  [[nodiscard]] std::shared_ptr<const RepairState> search_all(TrackedMesh tracked) const;
  /// Returns the intersecting pairs of the tracked mesh, if all of them are known.
  [[nodiscard]] std::optional<std::vector<IntersectingPair>> known_pairs() const;
  /// Asks whether to stop; once the answer is yes, it stays so.
  bool is_to_stop();
  bool run(const PlannedPass& pass);
  [[nodiscard]] PassResult propose(const PlannedPass& pass, OperationSize size) const;
  /// Applies the operations that are accepted, and tells whether there were any.
  bool apply_accepted(const PlannedPass& pass, const Edits& edits, ProposedBefore& before);
  /// Bans operations that are responsible for a worse mesh; more of them with each attempt.
  void ban(const DefectInventory& before, const DefectInventory& after, const Worsening& worsening,
           std::size_t attempt);
  /// Returns to the checkpoint; banned operations stay banned.
  void restart();
  /// Returns to the input, and keeps the checkpoint.
  void return_to_input();
  void restore(const Checkpoint& checkpoint);
  /// Tells whether an operation that broke this rule is not tried again.
  [[nodiscard]] bool is_hopeless_after(Rejection rejection) const;
  void record_applied(const MadeOperations& made);
  /// Returns the walls that are removed once the operations that are not skipped are applied.
  [[nodiscard]] std::vector<InteriorWall> walls_with(const Edits& edits,
                                                     std::span<const std::uint8_t> skipped) const;
  /// Lets later edits lie on the hole patches that these edits have added.
  void include_patches(const Edits& edits);

  Soup input_;
  Tolerances tolerances_;
  RepairLimits limits_;
  FixedVertices fixed_;
  std::optional<DeviationMeter> meter_;
  /// The parts of the surface that separated no inside from no outside and were removed.
  std::vector<InteriorWall> walls_;
  /// The faces of the input that a change that was applied unchecked has left beyond the maximum
  /// deviation, ascending. Whoever wanted that change judges them; no operation after it is
  /// rejected because of them.
  std::vector<Index> lost_;
  std::size_t max_pairs_;
  std::shared_ptr<const RepairState> state_;
  /// The deviation when it was last measured.
  double deviation_ = 0.0;
  bool is_deviation_known_ = true;
  /// Tells whether no face of the input that is not lost, and no face of the tracked mesh, is
  /// farther from the other than the maximum deviation. A change that was applied unchecked may
  /// have taken some farther.
  bool is_within_ = true;
  RepairListener on_progress_;
  StopQuery wants_to_stop_;
  bool is_stopped_ = false;
  RepairLog log_;
  std::vector<AppliedOperation> applied_;
  BannedOperations banned_;
  /// By the name of the pass.
  std::map<std::string_view, CostlyIdleRun> costly_idle_runs_;
  /// The operations that are not tried again, and the rule that they broke: what else is repaired
  /// hardly changes that.
  std::map<OperationHash, Rejection> hopeless_;
  /// The tracked mesh; nothing while it is the input.
  std::optional<Checkpoint> checkpoint_;
  /// The counts of the input, once a plan was run, and its intersecting pairs, if all are known.
  std::optional<DefectInventory> input_counts_;
  std::optional<std::vector<IntersectingPair>> input_pairs_;
  std::vector<CountRise> rises_;
};

}  // namespace meshalyzer
