#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer {

/// Runs `meshalyzer merge`: makes the report of a run from the journals of its shards, the same as
/// that of the whole run.
///
/// @param how  The journals, and the options of the report.
/// @throws IoError  if a journal cannot be read or belongs to another run than the first, or if a
///                  part is missing.
[[nodiscard]] ExitCode merge(const Options& how, Streams streams);

}  // namespace meshalyzer
