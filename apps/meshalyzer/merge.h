#pragma once

#include "session.h"

namespace meshalyzer {

/// `meshalyzer merge [options] FILE.ndjson...`: makes the report of a run of the journals of its
/// parts (--shard), the same as that of the whole run would be.
///
/// @param argv  From the word `merge` on.
/// @throws UsageError  The command line is wrong.
/// @throws IoError  A journal cannot be read, is of another run than the first, or a part is
/// missing.
[[nodiscard]] ExitCode merge(int argc, const char* const* argv, Streams streams);

}  // namespace meshalyzer
