#pragma once

#include "meshalyzer/repair/driver/options.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "meshalyzer/repair/pass.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Finds the vertices that a repair must leave in place: those of intended borders and, if groups
/// are faces of a body, those on edges between faces of different groups.
///
/// @param cut  The cut mesh of `tracked`.
/// @return By vertex key, or empty if there are none; see RepairLimits::fixed_vertices.
[[nodiscard]] std::vector<std::uint8_t> find_fixed_vertices(const TrackedMesh& tracked,
                                                            const CutMesh& cut,
                                                            const RepairOptions& options);

/// Tells whether a vertex may get copies: a vertex on the border of a face of a body may not.
[[nodiscard]] inline bool may_be_copied(const PassInput& input, Index vertex) {
  return input.limits.groups != Groups::Faces || !input.limits.is_fixed(input.tracked, vertex);
}

}  // namespace meshalyzer
