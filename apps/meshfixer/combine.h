#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer::fixer {

/// Combines the solids of the inputs, or of one input's components, writes what comes of it, reads
/// it back, and tells.
///
/// @throws UsageError  where an input itself would be written.
/// @throws Error       where something cannot be read or written.
[[nodiscard]] ExitCode combine(const Options& options, Streams streams);

}  // namespace meshalyzer::fixer
