#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/mesh/side_table.h"

#include <functional>
#include <span>

namespace meshalyzer {

/// Lists edges of the complex by file vertices and faces.
///
/// @param edges   One half-edge of the cut mesh for each edge.
/// @param values  One value for each edge, or empty.
/// @return        The edges, ascending by file vertices, each with all its faces, even if the mesh
///                is cut along it.
[[nodiscard]] EdgeList list_edges(const CutMesh& cut, std::span<const HalfedgeHandle> edges,
                                  std::span<const double> values = {});

/// Lists edges of the side table by file vertices and faces.
[[nodiscard]] EdgeList list_cut_edges(const CutMesh& cut, const CutEdges& edges);

/// Returns the edges whose value satisfies a condition.
[[nodiscard]] EdgeList list_edges_if(const CutMesh& cut, std::span<const HalfedgeHandle> edges,
                                     std::span<const double> values,
                                     const std::function<bool(double)>& condition);

}  // namespace meshalyzer
