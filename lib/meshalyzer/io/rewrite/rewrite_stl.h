#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <optional>

namespace meshalyzer {

/// Writes an edited mesh into the text that its source was read from: solids, their names, and
/// facets that no edit touched stay as they are. Other facets look like the one they were made of,
/// or lie beside; their normals are those of their corners.
///
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] RewrittenFile rewrite_ascii_stl(const EditedMesh& mesh, std::string_view text);

/// Does the same for a binary file: the header stays, and the attribute word of a facet; that of a
/// facet of a hole patch is 0.
///
/// @return Nothing where a coordinate of a new or changed facet is no 32-bit float.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::optional<RewrittenFile> rewrite_binary_stl(const EditedMesh& mesh,
                                                              std::string_view content);

}  // namespace meshalyzer
