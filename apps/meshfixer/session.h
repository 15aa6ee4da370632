#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer::fixer {

/// One call of the program: reads, finds or repairs, writes, reads back, tells.
///
/// @throws UsageError  where the input itself would be written.
/// @throws IoError     where something cannot be read or written.
[[nodiscard]] ExitCode work(const Options& options, Streams streams);

}  // namespace meshalyzer::fixer
