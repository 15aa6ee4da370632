#pragma once

#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <cstdint>

namespace meshalyzer {

/// What taking a cap away must bring.
enum class RetractGain : std::uint8_t {
  /// Fewer thin faces.
  FewerThin,
  /// The same, or as many and a shorter edge between two of them.
  FewerThinOrShorter,
};

/// Takes a cap away, a flat face whose apex lies almost on its longest edge: that edge is bent to
/// run through the apex, the face goes, and each other face at the edge is split there.
///
/// With one other face this is an edge flip; with none, at a border, the face is dropped; with
/// several, all are split. Splits are of the group of the face that was split. The topology stays,
/// no normal is turned over, and nothing moves farther than the cap is high.
[[nodiscard]] MendAttempt retract_cap(const WorkingMesh& mesh, const MendRules& rules, Index cap,
                                      RetractGain gain);

}  // namespace meshalyzer
