#pragma once

#include "meshalyzer/arrangement/arrangement.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// The vertices of an arrangement, rounded to doubles.
struct RoundedVertices {
  /// The positions of the vertices of the arrangement, and of further ones that were added.
  std::vector<Vec3> positions;
  /// #vertices of the arrangement: the vertex that replaces each, which may be an added one.
  std::vector<Index> stands_for;
};

/// Returns the point of a grid of this spacing, with a point at the origin, that is nearest to a
/// position.
[[nodiscard]] Vec3 nearest_on_grid(const Vec3& position, double spacing);

/// Returns the spacing of a grid: a power of two, about the extent divided by two to the power of
/// `bits`, but at most a share of the maximum deviation; 0 if there is no such grid.
[[nodiscard]] double grid_spacing(int bits, double extent, double max_deviation);

/// The parameters of rounding in one round of cutting.
struct Rounding {
  /// The spacing of the grid; 0 for the nearest doubles.
  double spacing = 0.0;
  /// Vertices of lower index are never snapped to the grid.
  Index first_to_snap = 0;
};

/// The largest number of rounds in which a soup is cut and rounded.
inline constexpr std::size_t kRoundingRounds = 14;

/// The quantities on which the grids of the rounds depend.
struct RoundingLimits {
  /// The longest side of the box of the soup as it was before all rounds.
  double extent = 0.0;
  /// Vertices move by at most a share of it.
  double max_deviation = 0.0;
  /// The number of vertices of the soup before all rounds.
  Index n_input_vertices = 0;
};

/// Returns the rounding of a round: first to the nearest doubles, then to grids that become
/// coarser.
///
/// @param round  The number of the round, below kRoundingRounds.
[[nodiscard]] Rounding rounding_of_round(std::size_t round, const RoundingLimits& limits);

/// Rounds the new vertices, and merges those that have come to the same position.
///
/// Vertices of cut faces are rounded to the nearest point of the grid, together with all vertices
/// in the same cell, even those of uncut faces (Valque and Lazard, Removing self-intersections of a
/// triangle mesh with vertex snapping). A closed surface stays closed, since each vertex goes to
/// one position. A vertex that would move is replaced by an added one.
[[nodiscard]] RoundedVertices round_vertices(const Arrangement& arrangement,
                                             const Rounding& rounding);

}  // namespace meshalyzer
