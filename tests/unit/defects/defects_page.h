#pragma once

#include <string>

namespace meshalyzer {

/// The text of doc/defects.md: an introduction, and what the catalogue says of each code.
[[nodiscard]] std::string defects_page();

}  // namespace meshalyzer
