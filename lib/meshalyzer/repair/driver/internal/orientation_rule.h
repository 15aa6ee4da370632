#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

namespace meshalyzer {

// What an operation may not do, part two: turn a face over.

/// Tells whether a face that is moved still faces the same side, and keeps an area. The answer is
/// exact, for the projection along the axis that shows the face before best.
///
/// @return  True for a face that has no area before.
[[nodiscard]] bool keeps_orientation(const Corners& before, const Corners& after);

}  // namespace meshalyzer
