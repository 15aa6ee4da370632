#pragma once

#include <string_view>

namespace meshalyzer {

/// Returns the definition of a term of a report in a sentence; it is empty for a term that needs
/// none. doc/definitions.md defines each word in full.
/// @param term  The term as in the text report: "border edges".
[[nodiscard]] std::string_view definition_of(std::string_view term);

}  // namespace meshalyzer
