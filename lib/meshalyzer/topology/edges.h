#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The kind of an edge of the cut mesh in the file's complex.
enum class EdgeKind : std::uint8_t {
  /// The edge has two faces that cross it in opposite directions. Only this kind has two faces in
  /// the cut mesh.
  Inner,
  /// The edge has exactly one face.
  Border,
  /// The edge has two faces that cross it in the same direction; the mesh edge belongs to one of
  /// them.
  Flipped,
  /// The edge has more than two faces; the mesh edge belongs to one of them.
  NonManifold,
};

/// Classifies each edge of the cut mesh by its kind in the file's complex.
///
/// @return     #mesh edges: the kinds, indexed by EdgeHandle::idx(). A cut edge of the complex is
///             as many mesh edges as it has faces.
/// @complexity O(#E).
[[nodiscard]] std::vector<EdgeKind> classify_edges(const CutMesh& cut);

/// Counts the distinct unordered pairs of file vertices that bound a face.
///
/// @complexity O(1): the edges that cutting added are subtracted.
[[nodiscard]] std::size_t n_edges(const CutMesh& cut);

/// Counts the edges of the complex at each file vertex.
///
/// @return     #file vertices: the counts, 0 for a vertex that no face of the complex uses.
/// @complexity O(#V + #E).
[[nodiscard]] std::vector<Index> vertex_valences(const CutMesh& cut);

/// Returns the file vertices that a half-edge runs from and to, in this order.
[[nodiscard]] std::array<Index, 2> file_ends(const CutMesh& cut, HalfedgeHandle halfedge);

/// Returns the file vertices at the ends of an edge, the smaller first, as lists of edges have
/// them.
[[nodiscard]] std::array<Index, 2> ascending_file_ends(const CutMesh& cut, HalfedgeHandle halfedge);

}  // namespace meshalyzer
