#pragma once

#include "meshalyzer/repair/replace/internal/new_surface.h"

#include <span>

namespace meshalyzer {

/// Gives faces a second side and moves both apart: a closed, consistently oriented surface that
/// goes round the faces once, whatever they are, also where they are one-sided. Round an edge each
/// side is joined to the side that faces it; borders get a rim.
///
/// Where the faces bend sharply, or cross, parts of it may cross.
///
/// @param faces      Of the complex, no two with the same vertices.
/// @param thickness  How far the two sides of a flat sheet are apart.
/// @complexity       O(n log n).
[[nodiscard]] NewSurface thicken(const Soup& soup, std::span<const Index> faces, double thickness);

}  // namespace meshalyzer
