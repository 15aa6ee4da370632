#pragma once

#include <iosfwd>

namespace meshalyzer {

/// Tells whether a stream is the process's standard output or error, and that is a terminal.
[[nodiscard]] bool is_terminal(const std::ostream& out);

}  // namespace meshalyzer
