#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>

namespace meshalyzer::test {

/// What find_contact() must say, evaluated another way: constructs the intersection of the two
/// triangles (or segments, or points, where they have zero area) over the rationals with CGAL and
/// looks whether it holds more than what the triangles have in common. Slow, without filters or
/// case analysis.
[[nodiscard]] std::optional<ContactKind> oracle_contact(const Corners& p, const Corners& q,
                                                        Common common);

}  // namespace meshalyzer::test
