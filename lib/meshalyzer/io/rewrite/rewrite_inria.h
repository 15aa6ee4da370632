#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

namespace meshalyzer {

/// Writes an edited mesh into the text in INRIA's format that its source was read from: comments,
/// references, sections that say nothing about the triangles, and records that no edit touched stay
/// as they are. What is left of a quadrilateral, and added faces, stand behind the other triangles;
/// faces of a hole patch have reference 0. Records of other sections that name what was dropped are
/// dropped, and counted as lost.
///
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] RewrittenFile rewrite_inria(const EditedMesh& mesh, std::string_view text);

}  // namespace meshalyzer
