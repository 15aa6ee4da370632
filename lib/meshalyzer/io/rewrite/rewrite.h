#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <optional>
#include <string_view>

namespace meshalyzer {

/// Writes an edited mesh into the bytes that its source was read from, so that what no edit touched
/// stays as it was, byte for byte in text: numbers, lines and their order, polygons, and all that
/// the mesh does not hold (materials, texture coordinates, colours, other properties, comments). A
/// polygon is one as long as none of its triangles changes.
///
/// What is changed or was made of a face takes that face's attributes, interpolated where a corner
/// is another vertex now; a hole patch has none where the format can say so, else those of a face
/// beside it.
///
/// @param bytes  What mesh.source was parsed from, not gzipped and without a byte order mark.
/// @return Nothing where these bytes cannot hold the mesh: a binary STL file coordinates that are
/// no
///         32-bit floats; and of encodings that are read but not written.
/// @throws InvalidArgument if a face has a corner without a vertex.
/// @complexity O(bytes + #F log #F).
[[nodiscard]] std::optional<RewrittenFile> rewrite_mesh(const EditedMesh& mesh,
                                                        std::string_view bytes);

}  // namespace meshalyzer
