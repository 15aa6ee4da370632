#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): what must not come of joining vertices.

/// What joining vertices would do.
enum class WeldHarm : std::uint8_t { None, Collapse, TurnOver, NonManifold, Duplicate };

/// A reason for a refusal: "it would ..."
[[nodiscard]] std::string_view reason_of(WeldHarm harm);

/// Finds the joined vertices that would break something: a face that collapses or turns over, an
/// edge of several old ones that gets more than two faces, faces with the same three vertices.
///
/// Exact. Joining fewer vertices, where none of them moves, does no harm that joining all did not.
///
/// @param staying  #V, the vertex that stays of those that each becomes one with.
/// @param touched  All faces of the complex that have a joined vertex.
/// @return         #V, by the vertex that stays; those that are joined with none may be named too.
///                 Empty where there is no harm.
/// @complexity     O(#V + n log n) for n touched faces, near linear where no vertex has many.
[[nodiscard]] std::vector<WeldHarm> find_weld_harms(const Soup& soup,
                                                    std::span<const Index> staying,
                                                    std::span<const Index> touched);

}  // namespace meshalyzer
