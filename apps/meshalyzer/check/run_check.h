#pragma once

#include "check/command.h"
#include "exit_code.h"
#include "streams.h"

namespace meshalyzer {

/// Runs `meshalyzer check`: checks the files, and reports each as soon as it is done.
[[nodiscard]] ExitCode run_check(const CheckCommand& command, Streams streams);

}  // namespace meshalyzer
