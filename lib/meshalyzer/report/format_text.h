#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the format of the ending of a file's name if the file was read as another one; else an
/// empty text.
[[nodiscard]] std::string_view misleading_format(std::string_view path, Format format);

/// Returns the name of the format as which a file was read, with a remark if its ending names
/// another one.
[[nodiscard]] std::string format_text(std::string_view path, Format format);

/// Returns the format for a list of facts: "off file", "off file called stl".
[[nodiscard]] std::string file_text(std::string_view path, Format format);

}  // namespace meshalyzer
