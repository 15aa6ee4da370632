#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <optional>

namespace meshalyzer {

/// Writes an edited mesh into the content that its source was read from, in the same encoding:
/// header, order and types of properties, other elements and records that no edit touched stay as
/// they are. Only where a type cannot hold a new coordinate or index does the property get a larger
/// one.
///
/// Added vertices have the means of what their neighbours have, whole numbers wider than a byte and
/// lists those of one of them. Faces of a hole patch have the numbers of a face beside it, and
/// empty lists. Records of other elements that name a dropped vertex are dropped, and counted as
/// lost.
///
/// @return Nothing where the faces are strips.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::optional<RewrittenFile> rewrite_ply(const EditedMesh& mesh,
                                                       std::string_view content);

}  // namespace meshalyzer
