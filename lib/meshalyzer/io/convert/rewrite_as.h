#pragma once

#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/io/rewrite/rewritten_file.h"
#include "meshalyzer/io/write.h"

#include <string_view>

namespace meshalyzer {

/// Writes an edited mesh as a file of any format, with the attributes of its source file that this
/// format can hold: polygons, colours, texture coordinates, comments. The others are counted as
/// lost.
///
/// Changed and added elements get attributes as in rewrite_mesh().
///
/// @param bytes     The content from which mesh.source was parsed, not gzipped and without a byte
///                  order mark.
/// @param encoding  The encoding; binary only for PLY and STL.
/// @throws InvalidArgument if a face has a corner without a vertex or, written as `.mesh`, a vertex
///         whose id belongs to an earlier one.
/// @complexity O(bytes + #F log #F).
[[nodiscard]] RewrittenFile rewrite_as(const EditedMesh& mesh, std::string_view bytes,
                                       Format format, Encoding encoding = Encoding::Text);

}  // namespace meshalyzer
