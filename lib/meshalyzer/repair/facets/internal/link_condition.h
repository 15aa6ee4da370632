#pragma once

#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The neighbourhood of a vertex in the complex.
enum class VertexKind : std::uint8_t {
  /// The vertex has one closed fan of faces.
  Plain,
  /// The vertex is on a curve of edges that do not have two faces, but all the same number: each
  /// fan runs from one of the vertex's two such edges to the other. On a border the number is 1.
  Ridge,
  /// The vertex is of no other kind.
  Corner,
};

struct VertexSurroundings {
  VertexKind kind = VertexKind::Corner;
  /// The neighbours along the curve, for a vertex on a Ridge.
  std::array<Index, 2> along{kNoIndex, kNoIndex};
};

/// @complexity  O(n log n) for n faces at the vertex.
[[nodiscard]] VertexSurroundings look_round(const WorkingMesh& mesh, Index vertex);

/// A vertex with three faces beside an edge: its neighbours are the ends of the edge and one more.
/// If the edge is collapsed, two of its faces come to have the same corners, in opposite
/// directions, so that all three go with it.
struct FinTip {
  Index tip;
  Index third_neighbour;
};

/// Returns the tips of fins at an edge.
///
/// @param step  Receives the facts that the answer relies on.
[[nodiscard]] std::vector<FinTip> fin_tips_at(const WorkingMesh& mesh, Index a, Index b,
                                              MendStep& step);

/// Tells whether merging `gone` into its neighbour `kept`, after a face has taken the place of each
/// fin at their edge, preserves the topology of the complex.
/// This is the link condition for complexes that need not be manifold (Dey, Edelsbrunner, Guha and
/// Nekhayev 1999, "Topology preserving edge contraction"), on the safe side if `gone` is a Corner.
///
/// @param fins  The result of fin_tips_at().
/// @param step  Receives the facts that the answer relies on.
[[nodiscard]] bool may_merge(const WorkingMesh& mesh, const std::array<Index, 2>& gone_and_kept,
                             const std::vector<FinTip>& fins, MendStep& step);

}  // namespace meshalyzer
