#pragma once

#include "meshalyzer/repair/holes/internal/patch_check.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// The directed edges of a patch, by their two vertices.
class PatchEdges {
 public:
  /// @complexity  O(n log n) for n triangles.
  explicit PatchEdges(const Patch& patch);

  /// Returns the face of the patch that runs along an edge in this direction, or kNoIndex.
  [[nodiscard]] Index face_at(const std::array<Index, 2>& ends) const;

 private:
  struct DirectedEdge {
    std::array<Index, 2> ends;
    Index face = 0;

    friend bool operator<(const DirectedEdge& a, const DirectedEdge& b) { return a.ends < b.ends; }
  };

  /// Ascending.
  std::vector<DirectedEdge> edges_;
};

}  // namespace meshalyzer
