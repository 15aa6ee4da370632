#pragma once

#include "meshalyzer/io/rewrite/byte_edits.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The face records of a source. A polygon is one record and several triangles.
struct FaceRecords {
  /// The first triangle of each record; and behind the last record the number of triangles.
  std::vector<Index> first_triangle;
  /// For each record, the last one of the run with the same statements (materials, groups).
  /// Empty where no statement applies to faces.
  std::vector<Index> run_ends;

  [[nodiscard]] std::size_t size() const { return first_triangle.size() - 1; }
  [[nodiscard]] std::size_t n_triangles(Index record) const {
    return first_triangle[record + 1] - first_triangle[record];
  }
  /// Returns the record that a triangle of the source is of.
  ///
  /// @complexity O(log #records).
  [[nodiscard]] Index record_of(Index triangle) const;
};

/// Where the corner `local` of a record, counted in the order of the file, stands among its
/// triangles.
struct FanCorner {
  Index triangle;
  std::size_t corner;
};
[[nodiscard]] FanCorner fan_corner(const FaceRecords& records, Index record, std::size_t local);

/// Returns the corner of its record, counted in the order of the file, that a triangle's corner is.
[[nodiscard]] std::size_t local_corner(const FaceRecords& records, Index record, FanCorner corner);

/// What becomes of a face record of the source.
enum class RecordFate : std::uint8_t {
  /// All its triangles are there, and still those of one polygon. Corners may be other vertices.
  Kept,
  /// All triangles of this polygon are there, of the same vertices, and all have been turned.
  Turned,
  /// It is dropped, and those of its triangles that are left are written one by one.
  Dropped,
};

/// Tells how the faces of an edited mesh stand in its file.
struct FacePlan {
  /// A face that is written as a record of its own.
  struct WrittenFace {
    /// The record of the source in or behind whose place it stands; kNoIndex: behind all.
    Index record;
    /// A face of the edited mesh.
    Index face;
  };
  /// What becomes of each record of the source.
  std::vector<RecordFate> fates;
  /// The face of the edited mesh that each triangle of the source is; kNoIndex where it was
  /// dropped.
  std::vector<Index> faces;
  /// In the order of the file.
  std::vector<WrittenFace> written;
  /// Tells which face of the file each face of the edited mesh is.
  std::vector<Index> file_faces;
  /// Tells how many records the file has.
  std::size_t n_records = 0;
  /// Tells how many polygons are dropped of which something is left.
  std::size_t n_split_polygons = 0;
};

/// Decides which face records stay. What was made of a face stands behind it where statements apply
/// to faces, a patch at the end of the run of the face beside it; else added faces stand behind all
/// others.
///
/// @complexity O(#F log #F).
[[nodiscard]] FacePlan plan_faces(const EditedMesh& mesh, const FaceRecords& records);

/// Returns the vertex of the edited mesh at a corner of a triangle of the source that was kept.
[[nodiscard]] inline Index vertex_at(const EditedMesh& mesh, const FacePlan& plan,
                                     const FanCorner& corner) {
  return mesh.soup.triangles[plan.faces[corner.triangle]][corner.corner];
}

/// Tells whether a plan leaves the faces in the order of the edited mesh.
[[nodiscard]] bool keeps_order(const FacePlan& plan);

/// Applies edits that follow a plan, and tells what the file is that comes of them.
[[nodiscard]] RewrittenFile rewritten_file(ByteEdits& edits, const FacePlan& plan);

/// Returns which vertex of the edited mesh each one of the source is; kNoIndex if it was dropped.
[[nodiscard]] std::vector<Index> new_vertices(const EditedMesh& mesh);

}  // namespace meshalyzer
