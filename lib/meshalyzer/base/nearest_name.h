#pragma once

#include <span>
#include <string_view>

namespace meshalyzer {

/// Returns the name that a mistyped one most likely means: the one that the fewest insertions,
/// deletions and replacements of letters make of it, no more than a third of its letters; of
/// several the first. Empty where none is so near.
[[nodiscard]] std::string_view nearest_name(std::string_view mistyped,
                                            std::span<const std::string_view> names);

}  // namespace meshalyzer
