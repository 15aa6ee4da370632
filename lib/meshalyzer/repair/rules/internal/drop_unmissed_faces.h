#pragma once

#include "meshalyzer/repair/pass.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Proposes to drop each of some sets of faces that are not missed (see InteriorWall), as an
/// operation of its own. A set that meets a vertex that must stay in place is refused.
///
/// @param code  The code of the defect that is repaired so.
[[nodiscard]] PassResult drop_unmissed_faces(const PassInput& input,
                                             std::span<const std::vector<Index>> sets,
                                             DefectCode code);

}  // namespace meshalyzer
