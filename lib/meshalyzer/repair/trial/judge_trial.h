#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/trial/deviation.h"
#include "meshalyzer/repair/trial/repair_state.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Why an operation must not be made.
enum class Harm : std::uint8_t {
  None,
  /// The surface would be farther from what it was than it may.
  TooFar,
  /// Faces would intersect that did not, nor any other faces of the operation in their stead.
  Intersects,
  /// It would make more flaws of a kind than it takes away.
  MoreDefects,
};

/// A reason for a log: "it would ..."
[[nodiscard]] std::string_view harm_reason(Harm harm);

/// What a change is measured by. Only refers.
struct TrialRules {
  const Soup& input;
  /// Of the input.
  const DeviationMeter& meter;
  double max_deviation = 0.0;
  /// Flaws that the pass may make, for others to mend; with self-intersection: contact of faces
  /// that were cut apart and still are at one place.
  DefectCodes may_make;
};

struct Verdict {
  /// #operations.
  std::vector<Harm> harms;
  /// See DeviationMeter::Result::largest.
  double deviation = 0.0;

  [[nodiscard]] bool is_harmless() const;
};

/// Judges what a list of edits has done, operation by operation.
///
/// What cannot be laid to any operation is laid to all. What is wrong with faces that no operation
/// touches was accepted before.
[[nodiscard]] Verdict judge_trial(const RepairState& before, const RepairState& after,
                                  const Touched& touched, std::size_t n_operations,
                                  const TrialRules& rules);

}  // namespace meshalyzer
