#pragma once

#include "meshalyzer/arrangement/arrangement.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// The vertices of an arrangement at places that are doubles.
struct RoundedVertices {
  std::vector<Vec3> positions;
  /// #positions: the vertex that stands for each: the lowest of those of cut faces that have come
  /// to one place.
  std::vector<Index> stands_for;
};

/// Rounds the vertices that were made.
///
/// @param round  How often rounding has made faces intersect: after some rounds it is coarser, so
/// that points that are nearly one become one.
[[nodiscard]] RoundedVertices round_vertices(const Arrangement& arrangement, std::size_t round);

}  // namespace meshalyzer
