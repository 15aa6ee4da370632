#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer::fixer {

/// Does the work of one call: reads, finds or repairs, writes, reads back, reports.
///
/// @throws UsageError  if the input would be overwritten, or is a folder where one mesh is
/// expected.
/// @throws IoError     if something cannot be read or written.
[[nodiscard]] ExitCode work(const Options& options, Streams streams);

}  // namespace meshalyzer::fixer
