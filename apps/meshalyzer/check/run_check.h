#pragma once

#include "check/command.h"
#include "exit_code.h"
#include "streams.h"

namespace meshalyzer {

/// `meshalyzer check`: checks the files, and tells of each as soon as it is done.
[[nodiscard]] ExitCode run_check(const CheckCommand& command, Streams streams);

}  // namespace meshalyzer
