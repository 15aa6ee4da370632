#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Tells what an edge of the cut mesh is in the file's complex.
enum class EdgeKind : std::uint8_t {
  /// Two faces that cross it in opposite directions: the only kind with two faces in the cut mesh.
  Inner,
  /// Exactly one face.
  Border,
  /// One of two faces that cross it in the same direction.
  Flipped,
  /// One of more than two faces.
  NonManifold,
};

/// Tells for each edge of the cut mesh what it is in the file's complex.
///
/// @return     #mesh edges, by EdgeHandle::idx(). An edge of the complex that was cut is as many
///             mesh edges as it has faces.
/// @complexity O(#E).
[[nodiscard]] std::vector<EdgeKind> classify_edges(const CutMesh& cut);

/// Counts the distinct unordered pairs of file vertices that bound a face.
///
/// @complexity O(1): what cutting added is taken off again.
[[nodiscard]] std::size_t n_edges(const CutMesh& cut);

/// Counts the edges of the complex at each file vertex.
///
/// @return     #file vertices; 0 for a vertex that no face of the complex uses.
/// @complexity O(#V + #E).
[[nodiscard]] std::vector<Index> vertex_valences(const CutMesh& cut);

/// Returns the file vertices that a half-edge runs from and to, in this order.
[[nodiscard]] std::array<Index, 2> file_ends(const CutMesh& cut, HalfedgeHandle halfedge);

}  // namespace meshalyzer
