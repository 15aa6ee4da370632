#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer::fixer {

/// Repairs all files that the paths of the options mean, one after the other, and tells of each in
/// a line as soon as it is done, and of all in a table.
///
/// @return The gravest of the exit codes of the files.
/// @throws UsageError where two files, or a file and its input, would be written to one place.
/// @throws IoError where a report cannot be written.
[[nodiscard]] ExitCode run_batch(const Options& options, Streams streams);

}  // namespace meshalyzer::fixer
