#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <optional>

namespace meshalyzer {

// The functions of rewrite_mesh() for each format. Each throws InvalidArgument if a face has a
// corner without a vertex.

/// Applies edits to a file in the native format: comments and lines that no edit touches stay the
/// same. Torn lines stay only if the mesh still has them.
[[nodiscard]] RewrittenFile rewrite_mesh_format(const EditedMesh& mesh, std::string_view text);

/// Applies edits to a file in INRIA's format: comments, references, sections that do not concern
/// the triangles, and records that no edit touches stay the same. The remains of a quadrilateral,
/// and added faces, follow the other triangles; faces of a hole patch have reference 0. Records of
/// other sections that name dropped elements are dropped, and counted as lost.
[[nodiscard]] RewrittenFile rewrite_inria(const EditedMesh& mesh, std::string_view text);

/// Applies edits to an OBJ file: statements that no edit touches stay the same. Texture coordinates
/// and normals of changed faces are those of their former corners, or new records after the last of
/// their kind.
[[nodiscard]] RewrittenFile rewrite_obj(const EditedMesh& mesh, std::string_view text);

/// Applies edits to an OFF file: comments, colours, texture coordinates and lines that no edit
/// touches stay the same. Added vertices and faces have colours if those from which they are made
/// have; faces of a hole patch have none.
[[nodiscard]] RewrittenFile rewrite_off(const EditedMesh& mesh, std::string_view text);

/// Applies edits to an ASCII STL file: solids, their names, and facets that no edit touches stay
/// the same. Other facets are formatted like the one from which they were made, or beside which
/// they lie, without its comments; their normals are computed from their corners.
[[nodiscard]] RewrittenFile rewrite_ascii_stl(const EditedMesh& mesh, std::string_view text);

/// Applies edits to a binary STL file: the header stays, and so does the attribute word of a facet;
/// that of a facet of a hole patch is 0.
///
/// @return Nothing if a coordinate of a new or changed facet is no 32-bit float.
[[nodiscard]] std::optional<RewrittenFile> rewrite_binary_stl(const EditedMesh& mesh,
                                                              std::string_view content);

/// Applies edits to a PLY file in its encoding: header, order and types of properties, other
/// elements and records that no edit touches stay the same. A property gets a larger type only if
/// its type cannot hold a new coordinate or index.
///
/// Added vertices have the means of the numbers of their neighbours; whole numbers wider than a
/// byte and lists come from one of them. Faces of a hole patch have the numbers of a face beside
/// it, and empty lists. Records of other elements that name a dropped vertex are dropped, and
/// counted as lost.
///
/// @return Nothing if the faces are strips.
[[nodiscard]] std::optional<RewrittenFile> rewrite_ply(const EditedMesh& mesh,
                                                       std::string_view content);

}  // namespace meshalyzer
