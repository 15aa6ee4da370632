#pragma once

#include "meshalyzer/repair/fix_defects.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The vertices that a repair must leave where they are: those of borders that are meant, and those
/// on edges between faces of different groups where groups are faces of a body.
///
/// @param cut  Of the draft.
/// @return By vertex key, or empty where there are none; see RepairLimits::fixed_vertices.
[[nodiscard]] std::vector<std::uint8_t> find_fixed_vertices(const Draft& draft, const CutMesh& cut,
                                                            const RepairOptions& options);

}  // namespace meshalyzer
