#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <array>
#include <optional>
#include <vector>

namespace meshalyzer {

// Private to the repair module: folds whose two layers have the same corners.

/// Two vertices that become one, by which faces on both sides of creases come to lie on each other.
struct LayerJoin {
  VertexHandle kept;
  VertexHandle merged;
  /// Pairs of faces on each other, which go: one of the kept vertex, and one of the merged.
  std::vector<std::array<FaceHandle, 2>> layers;
  /// The other faces of the merged vertex.
  std::vector<FaceHandle> changed;
};

/// Returns how the third corner of the face at a half-edge becomes that of the face on the other
/// side; nothing if they are one or have an edge, or if the surface would not be manifold.
///
/// All vertices of both faces must be inside the surface, see is_inner().
[[nodiscard]] std::optional<LayerJoin> join_layers_at(const TriMesh& mesh, HalfedgeHandle crease);

}  // namespace meshalyzer
