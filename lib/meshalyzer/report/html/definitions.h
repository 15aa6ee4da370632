#pragma once

#include <string_view>

namespace meshalyzer {

/// What a word of a report means, in a sentence; empty for a word that needs none. In full it
/// stands in doc/definitions.md.
/// @param term  As the text report names it: "border edges".
[[nodiscard]] std::string_view definition_of(std::string_view term);

}  // namespace meshalyzer
