#pragma once

#include "meshalyzer/arrangement/triangulation.h"

#include <array>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// An edge of a triangulation that is part of the border of a face.
struct BorderEdge {
  /// The two vertices of the triangulation, the lower first.
  std::array<Index, 2> ends{};
  Index face = kNoIndex;

  friend auto operator<=>(const BorderEdge&, const BorderEdge&) = default;
};

/// The faces that cover each triangle of a triangulation.
struct PlaneCover {
  /// #triangles: the index in `sets` of the faces that cover each.
  std::vector<Index> set_of;
  /// The different sets of faces, each ascending.
  std::vector<std::vector<Index>> sets;

  [[nodiscard]] std::span<const Index> of(std::size_t triangle) const {
    return sets[set_of[triangle]];
  }
};

/// Finds the cover from outside inwards: crossing the border of a face enters or leaves it.
///
/// @param borders  The whole border of each face, in any order. All their edges are constrained.
[[nodiscard]] PlaneCover cover_by_borders(const Triangulation& triangulation,
                                          std::vector<BorderEdge> borders);

}  // namespace meshalyzer
