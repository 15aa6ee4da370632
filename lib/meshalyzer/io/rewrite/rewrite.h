#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <optional>
#include <string_view>

namespace meshalyzer {

/// Applies the edits of a mesh to the bytes of its source file. Everything that no edit touches
/// stays the same, byte for byte in text: numbers, lines and their order, polygons, and all data
/// that the mesh does not hold (materials, texture coordinates, colours, other properties,
/// comments). A polygon stays one as long as none of its triangles changes.
///
/// Faces that were changed or made from another one take that face's attributes, interpolated at
/// corners with another vertex; a hole patch has none if the format allows, else those of a face
/// beside it.
///
/// @param bytes  The content from which mesh.source was parsed, not gzipped and without a byte
///               order mark.
/// @return The new content; nothing if the format cannot hold the mesh (a binary STL file with
///         coordinates that are no 32-bit floats), or if its encoding is only read, not written.
/// @throws InvalidArgument if a face has a corner without a vertex or, in a `.mesh` file, a vertex
///         whose id belongs to an earlier one.
/// @complexity O(bytes + #F log #F).
[[nodiscard]] std::optional<RewrittenFile> rewrite_mesh(const EditedMesh& mesh,
                                                        std::string_view bytes);

}  // namespace meshalyzer
