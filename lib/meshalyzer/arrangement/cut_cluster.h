#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/arrangement/clusters.h"
#include "meshalyzer/arrangement/nodes.h"

#include <array>
#include <span>
#include <vector>

namespace meshalyzer {

/// A node inside an edge of a face.
struct EdgeNode {
  /// The edge's vertices, the lower first.
  VertexPair edge{};
  Index node = kNoIndex;

  friend auto operator<=>(const EdgeNode&, const EdgeNode&) = default;
};

/// The pieces that the faces of a cluster are cut into.
struct ClusterPieces {
  /// The nodes of each triangle.
  std::vector<std::array<Index, 3>> triangles;
  /// #triangles + 1: where the sources of each begin in `sources`. The first has the sign 1.
  std::vector<Index> source_begin{0};
  std::vector<PieceSource> sources;
  /// The edges on the cluster's segments, by their nodes, the lower first.
  std::vector<std::array<Index, 2>> curves;
  /// The nodes inside the edges that the faces have in common with faces of no area.
  std::vector<EdgeNode> edge_nodes;
};

/// The input of the cutting of a cluster. It only refers to it.
struct CuttingScene {
  std::span<const FaceSimplex> simplices;
  const NamedPoints& points;
  const Nodes& nodes;
  /// The edges of faces of no area, the lower vertex first, ascending.
  std::span<const VertexPair> flat_edges;
};

/// Triangulates the faces of a cluster with all points and segments in them.
///
/// @param nodes  The nodes in the faces, including their corners, ascending, each once.
/// @return       At least #nodes - 2 triangles.
[[nodiscard]] ClusterPieces cut_cluster(const CuttingScene& scene, const FaceCluster& cluster,
                                        std::span<const Index> nodes);

}  // namespace meshalyzer
