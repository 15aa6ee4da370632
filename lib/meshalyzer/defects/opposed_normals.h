#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <compare>
#include <vector>

namespace meshalyzer {

/// A normal that the file gives at a vertex; both are record indices.
struct GivenNormal {
  Index vertex;
  Index normal;

  friend auto operator<=>(const GivenNormal&, const GivenNormal&) = default;
};

/// Returns the given normals that are opposed to all faces of non-zero area at their vertex, of
/// which there must be at least one, in ascending order. The answer is exact.
///
/// @complexity O(#F).
[[nodiscard]] std::vector<GivenNormal> opposed_normals(const PreparedMesh& mesh);

}  // namespace meshalyzer
