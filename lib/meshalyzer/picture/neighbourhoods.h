#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the picture module: what to show of a big mesh as it is.

/// Where a walk over faces begins, the most important first. May name an element more than once.
struct Seeds {
  /// Of those that can be drawn.
  std::vector<Index> faces;
  std::vector<Index> vertices;
};

/// The faces round the seeds: their faces, then ring by ring the faces that share a vertex with
/// what is there already, each ring as far round every seed as round any other, until there are
/// `max_faces` or no more. Of the last ring what fits, that of the first seeds first.
///
/// @param drawable  The faces to walk on, ascending.
/// @return          Ascending.
/// @complexity      O(#V + #F).
[[nodiscard]] std::vector<Index> faces_round(const Soup& soup, std::span<const Index> drawable,
                                             const Seeds& seeds, std::size_t max_faces);

}  // namespace meshalyzer
