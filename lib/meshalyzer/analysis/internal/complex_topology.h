#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/topology/component_counts.h"

#include <vector>

namespace meshalyzer {

/// The topology of a complex: everything that follows from which faces name which vertices.
struct ComplexTopology {
  /// The counts of each component.
  std::vector<ComponentCounts> counts;
  std::size_t n_edges = 0;
  std::size_t n_edge_components = 0;
  std::size_t n_boundaries = 0;
  bool orientable = true;
};

/// Analyses the topology of a complex.
///
/// @param offenders  Receives border, non-manifold and flipped edges, non-manifold and pinched
/// vertices, duplicate faces.
/// @complexity       Near O(#V + #F).
[[nodiscard]] ComplexTopology analyze_topology(const PreparedMesh& mesh, Offenders& offenders);

}  // namespace meshalyzer
