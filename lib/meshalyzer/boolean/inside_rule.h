#pragma once

#include <functional>
#include <span>

namespace meshalyzer {

/// Tells whether a place is inside the result of a boolean operation, by how often each operand
/// goes round it: a place is inside an operand that goes round it at least once.
using InsideRule = std::function<bool(std::span<const int> windings)>;

/// What is inside any operand.
[[nodiscard]] InsideRule union_rule();
/// What is inside all operands.
[[nodiscard]] InsideRule intersection_rule();
/// What is inside the first operand and no other one.
[[nodiscard]] InsideRule difference_rule();

}  // namespace meshalyzer
