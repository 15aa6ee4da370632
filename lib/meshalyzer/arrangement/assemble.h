#pragma once

#include "meshalyzer/arrangement/cut_cluster.h"

namespace meshalyzer {

/// The parts that an arrangement is assembled from. It only refers to them.
struct ArrangementParts {
  const Soup& soup;
  std::span<const FaceSimplex> simplices;
  const NamedPoints& points;
  std::span<const ClusterPieces> clusters;
  /// The faces of no area, ascending.
  std::span<const Index> flat_faces;
  /// The nodes inside their edges. Ascending, each once.
  std::span<const EdgeNode> edge_nodes;
};

/// Numbers the vertices and the pieces.
///
/// A node where the input has vertices is the lowest of these, but one that triangles use which
/// were not cut goes before: there is at most one, since triangles that meet there without having
/// it in common intersect. Other vertices at the same place are used no longer.
[[nodiscard]] Arrangement assemble(const ArrangementParts& parts, Nodes nodes);

}  // namespace meshalyzer
