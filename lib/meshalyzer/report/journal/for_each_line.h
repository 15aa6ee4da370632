#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Calls `use` for each whole line of a journal. A torn last line, as a kill leaves it, is passed
/// over.
///
/// @param file  What errors call the journal.
/// @throws IoError with the line if `use` throws InvalidArgument, or the last line is none that was
/// torn.
void for_each_line(std::string_view journal, const std::string& file,
                   const std::function<void(std::string_view)>& use);

}  // namespace meshalyzer
