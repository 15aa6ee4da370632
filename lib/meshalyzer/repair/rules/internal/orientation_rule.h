#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

namespace meshalyzer {

// The second rule for operations: an operation may not turn a face over.

/// Tells whether a moved face still faces the same side and keeps a positive area. The answer is
/// exact, for the projection along the axis that shows the face before best.
///
/// @return  True for a face that had no area before.
[[nodiscard]] bool keeps_orientation(const Corners& before, const Corners& after);

}  // namespace meshalyzer
