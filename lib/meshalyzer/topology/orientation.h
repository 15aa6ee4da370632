#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Tells whether faces can be turned so that no two-face edge is crossed twice in the same
/// direction.
struct Orientability {
  /// Tells whether all components can; true for an empty mesh.
  bool orientable = true;
  /// #edge components: 1 where its faces can be given a consistent orientation, else 0.
  std::vector<std::uint8_t> of_component;
};

/// Tells of each edge component whether its faces can be given a consistent orientation.
///
/// Every edge with two faces asks that they agree; edges with more than two faces ask nothing.
/// The orientation that the file gives does not matter: turning faces never changes the answer.
///
/// @param edge_components  As find_edge_components() returns them for the same mesh.
/// @complexity             O(#edge components) where no edge is flipped, else O(#E log #F).
[[nodiscard]] Orientability find_orientability(const CutMesh& cut,
                                               const Components& edge_components);

}  // namespace meshalyzer
