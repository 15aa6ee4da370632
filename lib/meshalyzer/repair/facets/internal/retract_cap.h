#pragma once

#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <cstdint>

namespace meshalyzer {

/// The gain that removing a cap must bring.
enum class RetractGain : std::uint8_t {
  /// The step must leave fewer thin faces.
  FewerThin,
  /// The step must leave fewer thin faces, or as many and a shorter edge between two of them.
  FewerThinOrShorter,
};

/// Removes a cap, a flat face whose apex lies almost on its longest edge: the edge is bent to run
/// through the apex, the face is dropped, and each other face at the edge is split there.
///
/// With one other face this is an edge flip; with none, at a border, the face is dropped; with
/// several, all are split. An end of the edge goes if it has three faces, since two of them would
/// come to have the same corners; all of a tetrahedron goes. The parts of a split face belong to
/// its group. Else the topology is preserved, no normal is turned over, and nothing moves farther
/// than the height of the cap, or of the end that goes.
[[nodiscard]] MendAttempt retract_cap(const WorkingMesh& mesh, const MendRules& rules, Index cap,
                                      RetractGain gain);

}  // namespace meshalyzer
