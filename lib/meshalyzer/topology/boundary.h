#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The two shapes of a boundary.
enum class BoundaryShape : std::uint8_t {
  /// The boundary comes back to its first edge.
  Loop,
  /// The boundary begins and ends at non-manifold edges.
  Chain,
};

/// One boundary of the complex: a sequence of border edges, each followed by the next one of the
/// same fan.
struct BoundaryLoop {
  /// The inner half-edges of the border edges in walking order. The walk runs along the half-edge
  /// of its lowest border edge; beyond flipped edges the faces are turned, so that half-edges may
  /// run against the walk. A loop begins with its lowest border edge, a chain with one of its ends.
  std::span<const HalfedgeHandle> halfedges;
  BoundaryShape shape = BoundaryShape::Loop;
};

/// A list of boundaries, stored in one array: a mesh may have a million short ones.
struct BoundaryLoops {
  /// #boundaries + 1: where each boundary's half-edges begin in `halfedges`.
  std::vector<Index> begin{0};
  std::vector<HalfedgeHandle> halfedges;
  std::vector<BoundaryShape> shapes;

  [[nodiscard]] std::size_t size() const { return shapes.size(); }
  [[nodiscard]] bool empty() const { return shapes.empty(); }
  [[nodiscard]] BoundaryLoop operator[](std::size_t i) const {
    return {std::span(halfedges).subspan(begin[i], begin[i + 1] - begin[i]), shapes[i]};
  }
};

/// Finds the boundaries of a complex.
///
/// A boundary consists of border edges (edges with exactly one face). At a vertex it goes on along
/// the other border edge of the same fan, a fan being faces joined through two-face edges,
/// whichever way they are oriented. Where the fan ends at a non-manifold edge instead, so does the
/// boundary: it is a chain, and counts as one.
///
/// So two sheets that touch at a vertex have one boundary each, whereas two holes of one sheet that
/// touch at a vertex have one boundary together, which passes the vertex twice.
///
/// @return     The boundaries, ordered by their lowest border edge in the order of
///             find_border_edges(); every border edge is in exactly one of them. A closed complex
///             has none.
/// @complexity O(#E + #B log #B), #B the number of border edges.
[[nodiscard]] BoundaryLoops find_boundary_loops(const CutMesh& cut);

/// Does the same for a caller that has the border edges already.
///
/// @param border_edges  The result of find_border_edges().
[[nodiscard]] BoundaryLoops find_boundary_loops(const CutMesh& cut,
                                                std::span<const HalfedgeHandle> border_edges);

}  // namespace meshalyzer
