#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer::test {

/// Returns the faults of an HTML document by stricter rules than those of browsers: elements that
/// are not closed or closed out of order, attributes without quotes or given twice, stray '<' and
/// '&', ids that occur twice or are referred to and do not exist, table heads without a scope,
/// headings that leave out a level, handlers in attributes, elements in forbidden places, control
/// characters and bytes that are not UTF-8. Empty if there are none.
[[nodiscard]] std::vector<std::string> html_faults(std::string_view html);

/// Returns the text of the script element with an id; empty if there is none.
[[nodiscard]] std::string_view script_of(std::string_view html, std::string_view id);

}  // namespace meshalyzer::test
