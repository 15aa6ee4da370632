#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>

namespace meshalyzer::test {

/// Computes the expected result of find_contact() in another way: constructs the intersection of
/// the two triangles (or segments or points, if they have zero area) over the rationals with CGAL,
/// and tests whether it contains more than the common part of the triangles. Slow, without filters
/// or case analysis.
[[nodiscard]] std::optional<ContactKind> oracle_contact(const Corners& p, const Corners& q,
                                                        Common common);

}  // namespace meshalyzer::test
