#pragma once

#include "meshalyzer/boolean/combine_solids.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// The result of a difference that was moved away from what was taken away.
struct PartedVertices {
  /// The vertices of the result that have moved, ascending, and where they are now.
  std::vector<Index> vertices;
  std::vector<Vec3> positions;
  /// Tells how far any of them has moved.
  double largest_move = 0.0;
  /// Tells how many pairs of faces, one of the result and one of the others, still have a point in
  /// common.
  std::size_t n_pairs_left = 0;
};

/// Moves the result of a difference away from what was taken away, which it touches: each vertex
/// of a common wall, in a direction before all walls there, by the smallest step after which no
/// faces have a point in common, exactly; steps grow from a few units in the last place.
///
/// @param operands  What was combined: the first without all others.
/// @param others    What the others are now: as they were, or moved by little themselves.
/// @param max_move  No vertex moves farther.
/// @return          The same for any number of threads.
/// @complexity      As find_intersections(), a few times.
[[nodiscard]] PartedVertices part_from(const CombinedSolid& difference, const Operands& operands,
                                       const Soup& others, double max_move);

}  // namespace meshalyzer
