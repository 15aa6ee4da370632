#pragma once

#include <functional>
#include <span>

namespace meshalyzer {

/// Decides from the winding number of each operand whether a point is inside the result of a
/// boolean operation; a point is inside an operand that goes round it at least once.
using InsideRule = std::function<bool(std::span<const int> windings)>;

/// Returns the rule of the union: inside any operand.
[[nodiscard]] InsideRule union_rule();
/// Returns the rule of the intersection: inside all operands.
[[nodiscard]] InsideRule intersection_rule();
/// Returns the rule of the difference: inside the first operand and no other one.
[[nodiscard]] InsideRule difference_rule();

}  // namespace meshalyzer
