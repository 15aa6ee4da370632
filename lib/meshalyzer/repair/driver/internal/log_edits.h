#pragma once

#include "meshalyzer/repair/driver/repair_log.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/internal/affected_elements.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <cstdint>
#include <span>
#include <string>

namespace meshalyzer {

/// Edits that were applied. This holds references only.
struct MadeEdits {
  const TrackedMesh& before;
  const Edits& edits;
  /// #operations, as apply_edits() takes them.
  std::span<const std::uint8_t> skipped;
  const TrackedMesh& after;
  /// The result of find_affected_elements().
  const AffectedElements& affected;
};

/// Adds the changes of a pass to a log: to its last step if that is of the same pass, else as a new
/// step.
void log_edits(const std::string& pass, DefectCode code, const MadeEdits& made, RepairLog& log);

}  // namespace meshalyzer
