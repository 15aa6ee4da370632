#pragma once

#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/edits/internal/edited_faces.h"

#include <span>

namespace meshalyzer {

/// Gives the faces and vertices of an edited soup their normals.
///
/// @param before    The soup before the edits.
/// @param faces     The faces after the edits.
/// @param vertices  By new vertex: the old vertex that it is, or #old vertices + the number of the
/// added one.
/// @param result    A soup with its positions and triangles; receives normals.
void set_edited_normals(const Soup& before, const Edits& edits, const SkippedOperations& skipped,
                        const EditedFaces& faces, std::span<const Index> vertices, Soup& result);

}  // namespace meshalyzer
