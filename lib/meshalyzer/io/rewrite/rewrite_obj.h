#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

namespace meshalyzer {

/// Writes an edited mesh into the text that its source was read from: statements that no edit
/// touched stay as they are. Texture coordinates and normals of changed faces are those of the
/// corners they had, or new records behind the last of their kind.
///
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] RewrittenFile rewrite_obj(const EditedMesh& mesh, std::string_view text);

}  // namespace meshalyzer
