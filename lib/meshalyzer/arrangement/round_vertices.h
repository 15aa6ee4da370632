#pragma once

#include "meshalyzer/arrangement/arrangement.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// The vertices of an arrangement at places that are doubles.
struct RoundedVertices {
  /// The positions of the vertices of the arrangement, and of further ones that were added.
  std::vector<Vec3> positions;
  /// #vertices of the arrangement: the vertex that stands for each, which may be an added one.
  std::vector<Index> stands_for;
};

/// Tells how vertices are rounded in one round of cutting.
struct Rounding {
  /// The distance of the grid's planes; 0 where the nearest doubles will do.
  double spacing = 0.0;
  /// Vertices of lower index are snapped to no grid, whatever the spacing.
  Index first_to_snap = 0;
};

/// Tells how often a soup is cut and rounded at most.
inline constexpr std::size_t kRoundingRounds = 14;

/// What the grids of the rounds depend on.
struct RoundingLimits {
  /// The longest side of the box of the soup as it was before all rounds.
  double extent = 0.0;
  /// Vertices move by a share of it at most.
  double max_deviation = 0.0;
  /// Tells how many vertices the soup had before all rounds.
  Index n_input_vertices = 0;
};

/// How a round rounds: first to the nearest doubles, then to grids that become coarser.
///
/// @param round  Below kRoundingRounds.
[[nodiscard]] Rounding rounding_of_round(std::size_t round, const RoundingLimits& limits);

/// Rounds the vertices that were made, so that those that have come to one place become one.
///
/// On a grid the vertices of cut faces are rounded to its nearest point, and with each all that are
/// in the same cell, also of faces that were not cut (Valque and Lazard, Removing
/// self-intersections of a triangle mesh with vertex snapping). The chain of all faces stays closed
/// where it was, since each vertex goes to one place. A vertex that would move is replaced by an
/// added one.
[[nodiscard]] RoundedVertices round_vertices(const Arrangement& arrangement,
                                             const Rounding& rounding);

}  // namespace meshalyzer
