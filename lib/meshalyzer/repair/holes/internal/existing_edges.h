#pragma once

#include "meshalyzer/repair/holes/internal/hole_loop.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The edges of a mesh between vertices of hole loops. A patch must not have one of them as an
/// inner edge, or it would get more than two faces.
class ExistingEdges {
 public:
  /// @complexity O(#V + #E + n log n), n the number of such edges.
  ExistingEdges(const PreparedMesh& mesh, std::span<const HoleLoop> loops);

  /// Tells whether the mesh has an edge between two vertices, each of which is on a loop.
  ///
  /// @complexity O(log n).
  [[nodiscard]] bool contains(Index a, Index b) const;

 private:
  /// Both vertices in one number, the smaller first; ascending.
  std::vector<std::uint64_t> edges_;
};

}  // namespace meshalyzer
