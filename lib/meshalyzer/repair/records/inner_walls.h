#pragma once

#include "meshalyzer/repair/facets/working_mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Faces on the same three vertices.
struct EqualFaces {
  /// Ascending.
  std::vector<Index> faces;
  /// One a face: non-zero where it faces the same way as the first.
  std::vector<std::uint8_t> is_like_first;

  /// Whether as many face one way as the other.
  [[nodiscard]] bool cancel_out() const;
};

/// Tells of each set whether it is part of a wall between touching solids: sets that cancel out,
/// joined through edges, round which the rest of the mesh is closed without them. At each edge of
/// the wall there are two other faces, which cross it in opposite directions, or none, and not none
/// everywhere.
///
/// @return #sets, the wall each is part of, from 0; kNoIndex for those that are of none.
[[nodiscard]] std::vector<Index> find_inner_walls(const WorkingMesh& mesh,
                                                  std::span<const EqualFaces> sets);

/// Whether a face crosses the edge from a to b in this direction.
[[nodiscard]] bool crosses(const Triangle& t, Index a, Index b);

}  // namespace meshalyzer
