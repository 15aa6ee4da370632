#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>

namespace meshalyzer {

/// Does the work of find_contact() for two triangles of which at least one has zero area and counts
/// as the segment or point that it is.
[[nodiscard]] std::optional<ContactKind> find_degenerate_contact(const Corners& p, const Corners& q,
                                                                 Common common);

}  // namespace meshalyzer
