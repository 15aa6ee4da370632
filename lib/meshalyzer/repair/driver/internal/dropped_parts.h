#pragma once

#include "meshalyzer/repair/driver/repair_log.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Appends a sentence for each part of the input that was dropped as a whole, with its area:
/// copies, walls that divide a solid, fragments that enclose nothing, and open parts that went with
/// the walls inside solids.
///
/// @param repaired  What the log has made of the input.
void append_dropped_parts(const Soup& input, const TrackedMesh& repaired, const RepairLog& log,
                          std::vector<std::string>& notes);

}  // namespace meshalyzer
