#pragma once

#include "meshalyzer/arrangement/cut_cluster.h"

namespace meshalyzer {

/// Returns the faces of the complex that have no area, ascending.
[[nodiscard]] std::vector<Index> find_flat_faces(const Soup& soup);

/// Returns the edges of the given faces, the lower vertex first, ascending, each once.
[[nodiscard]] std::vector<VertexPair> edges_of_faces(const Soup& soup,
                                                     std::span<const Index> faces);

/// Returns the nodes inside the edges of the faces of no area that have contacts.
[[nodiscard]] std::vector<EdgeNode> find_edge_nodes(std::span<const FaceSimplex> simplices,
                                                    const FaceContacts& contacts,
                                                    const NamedPoints& points, const Nodes& nodes);

/// Triangulates a face of no area, given by the closed walk along its border: its corners and the
/// nodes between them. Parts that the walk follows back and forth are removed first, so that often
/// nothing is left. The triangles fill the rest, so that the edges of its neighbours still match.
///
/// @param walk  The vertices of the walk.
/// @return      The triangles, which have no area.
[[nodiscard]] std::vector<Triangle> fill_flat_walk(std::vector<Index> walk);

}  // namespace meshalyzer
