#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the format that the ending of a file's name stands for, where that is not the one that
/// the file was read as; else empty.
[[nodiscard]] std::string_view misleading_format(std::string_view path, Format format);

/// Returns the name of the format that a file was read as, and that it is not the one of its
/// ending.
[[nodiscard]] std::string format_text(std::string_view path, Format format);

/// Returns the same of a file among other facts: "off file", "off file called stl".
[[nodiscard]] std::string file_text(std::string_view path, Format format);

}  // namespace meshalyzer
