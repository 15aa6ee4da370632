#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/mesh/tri_mesh.h"

namespace meshalyzer {

/// Tells whether no position is NaN or infinite, as of every mesh that was read from a file. Of a
/// mesh with such a position only its records and its connectivity can be examined.
///
/// @complexity O(#V).
[[nodiscard]] bool has_finite_positions(const Soup& soup);

/// Refuses a mesh with a position that is not finite.
///
/// @throws InvalidArgument  if it has one.
void require_finite_positions(const Soup& soup);
void require_finite_positions(const TriMesh& mesh);

}  // namespace meshalyzer
