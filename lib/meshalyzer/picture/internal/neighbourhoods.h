#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// The elements where a walk over faces begins, the most important first. An element may come more
/// than once.
struct Seeds {
  /// The faces, all of which can be drawn.
  std::vector<Index> faces;
  std::vector<Index> vertices;
};

/// Collects the faces round seeds: first those of the seeds themselves, then ring by ring the faces
/// that share a vertex with collected ones, until there are `max_faces` or no more. All seeds have
/// the same number of rings; if the last ring does not fit, the first seeds come first.
///
/// @param drawable  The faces to walk on, ascending.
/// @return          The faces, ascending.
/// @complexity      O(#V + #F).
[[nodiscard]] std::vector<Index> faces_round(const Soup& soup, std::span<const Index> drawable,
                                             const Seeds& seeds, std::size_t max_faces);

}  // namespace meshalyzer
