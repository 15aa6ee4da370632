#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <optional>

namespace meshalyzer {

// rewrite_mesh() for each format. Each throws InvalidArgument if a face has a corner without a
// vertex.

/// Writes an edited mesh into the text in the native format that its source was read from: comments
/// and lines that no edit touched stay as they are. Torn lines stay only where the mesh has them
/// still.
[[nodiscard]] RewrittenFile rewrite_mesh_format(const EditedMesh& mesh, std::string_view text);

/// Writes an edited mesh into the text in INRIA's format that its source was read from: comments,
/// references, sections that say nothing about the triangles, and records that no edit touched stay
/// as they are. What is left of a quadrilateral, and added faces, stand behind the other triangles;
/// faces of a hole patch have reference 0. Records of other sections that name what was dropped are
/// dropped, and counted as lost.
[[nodiscard]] RewrittenFile rewrite_inria(const EditedMesh& mesh, std::string_view text);

/// Writes an edited mesh into the text that its source was read from: statements that no edit
/// touched stay as they are. Texture coordinates and normals of changed faces are those of the
/// corners they had, or new records behind the last of their kind.
[[nodiscard]] RewrittenFile rewrite_obj(const EditedMesh& mesh, std::string_view text);

/// Writes an edited mesh into the text that its source was read from: comments, colours, texture
/// coordinates and lines that no edit touched stay as they are. Added vertices and faces have
/// colours where those they are made of have; faces of a hole patch have none.
[[nodiscard]] RewrittenFile rewrite_off(const EditedMesh& mesh, std::string_view text);

/// Writes an edited mesh into the text that its source was read from: solids, their names, and
/// facets that no edit touched stay as they are. Other facets look like the one they were made of,
/// or lie beside; their normals are those of their corners.
[[nodiscard]] RewrittenFile rewrite_ascii_stl(const EditedMesh& mesh, std::string_view text);

/// Does the same for a binary file: the header stays, and the attribute word of a facet; that of a
/// facet of a hole patch is 0.
///
/// @return Nothing where a coordinate of a new or changed facet is no 32-bit float.
[[nodiscard]] std::optional<RewrittenFile> rewrite_binary_stl(const EditedMesh& mesh,
                                                              std::string_view content);

/// Writes an edited mesh into the content that its source was read from, in the same encoding:
/// header, order and types of properties, other elements and records that no edit touched stay as
/// they are. Only where a type cannot hold a new coordinate or index does the property get a larger
/// one.
///
/// Added vertices have the means of what their neighbours have, whole numbers wider than a byte and
/// lists those of one of them. Faces of a hole patch have the numbers of a face beside it, and
/// empty lists. Records of other elements that name a dropped vertex are dropped, and counted as
/// lost.
///
/// @return Nothing where the faces are strips.
[[nodiscard]] std::optional<RewrittenFile> rewrite_ply(const EditedMesh& mesh,
                                                       std::string_view content);

}  // namespace meshalyzer
