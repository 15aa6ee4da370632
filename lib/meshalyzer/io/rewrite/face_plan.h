#pragma once

#include "meshalyzer/io/rewrite/byte_edits.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The face records of a source. A polygon is one record and several triangles.
struct FaceRecords {
  /// The first triangle of each record, followed by the number of triangles.
  std::vector<Index> first_triangle{0};
  /// For each record, the last one of the run with the same statements (materials, groups); empty
  /// if no statement applies to faces.
  std::vector<Index> run_ends;

  /// Appends the record of a polygon, which append_fan() has made triangles.
  void append(std::size_t n_corners) {
    const std::size_t n_triangles = std::max<std::size_t>(n_corners, 3) - 2;
    first_triangle.push_back(first_triangle.back() + static_cast<Index>(n_triangles));
  }

  [[nodiscard]] std::size_t size() const { return first_triangle.size() - 1; }
  [[nodiscard]] std::size_t n_triangles(Index record) const {
    return first_triangle[record + 1] - first_triangle[record];
  }
  /// Returns the record to which a triangle of the source belongs.
  ///
  /// @complexity O(log #records).
  [[nodiscard]] Index record_of(Index triangle) const;
};

/// The triangle and corner that correspond to a corner of a record.
struct FanCorner {
  Index triangle;
  std::size_t corner;
};
[[nodiscard]] FanCorner fan_corner(const FaceRecords& records, Index record, std::size_t local);

/// Returns the number, in the order of the file, of a triangle's corner in its record.
[[nodiscard]] std::size_t local_corner(const FaceRecords& records, Index record, FanCorner corner);

/// What becomes of a face record of the source.
enum class RecordChange : std::uint8_t {
  /// All its triangles still exist and form one polygon, possibly with other vertices at its
  /// corners.
  Kept,
  /// All triangles of this polygon still exist with the same vertices, and all have been reversed.
  Turned,
  /// It is dropped, and its remaining triangles are written one by one.
  Dropped,
};

/// The placement of the faces of an edited mesh in its file.
struct FacePlan {
  /// A face that is written as a record of its own.
  struct WrittenFace {
    /// The record of the source that it replaces or follows; kNoIndex if it follows all.
    Index record;
    /// A face of the edited mesh.
    Index face;
  };
  /// What becomes of each record of the source.
  std::vector<RecordChange> changes;
  /// The face of the edited mesh that each triangle of the source is; kNoIndex if it was dropped.
  std::vector<Index> faces;
  /// The faces written as records of their own, in the order of the file.
  std::vector<WrittenFace> written;
  /// The face of the file that each face of the edited mesh is.
  std::vector<Index> file_faces;
  /// The number of records of the file.
  std::size_t n_records = 0;
  /// The number of dropped polygons some of whose triangles remain.
  std::size_t n_split_polygons = 0;
};

/// Decides which face records stay. If statements apply to faces, a face made from another one
/// follows it, and a patch follows the run of the face beside it; else added faces follow all
/// others.
///
/// @complexity O(#F log #F).
[[nodiscard]] FacePlan plan_faces(const EditedMesh& mesh, const FaceRecords& records);

/// Returns which corner of a record that stays is written at a place among its `n` corners: a
/// polygon that was turned over begins at the same corner, and goes round in the opposite
/// direction.
[[nodiscard]] std::size_t corner_written_at(const FacePlan& plan, Index record, std::size_t place,
                                            std::size_t n);

/// Returns the vertex of the edited mesh at a corner of a record that stays.
///
/// @param new_vertices  As new_vertices() returns them.
[[nodiscard]] Index vertex_now(const EditedMesh& mesh, const FacePlan& plan,
                               std::span<const Index> new_vertices, Index record,
                               const FanCorner& corner);

/// Tells whether a record of the source that is kept names other vertices now.
[[nodiscard]] bool is_renumbered(const EditedMesh& mesh, const FacePlan& plan,
                                 const FaceRecords& records, Index record);

/// Tells whether a plan leaves the faces in the order of the edited mesh.
[[nodiscard]] bool keeps_order(const FacePlan& plan);

/// Applies edits that follow a plan, and returns the resulting file.
[[nodiscard]] RewrittenFile rewritten_file(ByteEdits& edits, const FacePlan& plan);

/// Returns the vertex or face of the edited mesh that each one of the source is; kNoIndex if it was
/// dropped.
[[nodiscard]] std::vector<Index> new_vertices(const EditedMesh& mesh);
[[nodiscard]] std::vector<Index> new_faces(const EditedMesh& mesh);

}  // namespace meshalyzer
