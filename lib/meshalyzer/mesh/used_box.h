#pragma once

#include "meshalyzer/mesh/soup.h"

namespace meshalyzer {

/// Returns the box of the vertices that faces of the complex use; it is empty if there are none.
///
/// @complexity O(#F).
[[nodiscard]] Box3 used_box(const Soup& soup);

/// Returns the longest side of this box; 0 if it is empty.
[[nodiscard]] double used_extent(const Soup& soup);

}  // namespace meshalyzer
