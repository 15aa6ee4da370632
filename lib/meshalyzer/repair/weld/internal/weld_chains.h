#pragma once

#include "meshalyzer/repair/weld/internal/weld_cracks.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): cracks between a long edge and several short ones.

/// A border edge, and the chain of border edges that lies along it: a crack with T-junctions.
struct WeldChain {
  /// The long edge, by number.
  Index edge = 0;
  /// Vertices of the chain, three at least, from the one near the edge's end to the one near its
  /// start: faces on the other side of a crack run against the edge.
  std::vector<Index> vertices;
  /// The face of its first edge.
  Index face = 0;
  /// Tells how far from the edge they may be.
  double reach = 0.0;
};

/// Returns the crack between an edge and the chain along it.
[[nodiscard]] WeldCrack crack_along(std::span<const WeldEdge> edges, const WeldChain& chain);

/// Finds the edges along which a chain runs, all of its vertices within reach of the edge and only
/// the first and last within that of its ends. An edge with several chains has none.
///
/// What counts is the shortest reach, of a few steps up to that of the points, for which an edge
/// has any: a long one takes whole edges for nothing and finds several ways where there is one.
///
/// @param wanted  Which edges to look at, ascending: those of `mesh.at_places`.
/// @return        In order of reach, then of their edges.
[[nodiscard]] std::vector<WeldChain> find_weld_chains(const NearEdges& mesh,
                                                      std::span<const Index> wanted);

}  // namespace meshalyzer
