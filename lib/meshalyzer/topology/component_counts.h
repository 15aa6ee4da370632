#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/orientation.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// The results that count_by_component() needs, all of the same mesh; the struct only refers to
/// them.
struct ComponentCountsInput {
  /// The result of find_components().
  const Components& components;
  /// The result of find_edge_components().
  const Components& edge_components;
  /// The result of find_orientability().
  const Orientability& orientability;
  /// The result of find_boundary_loops().
  const BoundaryLoops& boundaries;
};

/// The topological counts of one component of a complex. They are indices, as a mesh with a million
/// components has a million of them.
struct ComponentCounts {
  /// The index of its lowest face record.
  Index first_face = kNoIndex;
  Index faces = 0;
  /// The number of file vertices that its faces use.
  Index vertices = 0;
  Index edges = 0;
  Index edge_components = 0;
  Index boundaries = 0;
  Index border_edges = 0;
  Index non_manifold_edges = 0;
  Index non_manifold_vertices = 0;
  Index flipped_edges = 0;
  /// Tells whether the faces of each of its edge components can be given a consistent orientation.
  bool orientable = true;
};

/// Counts the findings of this module by component.
///
/// @return     The counts of each component, in their order. Their sums are the counts of the mesh.
/// @complexity O(#V + #E).
[[nodiscard]] std::vector<ComponentCounts> count_by_component(const CutMesh& cut,
                                                              const ComponentCountsInput& input);

}  // namespace meshalyzer
