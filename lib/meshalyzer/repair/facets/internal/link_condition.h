#pragma once

#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <array>
#include <cstdint>

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

/// Tells whether merging `gone` into its neighbour `kept` preserves the topology of the complex.
/// This is the link condition for complexes that need not be manifold (Dey, Edelsbrunner, Guha and
/// Nekhayev 1999, "Topology preserving edge contraction"), on the safe side if `gone` is a Corner.
///
/// @param step  Receives the facts that the answer relies on.
[[nodiscard]] bool may_merge(const WorkingMesh& mesh, Index gone, Index kept, MendStep& step);

}  // namespace meshalyzer
