#pragma once

#include "meshalyzer/base/progress.h"
#include "meshalyzer/repair/driver/deviation.h"
#include "meshalyzer/repair/driver/internal/acceptance.h"
#include "meshalyzer/repair/driver/internal/plan.h"
#include "meshalyzer/repair/driver/internal/repair_state.h"
#include "meshalyzer/repair/driver/repair_log.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <vector>

namespace meshalyzer {

/// Repairs a mesh: runs passes, applies what they propose to a copy, and keeps the operations that
/// are accepted.
class RepairDriver {
 public:
  /// Finds the vertices of a tracked mesh that must stay where they are; see
  /// RepairLimits::fixed_vertices.
  using FixedVertices =
      std::function<std::vector<std::uint8_t>(const TrackedMesh& tracked, const CutMesh& cut)>;

  /// @param limits  The limits without fixed vertices.
  /// @param fixed   Called before each round, because what was a border may be none any more.
  RepairDriver(Soup input, const Tolerances& tolerances, RepairLimits limits, FixedVertices fixed);

  [[nodiscard]] const TrackedMesh& tracked() const { return state_->tracked(); }
  [[nodiscard]] const PreparedMesh& mesh() const { return state_->mesh(); }
  /// Returns an upper bound of the distance between the input and the tracked mesh, hole patches
  /// left out.
  [[nodiscard]] double deviation() const { return deviation_; }

  /// Runs the passes in order, each until it proposes nothing more that is accepted, and starts
  /// over until no pass changes anything.
  ///
  /// @param options  Who hears of the progress, and who may stop it.
  void run_plan(const std::vector<PlannedPass>& plan, const RepairOptions& options);

  /// Runs a pass once and applies all that it proposes without checking it, because the user asks
  /// for it by name.
  void apply_unchecked(const PlannedPass& pass);

  /// Tells whether run_plan() was stopped.
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

  [[nodiscard]] RepairLog take_log() { return std::move(log_); }

 private:
  /// The keys of the elements that an operation changes, which identify it when it is proposed
  /// again.
  using Signature = std::vector<Index>;

  /// Asks whether to stop; once it is so it stays so.
  bool is_to_stop();
  bool run(const PlannedPass& pass);
  [[nodiscard]] PassResult propose(const PlannedPass& pass, OperationSize size) const;
  /// Applies the operations that are accepted, and tells whether there were any.
  bool apply_accepted(const PlannedPass& pass, const Edits& edits, std::set<Signature>& rejected);
  /// Lets later edits lie on the hole patches that these edits have added.
  void include_patches(const Edits& edits);
  [[nodiscard]] std::vector<Signature> signatures(const Edits& edits) const;
  void log_refusals(const PlannedPass& pass, const std::vector<Refusal>& refused);
  void log_rejection(const PlannedPass& pass, const Signature& signature, Rejection rejection);

  Soup input_;
  Tolerances tolerances_;
  RepairLimits limits_;
  FixedVertices fixed_;
  DeviationMeter meter_;
  std::unique_ptr<const RepairState> state_;
  double deviation_ = 0.0;
  std::function<bool()> wants_to_stop_;
  bool is_stopped_ = false;
  RepairLog log_;
};

}  // namespace meshalyzer
