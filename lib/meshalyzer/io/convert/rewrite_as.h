#pragma once

#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/io/rewrite/rewritten_file.h"
#include "meshalyzer/io/write.h"

#include <string_view>

namespace meshalyzer {

/// Writes an edited mesh as a file of any format, with what this format can say of what the file
/// said that the mesh was read from: polygons, colours, texture coordinates, comments. What it
/// cannot is counted as lost.
///
/// What edits changed and added has attributes as rewrite_mesh() gives them.
///
/// @param bytes     What mesh.source was parsed from, not gzipped and without a byte order mark.
/// @param encoding  Binary only where the format is PLY or STL.
/// @throws InvalidArgument if a face has a corner without a vertex.
/// @complexity O(bytes + #F log #F).
[[nodiscard]] RewrittenFile rewrite_as(const EditedMesh& mesh, std::string_view bytes,
                                       Format format, Encoding encoding = Encoding::Text);

}  // namespace meshalyzer
