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
  /// The face of the soup that it is a part of; of several that cover it the first that faces the
  /// same way.
  Index face = kNoIndex;
  /// Tells whether the solid is in front of the piece, so that it must be turned over.
  bool is_turned = false;
};

/// The result of a boolean operation before anything is rounded.
struct ExactSolid {
  Arrangement arrangement;
  /// In order of the pieces.
  std::vector<BoundaryPiece> boundary;
};

/// A soup, and what is known of it. Only refers.
struct IntersectingSoup {
  const Soup& soup;
  const CutMesh& cut;
  /// Over the faces of `cut`.
  const FaceTree& tree;
  /// All that intersect.
  std::span<const IntersectingPair> pairs;
};

/// Cuts a soup along its intersections, and keeps the boundary of the cells that are inside by the
/// rule, exactly.
///
/// @param input       Of faces with an area, which cross every edge equally often in both
/// directions,
///                    operand by operand.
/// @param operand_of  #faces, each below n_operands.
[[nodiscard]] ExactSolid find_exact_solid(const IntersectingSoup& input,
                                          std::span<const Index> operand_of, std::size_t n_operands,
                                          const InsideRule& rule);

}  // namespace meshalyzer
