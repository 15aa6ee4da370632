#pragma once

#include "exit_code.h"
#include "options.h"
#include "streams.h"

namespace meshalyzer {

/// `meshalyzer merge`: makes the report of a run of the journals of its parts (--shard), the same
/// as that of the whole run would be.
///
/// @param how  The journals, and how to tell what they hold.
/// @throws IoError  A journal cannot be read, is of another run than the first, or a part is
/// missing.
[[nodiscard]] ExitCode merge(const Options& how, Streams streams);

}  // namespace meshalyzer
