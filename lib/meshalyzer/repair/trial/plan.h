#pragma once

#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/repair/pass.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// How often a pass is asked.
enum class Repeat : std::uint8_t {
  /// Until it proposes nothing more, and again when others have changed something.
  UntilDone,
  /// Once in all.
  Once,
};

/// A pass of a plan.
struct PlannedPass {
  /// For logs: "mend facets", ...
  std::string_view name;
  /// What it treats.
  DefectCode code = DefectCode::Corrupt;
  PassFunction run;
  /// See TrialRules.
  DefectCodes may_make = {};
  Repeat repeat = Repeat::UntilDone;
};

/// The passes that a repair needs, in the order in which they help each other: first what makes
/// the complex whole, then its facets, borders, and topology, then its orientation, which holes
/// need, then what hangs on the result.
///
/// @param tolerances  Must outlive the plan.
[[nodiscard]] std::vector<PlannedPass> plan_passes(const RepairOptions& options,
                                                   const Tolerances& tolerances);

}  // namespace meshalyzer
