#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "meshalyzer/repair/split/internal/incident_faces.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to split_edges(): the edges with more than two faces, and the pairing of these faces.

/// The edges of a file with more than two faces. An incidence is one of these faces at one of these
/// edges.
struct EdgeIncidences {
  /// #edges: the two file vertices of each, the smaller first; ascending.
  std::vector<std::array<Index, 2>> ends;
  /// #edges + 1: where the incidences of each edge begin.
  std::vector<Index> begin{0};
  /// #incidences: the file face of each, ascending within an edge.
  std::vector<Index> faces;
  /// #incidences.
  std::vector<Index> edge_of;

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::size_t n_faces(std::size_t edge) const {
    return begin[edge + 1] - begin[edge];
  }
  /// Returns the number of the edge between two vertices, which must be in this list.
  [[nodiscard]] std::size_t edge_between(Index a, Index b) const;
};

[[nodiscard]] EdgeIncidences list_incidences(const CutMesh& cut);

/// Returns the vertices at the ends of these edges, ascending.
[[nodiscard]] std::vector<Index> ends_of_edges(const EdgeIncidences& incidences);

/// Pairs the incidences of each edge as pair_round_edge() does. Where sheets were cut, all
/// components with a border are equally open.
///
/// A chain of edges runs from one to the next at vertices where two of them meet and each face
/// continues from one to the other through its fan. It is paired as one of its edges requires: one
/// where orientations alternate, if any; of several the longest, then the first.
///
/// @param mesh      Has the vertices of tracked.soup, and may have more faces.
/// @param incident  The faces at the vertices of ends_of_edges().
/// @return       #incidences: the incidence of the same edge that each is joined to, or kNoIndex.
[[nodiscard]] std::vector<Index> pair_incidences(const TrackedMesh& tracked,
                                                 const PreparedMesh& mesh,
                                                 const EdgeIncidences& incidences,
                                                 const IncidentFaces& incident);

}  // namespace meshalyzer
