#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/topology/components.h"

#include <span>

namespace meshalyzer {

/// What analyze_solids() needs to be found before; only refers to it.
struct SolidsInput {
  const CutMesh& cut;
  /// Over the faces of `cut`.
  const FaceTree& tree;
  const Components& components;
  /// The intersecting pairs of the mesh: components that cross do not enclose each other.
  std::span<const IntersectingPair> pairs;
};

/// Decides for every closed, manifold, consistent component whether it points outward, measures its
/// volume, and finds which component directly encloses each.
///
/// A component points outward when its volume is positive and an even number of others enclose it,
/// or negative and an odd number do; both are decided exactly. One that encloses no volume has no
/// answer; one whose volume is too large for a double has no volume.
///
/// @param analyses  One a component, with their counts, attributes and boxes; receives the answers.
void analyze_solids(const SolidsInput& input, std::vector<ComponentAnalysis>& analyses);

}  // namespace meshalyzer
