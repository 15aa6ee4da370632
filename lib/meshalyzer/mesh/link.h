#pragma once

#include "meshalyzer/mesh/corners.h"
#include "meshalyzer/mesh/fans.h"
#include "meshalyzer/mesh/tri_mesh.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// The edges of a cut mesh, numbered in order of their lowest side.
struct EdgeNumbers {
  /// #corners: the half-edge of each side. The half-edge of an edge's lowest side is twice the
  /// edge's number.
  std::vector<Index> halfedge;
  /// The edges with one side, ascending; their border half-edge is the odd one.
  std::vector<Index> border_edges;
  std::size_t n_edges = 0;
};

/// Numbers the edges, those with two sides and those with one.
///
/// @param opposite  As in EdgePairs; its memory is reused for the result.
/// @complexity      O(#F).
[[nodiscard]] EdgeNumbers number_edges(std::vector<Index> opposite);

/// Makes the half-edge mesh of a cut complex, in bulk.
///
/// @param positions  #file vertices.
/// @throws InvalidArgument if the mesh would have more elements than OpenMesh's handles can number.
/// @complexity       O(#V + #F).
[[nodiscard]] TriMesh link_mesh(const Complex& complex, std::span<const Vec3> positions,
                                const EdgeNumbers& edges, const Fans& fans);

}  // namespace meshalyzer
