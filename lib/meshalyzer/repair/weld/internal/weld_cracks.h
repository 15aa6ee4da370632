#pragma once

#include "meshalyzer/repair/weld/internal/weld_candidates.h"

#include <array>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): cracks whose sides have vertices that do not face each other.

/// A border edge that gets vertices of the other side of a crack.
struct EdgeSplit {
  /// The edge, by number.
  Index edge = 0;
  /// The vertices, from the edge's start to its end.
  std::vector<Index> inner;
};

/// A crack between two chains of border edges that have no vertices in common except their ends.
struct WeldCrack {
  /// The vertices of the chains that are to be joined at both ends of the crack.
  std::array<std::array<Index, 2>, 2> ends{};
  std::vector<EdgeSplit> splits;
  /// All vertices of both chains.
  std::vector<Index> vertices;
  /// The faces along both chains that take part in closing it.
  std::vector<Index> faces;
};

/// Finds the cracks both sides of which have inner vertices: walks along both chains from a place
/// where they meet to the next one, and assigns each vertex on the way to the edge on the other
/// side that it is within reach of.
///
/// @param wanted  The edges to look at, ascending: those of `mesh.at_places`.
/// @return        The cracks in the order of their first edges. They may overlap.
[[nodiscard]] std::vector<WeldCrack> find_interleaved_cracks(const NearEdges& mesh,
                                                             std::span<const Index> wanted);

}  // namespace meshalyzer
