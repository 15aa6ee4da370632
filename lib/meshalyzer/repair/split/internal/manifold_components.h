#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// The manifold components of a complex: its parts between edges with more than two faces.
struct ManifoldComponents {
  /// #mesh faces: the component of each; faces joined through edges with two, whichever way
  /// oriented.
  std::vector<Index> of_face;
  /// For each component, the share of border edges among the edges of its rim; 0 where it has no
  /// rim.
  std::vector<double> openness;
};

/// @complexity O(#E log #F) time, near linear in practice.
[[nodiscard]] ManifoldComponents find_manifold_components(const CutMesh& cut);

}  // namespace meshalyzer
