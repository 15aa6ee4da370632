#pragma once

#include "meshalyzer/repair/driver/options.h"
#include "meshalyzer/repair/pass.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The frequency with which a pass is run.
enum class Repeat : std::uint8_t {
  /// The pass runs until it proposes nothing more, and again when others have changed the mesh.
  UntilDone,
  /// The pass runs once in each round, and once for smaller operations if some were rejected: it
  /// proposes all that it can at a time.
  OncePerRound,
  /// The pass runs once only.
  Once,
};

/// A pass of a plan.
struct PlannedPass {
  /// The name for logs: "mend facets", ...
  std::string_view name;
  /// The code of the defect that it repairs.
  DefectCode code = DefectCode::Corrupt;
  PassFunction run;
  /// The defects that it may create, see AcceptanceRules.
  DefectCodes may_create = {};
  Repeat repeat = Repeat::UntilDone;
  /// Tells whether it takes a time that grows with the number of intersecting pairs.
  bool takes_time_for_pairs = false;
  /// Tells whether its operations are rejected that leave as many intersecting pairs and border
  /// edges as there were.
  bool must_mend = false;
  /// The lengths over which the pass works; empty if it has none.
  PassLengths lengths = {};
};

/// Returns the passes that a repair needs, in the order in which they help each other: first those
/// that make the complex complete, then those for facets, borders and topology, then orientation,
/// which hole filling needs, and last those that depend on the result.
[[nodiscard]] std::vector<PlannedPass> plan_passes(const RepairOptions& options,
                                                   const Tolerances& tolerances);

/// Returns the pass that joins what touches and cannot be parted, if that is to be repaired.
[[nodiscard]] std::vector<PlannedPass> plan_to_join_contacts(const RepairOptions& options);

/// Returns the passes of plan_passes(), and after them that of plan_to_join_contacts().
[[nodiscard]] std::vector<PlannedPass> plan_with_contacts_joined(const RepairOptions& options,
                                                                 const Tolerances& tolerances);

/// Returns those of the passes of plan_passes() that repair defects, with sheets cut too.
[[nodiscard]] std::vector<PlannedPass> plan_with_sheets_cut(const RepairOptions& options,
                                                            const Tolerances& tolerances);

/// Returns those of the passes of plan_passes() that come before intersections are cut and contacts
/// parted.
[[nodiscard]] std::vector<PlannedPass> plan_before_cutting(const RepairOptions& options,
                                                           const Tolerances& tolerances);

/// Returns those passes that come before a contour of the input: those that join and orient faces.
/// Others would use up a part of the deviation for facets and holes that the contour has not.
[[nodiscard]] std::vector<PlannedPass> plan_before_contour(const RepairOptions& options,
                                                           const Tolerances& tolerances);

/// Returns the passes for a mesh of which parts were replaced by closed surfaces.
[[nodiscard]] std::vector<PlannedPass> plan_after_replacement(const RepairOptions& options);

/// Returns the passes for the flat and degenerate facets that all other passes have left, if these
/// are to be repaired. They come last, because what they move by a tolerance is no longer where
/// other surfaces are.
[[nodiscard]] std::vector<PlannedPass> plan_for_remaining_facets(const RepairOptions& options);

/// Returns the passes for the facets and foldovers that plan_for_remaining_facets() leaves, in
/// walls thinner than the tolerance: these become as thick as that.
[[nodiscard]] std::vector<PlannedPass> plan_for_thin_walls(const RepairOptions& options);

}  // namespace meshalyzer
