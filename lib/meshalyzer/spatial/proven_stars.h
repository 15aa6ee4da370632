#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Finds vertices whose faces surely do not intersect, so that no pair of faces that has such a
/// vertex in common needs a test.
///
/// Most vertices of most meshes are proven. Vertices with copies and the ends of cut edges never
/// are.
///
/// @return #file vertices: 1 if proven, else 0.
/// @complexity O(#F).
[[nodiscard]] std::vector<std::uint8_t> prove_stars(const CutMesh& cut);

}  // namespace meshalyzer
