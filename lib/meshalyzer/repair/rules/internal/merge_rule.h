#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// The third rule for operations: an operation may not merge vertices so that faces or edges break.

/// The reasons why vertices must not be joined.
enum class MergeRejection : std::uint8_t { None, Collapse, TurnOver, NonManifold, Duplicate };

/// Returns the sentence for a refusal: "joining them would ...".
[[nodiscard]] std::string_view reason_of(MergeRejection rejection);

/// Finds the joined vertices that would break something: a face that collapses or turns over, an
/// edge of several old ones that gets more than two faces, faces with the same three vertices.
///
/// The answer is exact. If no vertex moves, joining fewer vertices violates no rule that joining
/// all of them keeps.
///
/// @param representative  For each vertex, the one that represents all those that it is joined
/// with.
/// @param affected  All faces of the complex that have a joined vertex.
/// @return         For each representative, why it must not be joined; vertices that are joined
/// with none may be named too. Empty if nothing is rejected.
/// @complexity     O(#V + n log n) for n affected faces, near linear unless a vertex has many.
[[nodiscard]] std::vector<MergeRejection> check_merges(const Soup& soup,
                                                       std::span<const Index> representative,
                                                       std::span<const Index> affected);

}  // namespace meshalyzer
