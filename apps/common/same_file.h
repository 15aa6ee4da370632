#pragma once

#include <string>

namespace meshalyzer {

/// Whether two paths name one file, be it there or not.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

}  // namespace meshalyzer
