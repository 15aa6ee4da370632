#pragma once

#include <span>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the name that a mistyped one most likely means: the first of those with the smallest
/// edit distance, which may be at most a third of its letters. The result is empty where no name is
/// that close.
[[nodiscard]] std::string_view nearest_name(std::string_view mistyped,
                                            std::span<const std::string_view> names);

/// Returns "; did you mean 'name'?" with that name, or an empty text if none is that close.
[[nodiscard]] std::string did_you_mean(std::string_view mistyped,
                                       std::span<const std::string_view> names);

}  // namespace meshalyzer
