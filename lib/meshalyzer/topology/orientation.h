#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The answer whether faces can be reversed so that no edge with two faces is crossed twice in the
/// same direction.
struct Orientability {
  /// Tells whether this holds for all components; true for an empty mesh.
  bool orientable = true;
  /// #edge components: 1 where the faces can be given a consistent orientation, else 0.
  std::vector<std::uint8_t> of_component;
};

/// Tells of each edge component whether its faces can be given a consistent orientation.
///
/// Every edge with two faces demands that they agree; edges with more than two faces demand
/// nothing. The orientation in the file does not matter: reversing faces never changes the answer.
///
/// @param edge_components  The result of find_edge_components() for the same mesh.
/// @complexity             O(#edge components) where no edge is flipped, else O(#E log #F).
[[nodiscard]] Orientability find_orientability(const CutMesh& cut,
                                               const Components& edge_components);

}  // namespace meshalyzer
