#pragma once

#include "meshalyzer/boolean/combine_solids.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// The vertices of a difference that were moved away from the subtracted solids.
struct PartedVertices {
  /// The moved vertices of the result, ascending; `positions` has their new positions.
  std::vector<Index> vertices;
  std::vector<Vec3> positions;
  /// The largest distance by which a vertex has moved.
  double largest_move = 0.0;
  /// The number of pairs of faces, one of the result and one of the others, that still have a point
  /// in common.
  std::size_t n_pairs_left = 0;
  /// The faces of the others that are in the way, ascending: those that the result still meets, and
  /// those on which vertices lay whose move makes faces of the result intersect.
  std::vector<Index> blocking;
};

/// Moves the result of a difference away from the subtracted solids, which it touches. Each vertex
/// of a common wall moves in a direction that leaves all walls there, by the smallest step after
/// which no faces have a point in common, exactly; steps grow from a few units in the last place.
///
/// @param operands  The operands of the difference: the first without all others. The difference
///   may have faces with higher origins, of pads that were subtracted too.
/// @param others    The other operands as they are now, possibly moved slightly themselves.
/// @param max_move  The largest distance by which a vertex may move.
/// @throws InvalidArgument  if that is no length: negative or not finite.
/// @return          The moved vertices, which are the same for any number of threads.
/// @complexity      A few times that of find_intersections().
[[nodiscard]] PartedVertices part_from(const CombinedSolid& difference, const Operands& operands,
                                       const Soup& others, double max_move);

}  // namespace meshalyzer
