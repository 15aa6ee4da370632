#pragma once

#include "exit_code.h"
#include "streams.h"

#include <string>

namespace meshalyzer {

/// Prints what a command was asked for, such as the text for --help, and reports if it cannot be
/// written.
///
/// @param program  The name of the program, with which the message begins.
[[nodiscard]] ExitCode print_answer(const std::string& answer, const std::string& program,
                                    Streams streams);

}  // namespace meshalyzer
