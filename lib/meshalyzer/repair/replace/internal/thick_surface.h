#pragma once

#include "meshalyzer/repair/replace/internal/new_surface.h"

#include <span>

namespace meshalyzer {

/// Gives faces a second side and moves both apart: a closed, consistently oriented surface that
/// goes round the faces once, whatever they are, also where they are one-sided. Round an edge each
/// side is joined to the side that faces it; borders get a rim. Where several sharp bends meet, a
/// vertex that is common to all of them lies on the wrong side of some faces: of those, separable
/// ones are joined to each other only, where they can be.
///
/// Where the faces bend sharply, or cross, parts of it may cross.
///
/// @param faces      Of the complex, no two with the same vertices.
/// @param thickness  How far the two sides of a flat sheet are apart.
/// @param separable  Ascending; faces that need not be joined to the others.
/// @complexity       O(n log n), again each time that faces were found which are not joined.
[[nodiscard]] NewSurface thicken(const Soup& soup, std::span<const Index> faces, double thickness,
                                 std::span<const Index> separable = {});

}  // namespace meshalyzer
