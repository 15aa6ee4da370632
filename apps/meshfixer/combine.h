#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer::fixer {

/// Combines the solids of the inputs, or of the components of one input, writes the result, reads
/// it back, and reports it.
///
/// @throws UsageError  if an input would be overwritten.
/// @throws Error       if something cannot be read or written.
[[nodiscard]] ExitCode combine(const Options& options, Streams streams);

}  // namespace meshalyzer::fixer
