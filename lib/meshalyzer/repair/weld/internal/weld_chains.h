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
  /// The vertices of the chain, at least three, from the one near the edge's end to the one near
  /// its start: faces on the other side of a crack run against the edge.
  std::vector<Index> vertices;
  /// The face of its first edge.
  Index face = 0;
  /// The length within which its vertices are from the edge.
  double reach = 0.0;
};

/// Returns the crack between an edge and the chain along it.
[[nodiscard]] WeldCrack crack_along(std::span<const WeldEdge> edges, const WeldChain& chain);

/// Finds the edges along which a chain runs, with all of its vertices within reach of the edge and
/// only the first and last within reach of its ends. An edge with several chains has none.
///
/// Growing reaches are tried up to that of the points, and the shortest for which an edge has a
/// chain counts: a long one would take whole edges for nothing and find several chains where there
/// is one.
///
/// @param wanted  The edges to search for, ascending: those of `mesh.at_places`.
/// @return        The cracks in order of reach, then of their edges.
[[nodiscard]] std::vector<WeldChain> find_weld_chains(const NearEdges& mesh,
                                                      std::span<const Index> wanted);

}  // namespace meshalyzer
