#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer::test {

/// What is wrong with an HTML document, stricter than browsers are: elements that are not closed or
/// closed out of order, attributes without quotes or given twice, stray '<' and '&', ids that occur
/// twice or are referred to and do not exist, table heads without a scope, headings that leave out
/// a level, handlers in attributes, elements where they may not be, control characters and bytes
/// that are not UTF-8. Empty where nothing is.
[[nodiscard]] std::vector<std::string> html_faults(std::string_view html);

/// The text of a script element of an id; empty where there is none.
[[nodiscard]] std::string_view script_of(std::string_view html, std::string_view id);

}  // namespace meshalyzer::test
