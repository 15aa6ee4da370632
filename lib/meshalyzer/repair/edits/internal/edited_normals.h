#pragma once

#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/edits/internal/edited_faces.h"

#include <span>

namespace meshalyzer {

/// Gives the faces and vertices of an edited soup their normals.
///
/// @param before    The soup before.
/// @param faces     What became of its faces.
/// @param vertices  By new vertex: the old one it is, or #old vertices + the number of the added.
/// @param result    Has its positions and triangles; receives normals.
void set_edited_normals(const Soup& before, const Edits& edits, const SkippedOperations& skipped,
                        const EditedFaces& faces, std::span<const Index> vertices, Soup& result);

}  // namespace meshalyzer
