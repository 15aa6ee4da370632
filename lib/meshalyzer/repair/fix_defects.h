#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/repair/driver/defect_counts.h"
#include "meshalyzer/repair/driver/options.h"
#include "meshalyzer/repair/driver/patch_outcome.h"
#include "meshalyzer/repair/driver/repair_log.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace meshalyzer {

/// A mesh that a repair has produced.
struct RepairedMesh {
  TrackedMesh tracked;
  /// The defects that it still has.
  DefectReport remaining;
  /// The data prepared for the mesh, if RepairOptions::keep_prepared asks for it and the mesh is
  /// the one that the passes have left, neither separated nor renumbered; else null.
  std::shared_ptr<const PreparedMesh> prepared;
};

struct RepairResult {
  /// The defects of the input.
  DefectReport before;
  /// One mesh or, if disjoint is to be fixed, one for each component, see separate().
  std::vector<RepairedMesh> meshes;
  RepairLog log;
  /// The maximum deviation, and an upper bound of the measured one, in the mesh's unit. Hole
  /// patches do not count, nor do surfaces that later passes make of them and of their
  /// surroundings.
  double max_deviation = 0.0;
  double deviation = 0.0;
  /// Tells whether the repair was stopped early, so that more might be repaired.
  bool is_stopped = false;
  /// Notes for the user about the repair, in sentences.
  std::vector<std::string> notes;
  /// The counts that are higher than before: a count rises only if a graver one has fallen that
  /// could not fall otherwise ("Never worse" in doc/repair.md).
  std::vector<CountRise> rises;
  /// The outcome for each listed self-intersection of the input, if RepairOptions::reports_patches
  /// asks for it.
  std::vector<PatchOutcome> patches;
};

/// Repairs a mesh as far as possible within a maximum deviation, and reports the remaining defects
/// (doc/repair.md).
///
/// Sound parts of the mesh stay bit for bit. Repairing the result again changes nothing, but in the
/// cases that doc/repair.md names, where work is limited. The result is never worse than the input,
/// see RepairResult::rises.
///
/// @throws InvalidArgument  as resolve_tolerances(), length_of() and build(); if
/// RepairOptions::weld_within is no length; and if a position, or FillOptions::at, is not finite.
[[nodiscard]] RepairResult fix_defects(Soup soup, const RepairOptions& options = {});

}  // namespace meshalyzer
