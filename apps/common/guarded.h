#pragma once

#include "exit_code.h"
#include "streams.h"

#include <functional>
#include <string>

namespace meshalyzer {

/// Runs a program, and tells what ends it early, for a person and for the shell.
///
/// @param name  Of the program, as messages begin.
/// @return      An ExitCode as int.
[[nodiscard]] int run_guarded(const std::string& name, Streams streams,
                              const std::function<ExitCode()>& program);

}  // namespace meshalyzer
