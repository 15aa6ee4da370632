#pragma once

#include "meshalyzer/repair/driver/internal/changed_faces.h"
#include "meshalyzer/repair/edits/edits.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to DeviationMeter.

/// Removes faces of the input that are walls as a whole.
///
/// @complexity  O((#faces + #walls) log #faces).
void drop_walls(const Soup& input, std::span<const InteriorWall> walls,
                std::vector<ChangedFace>& faces);

}  // namespace meshalyzer
