#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>

namespace meshalyzer::bench {

/// Damages a closed mesh in `n` places that are spread evenly over its faces: in turn a face is
/// taken out, turned, or given twice, an edge is split next to its end, a face next to the middle
/// of an edge, a face gets vertices of its own, an orphan is added, and a face record that names a
/// vertex twice.
///
/// @param n  At most a fiftieth of the faces, so that places are apart.
[[nodiscard]] Soup damaged(Soup soup, std::size_t n);

}  // namespace meshalyzer::bench
