#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// The place where the numbering of records stops being 1, 2, ..., n.
struct NumberingBreak {
  /// Up to five ids in file order: that of the offending record and those of two neighbours on each
  /// side.
  std::vector<std::int64_t> ids;
  /// The index of the offending record's id in `ids`.
  std::size_t offender = 0;
};

/// A list of edges by their two file vertices (smaller first), each with all its faces, stored in
/// flat arrays.
struct EdgeList {
  /// #edges, ascending.
  std::vector<std::array<Index, 2>> ends;
  /// #edges + 1: where each edge's faces begin in `faces`.
  std::vector<Index> begin{0};
  /// The faces at each edge, ascending.
  std::vector<Index> faces;
  /// #edges: the measured value (a length, an angle in degrees) if the list has one; else empty.
  std::vector<double> values;

  [[nodiscard]] std::size_t size() const { return ends.size(); }
};

/// Faces with a measured value.
struct FaceList {
  std::vector<Index> faces;
  std::vector<double> values;
};

/// All offending elements, by index of their records in the file, in ascending order.
struct Offenders {
  EdgeList border_edges;
  EdgeList non_manifold_edges;
  EdgeList flipped_edges;
  std::vector<Index> non_manifold_vertices;
  /// The members of non_manifold_vertices that are on no non-manifold edge.
  std::vector<Index> pinched_vertices;
  /// The first of Characteristics::intersecting_pairs: at most MeshRequest::max_list.
  std::vector<IntersectingPair> intersecting_pairs;
  std::vector<Index> orphan_vertices;
  /// The ids of missing vertices; they have no record indices.
  std::vector<std::int64_t> missing_vertices;
  std::vector<Index> faces_with_missing_vertices;
  std::vector<Index> degenerate_faces;
  /// Records that repeat an id of an earlier record.
  std::vector<Index> duplicate_vertex_records;
  std::vector<Index> duplicate_face_records;
  /// The 1-based line numbers of torn lines.
  std::vector<std::int64_t> torn_lines;
  std::vector<Index> indistinguishable_vertices;
  EdgeList indistinguishable_edges;
  std::vector<Index> zero_area_faces;
  /// Faces with the same three vertices as an earlier face.
  std::vector<Index> duplicate_faces;
  std::optional<NumberingBreak> vertex_numbering;
  std::optional<NumberingBreak> face_numbering;
  /// The elements beyond the thresholds of MeshRequest. A list is present if its threshold is.
  std::optional<EdgeList> short_edges;
  std::optional<EdgeList> long_edges;
  std::optional<EdgeList> small_angles;
  std::optional<EdgeList> large_angles;
  std::optional<FaceList> large_aspect_ratios;
};

}  // namespace meshalyzer
