#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/edits.h"

namespace meshalyzer {

/// Tells whether the normals that a file gives at the corners of a face agree with its orientation,
/// most of them at least. If so, they are turned over where the face is; if not, the face is turned
/// to agree with them.
[[nodiscard]] bool normals_agree(const Soup& soup, Index face);

/// Returns the change that turns a face over.
[[nodiscard]] Edits::ChangedFace turned_face(const Soup& soup, Index op, Index face);

}  // namespace meshalyzer
