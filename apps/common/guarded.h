#pragma once

#include "exit_code.h"
#include "streams.h"

#include <functional>
#include <string>

namespace meshalyzer {

/// Runs a program, reports the exception that ends it, and returns the exit code for it.
///
/// @param name  The name of the program, with which messages begin.
/// @return      An ExitCode as int.
[[nodiscard]] int run_guarded(const std::string& name, Streams streams,
                              const std::function<ExitCode()>& program);

}  // namespace meshalyzer
