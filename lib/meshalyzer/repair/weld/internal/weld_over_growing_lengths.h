#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/repair/pass.h"

#include <optional>
#include <span>

namespace meshalyzer {

/// Joins border edges as weld_borders() does, within PassInput::length. If that is longer than
/// `within`, because a step ends behind it, only those for which it makes no difference: no
/// distance between the two decides about them, nor about edges that they are connected with. So of
/// the joins that a greater `within` makes in this step, a smaller one makes none or those that it
/// would make anyway.
///
/// @param within  The length that the user asks for.
[[nodiscard]] PassResult weld_over_growing_lengths(const PassInput& input, double within);

/// Returns the length of a step before PassInput::length in which an edge at a changed vertex may
/// be joined, or else that of the next step in which welding may join more; nothing if `within` is
/// reached. The steps depend on the mesh, but not on `within`. The first one ends at
/// Tolerances::degeneracy.
///
/// @param changed  The vertices, by key, ascending.
/// @complexity     O(#F + n log n) for n border edges, unless they are dense.
[[nodiscard]] std::optional<double> next_weld_length(const PassInput& input, double within,
                                                     std::span<const Index> changed);

}  // namespace meshalyzer
