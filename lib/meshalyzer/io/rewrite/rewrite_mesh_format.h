#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

namespace meshalyzer {

/// Writes an edited mesh into the text in the native format that its source was read from: comments
/// and lines that no edit touched stay as they are. Torn lines stay only where the mesh has them
/// still.
///
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] RewrittenFile rewrite_mesh_format(const EditedMesh& mesh, std::string_view text);

}  // namespace meshalyzer
