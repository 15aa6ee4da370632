#pragma once

#include <string_view>

namespace meshalyzer {

/// Returns the meaning of a word of a report in a sentence; it is empty for a word that needs none.
/// doc/definitions.md defines each word in full.
/// @param term  As the text report names it: "border edges".
[[nodiscard]] std::string_view definition_of(std::string_view term);

}  // namespace meshalyzer
