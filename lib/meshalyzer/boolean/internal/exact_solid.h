#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/boolean/inside_rule.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// A piece of the boundary of a solid.
struct BoundaryPiece {
  Index piece = kNoIndex;
  /// The face of the soup that it is a part of; if several cover it, the first with the same
  /// orientation.
  Index face = kNoIndex;
  /// Tells whether the solid is in front of the piece, so that it must be reversed.
  bool is_turned = false;
};

/// The result of a boolean operation before anything is rounded.
struct ExactSolid {
  Arrangement arrangement;
  /// The pieces of the boundary, in their order in the arrangement.
  std::vector<BoundaryPiece> boundary;
};

/// A soup with its cut mesh, tree and intersecting pairs. It only refers to them.
struct IntersectingSoup {
  const Soup& soup;
  const CutMesh& cut;
  /// The tree over the faces of `cut`.
  const FaceTree& tree;
  /// All intersecting pairs.
  std::span<const IntersectingPair> pairs;
};

/// Cuts a soup exactly along its intersections, and keeps the boundary of the cells that are inside
/// by the rule.
///
/// @param input       The soup. Its faces have an area, and those of each operand cross every edge
///     equally often in both directions.
/// @param operand_of  #faces, each below n_operands.
[[nodiscard]] ExactSolid find_exact_solid(const IntersectingSoup& input,
                                          std::span<const Index> operand_of, std::size_t n_operands,
                                          const InsideRule& rule);

}  // namespace meshalyzer
