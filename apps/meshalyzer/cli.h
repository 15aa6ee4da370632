#pragma once

#include "exit_code.h"

#include <iosfwd>

namespace meshalyzer {

/// Runs the whole program, without global state, so that a test can call it.
///
/// @return an ExitCode as int. The report goes to `out`, everything else to `err`.
[[nodiscard]] int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace meshalyzer
