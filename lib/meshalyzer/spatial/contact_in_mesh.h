#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <optional>

namespace meshalyzer {

/// Returns what two faces of one mesh share beyond the vertices that they have in common by id;
/// nothing if they share no more.
///
/// The contact is ContactKind::Unwelded if it is gone once vertices at identical places count as
/// one.
[[nodiscard]] std::optional<ContactKind> find_contact_in_mesh(const FaceTree& tree,
                                                              const Triangle& p, const Triangle& q);

}  // namespace meshalyzer
