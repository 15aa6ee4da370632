#pragma once

#include "meshalyzer/base/progress.h"
#include "meshalyzer/repair/trial/deviation.h"
#include "meshalyzer/repair/trial/judge_trial.h"
#include "meshalyzer/repair/trial/plan.h"
#include "meshalyzer/repair/trial/repair_log.h"
#include "meshalyzer/repair/trial/repair_state.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <vector>

namespace meshalyzer {

/// Where a mesh is repaired: asks passes for changes, tries them, and keeps those that do no harm.
class Workshop {
 public:
  /// The vertices of a draft that must stay where they are, by key, see RepairLimits.
  using FixedVertices =
      std::function<std::vector<std::uint8_t>(const Draft& draft, const CutMesh& cut)>;

  /// @param limits  Without fixed vertices.
  /// @param fixed   Asked again before each round: what was a border may be none any more.
  Workshop(Soup input, const Tolerances& tolerances, RepairLimits limits, FixedVertices fixed);

  [[nodiscard]] const Draft& draft() const { return state_->draft(); }
  [[nodiscard]] const PreparedMesh& mesh() const { return state_->mesh(); }
  /// An upper bound of the distance between the input and the draft, hole patches left out.
  [[nodiscard]] double deviation() const { return deviation_; }

  /// Runs the passes in order, each until it proposes nothing more that may be done, all over
  /// again until none changes anything.
  void work_off(const std::vector<PlannedPass>& plan, const PhaseListener& on_phase);

  /// Makes all that a pass proposes once, whatever it does to the mesh: what a user asks for by
  /// name.
  void obey(const PlannedPass& pass);

  [[nodiscard]] RepairLog take_log() { return std::move(log_); }

 private:
  /// What an operation works on, to know it again when it is proposed anew.
  using Signature = std::vector<Index>;

  bool run(const PlannedPass& pass);
  [[nodiscard]] PassResult ask(const PlannedPass& pass, std::size_t most_steps) const;
  /// Makes those of the changes that do no harm.
  bool try_edits(const PlannedPass& pass, const Edits& edits, std::set<Signature>& harmful);
  /// What later edits make of hole patches may lie on them.
  void lay_patches(const Edits& edits);
  [[nodiscard]] std::vector<Signature> signatures(const Edits& edits) const;
  void log_refusals(const PlannedPass& pass, const std::vector<Refusal>& refused);
  void log_harm(const PlannedPass& pass, const Signature& signature, Harm harm);

  Soup input_;
  Tolerances tolerances_;
  RepairLimits limits_;
  FixedVertices fixed_;
  DeviationMeter meter_;
  std::unique_ptr<const RepairState> state_;
  double deviation_ = 0.0;
  RepairLog log_;
};

}  // namespace meshalyzer
