#pragma once

#include "meshalyzer/arrangement/cut_cluster.h"

namespace meshalyzer {

/// Returns the faces of the complex that have no area. Ascending.
[[nodiscard]] std::vector<Index> find_flat_faces(const Soup& soup);

/// Returns the edges of these faces, the lower vertex first. Ascending, each once.
[[nodiscard]] std::vector<VertexPair> edges_of_faces(const Soup& soup,
                                                     std::span<const Index> faces);

/// Returns the nodes inside the edges of those faces of no area that take part in contacts.
[[nodiscard]] std::vector<EdgeNode> find_edge_nodes(std::span<const FaceSimplex> simplices,
                                                    const FaceContacts& contacts,
                                                    const NamedPoints& points, const Nodes& nodes);

/// Returns a face of no area, as the closed walk along its border: its corners, and what has come
/// to lie between them. Stretches that are walked forth and back at once are gone; so often nothing
/// is left. Its triangles fill what is, so that the edges of its neighbours still fit.
///
/// @param walk  Vertices.
/// @return      Triangles, of no area.
[[nodiscard]] std::vector<Triangle> fill_flat_walk(std::vector<Index> walk);

}  // namespace meshalyzer
