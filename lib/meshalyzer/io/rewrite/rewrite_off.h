#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

namespace meshalyzer {

/// Writes an edited mesh into the text that its source was read from: comments, colours, texture
/// coordinates and lines that no edit touched stay as they are. Added vertices and faces have
/// colours where those they are made of have; faces of a hole patch have none.
///
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] RewrittenFile rewrite_off(const EditedMesh& mesh, std::string_view text);

}  // namespace meshalyzer
