#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/mesh/side_table.h"

#include <functional>
#include <span>

namespace meshalyzer {

/// Lists edges of the complex by file vertices and faces.
///
/// @param edges   Any half-edge of the cut mesh for each edge, at most one an edge.
/// @param values  One an edge, or empty.
/// @return        Ascending by file vertices; each edge with all its faces, also where the mesh is
/// cut along it.
[[nodiscard]] EdgeList list_edges(const CutMesh& cut, std::span<const HalfedgeHandle> edges,
                                  std::span<const double> values = {});

/// Returns the same for edges that the side table lists.
[[nodiscard]] EdgeList list_cut_edges(const CutMesh& cut, const CutEdges& edges);

/// Returns the edges whose value satisfies a condition.
[[nodiscard]] EdgeList list_edges_if(const CutMesh& cut, std::span<const HalfedgeHandle> edges,
                                     std::span<const double> values,
                                     const std::function<bool(double)>& condition);

}  // namespace meshalyzer
