#pragma once

#include "meshalyzer/mesh/soup.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the faces whose boxes share a point with one of some boxes.
///
/// For a few boxes this takes a small part of the time that a tree over all faces takes.
///
/// @param boxes  The boxes, of which empty ones are ignored. They may be infinite.
/// @return       Faces of the complex (see is_in_complex()), by index, ascending; the same for any
///               number of threads.
/// @complexity   O(n log n + #F log n) for n boxes that are spread out.
[[nodiscard]] std::vector<Index> find_faces_near(const Soup& soup, std::span<const Box3> boxes);

}  // namespace meshalyzer
