#pragma once

#include "meshalyzer/repair/driver/internal/changed_faces.h"

#include <vector>

namespace meshalyzer {

/// Removes faces of zero area that lie on an edge of another one of the faces: they are nowhere
/// farther from a surface than that face. Where a fan of collinear points makes n such faces along
/// one edge, measuring each of them from the n faces that they become would take O(n^3).
///
/// @param soup  The mesh of the faces.
/// @complexity  O(n log n) for n faces.
void drop_covered_segments(const Soup& soup, std::vector<ChangedFace>& faces);

}  // namespace meshalyzer
