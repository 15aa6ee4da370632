#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Calls `use` for each whole line of a journal. A torn last line, as a killed run leaves it, is
/// skipped.
///
/// @param file  The name of the journal in errors.
/// @throws IoError with the line if `use` throws InvalidArgument, or if the incomplete last line is
///         no torn line.
void for_each_line(std::string_view journal, const std::string& file,
                   const std::function<void(std::string_view)>& use);

}  // namespace meshalyzer
