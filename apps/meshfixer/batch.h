#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer::fixer {

/// Repairs all files that the paths of the options stand for, one after the other, and reports each
/// in a line as soon as it is done, and all in a table.
///
/// @return The most serious of the exit codes of the files.
/// @throws UsageError if an output is an input or another output.
/// @throws IoError if a report cannot be written.
[[nodiscard]] ExitCode run_batch(const Options& options, Streams streams);

}  // namespace meshalyzer::fixer
