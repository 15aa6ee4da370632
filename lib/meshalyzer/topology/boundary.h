#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Tells how a boundary ends.
enum class BoundaryShape : std::uint8_t {
  /// The boundary comes back to its first edge.
  Loop,
  /// The boundary begins and ends at non-manifold edges.
  Chain,
};

/// One boundary of the complex: border edges, each followed by the next one of the same fan.
struct BoundaryLoop {
  /// Inner half-edges of the border edges in walking order. The walk runs along the half-edge of
  /// its lowest border edge; where it hops across flipped edges the faces beside it are turned, and
  /// so half-edges of the loop may run against the walk. A loop begins with its lowest border edge,
  /// a chain with one of its ends.
  std::vector<HalfedgeHandle> halfedges;
  BoundaryShape shape = BoundaryShape::Loop;
};

/// Finds the boundaries of a complex.
///
/// A boundary consists of border edges (edges with exactly one face). At a vertex it goes on along
/// the other border edge of the same fan, a fan being faces joined through two-face edges,
/// whichever way they are oriented. Where the fan ends at a non-manifold edge instead, so does the
/// boundary: it is a chain, and counts as one.
///
/// So two sheets that touch at a vertex have a boundary each, while two holes of one sheet that
/// touch there have one together: it passes the vertex twice.
///
/// @return     In order of their lowest border edge, in the order of find_border_edges(); every
///             border edge is in exactly one of them. A closed complex has none.
/// @complexity O(#E + #B log #B), #B the number of border edges.
[[nodiscard]] std::vector<BoundaryLoop> find_boundary_loops(const CutMesh& cut);

}  // namespace meshalyzer
