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
  /// The nodes inside their edges, ascending, each once.
  std::span<const EdgeNode> edge_nodes;
};

/// Numbers the vertices and the pieces.
///
/// A node at the position of input vertices becomes the lowest of these, unless one of them is used
/// by uncut triangles; there is at most one such vertex, since triangles that meet there without
/// sharing it intersect. Other vertices at the same position are no longer used.
[[nodiscard]] Arrangement assemble(const ArrangementParts& parts, Nodes nodes);

}  // namespace meshalyzer
