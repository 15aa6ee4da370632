#pragma once

#include "exit_code.h"
#include "options.h"

#include <iosfwd>

namespace meshalyzer::fixer {

/// Where a session writes.
struct Streams {
  /// The report.
  std::ostream& out;
  /// Everything else.
  std::ostream& err;
};

/// One call of the program: reads, finds or repairs, writes, reads back, tells.
///
/// @throws UsageError  where the input itself would be written.
/// @throws IoError     where something cannot be read or written.
[[nodiscard]] ExitCode work(const Options& options, Streams streams);

}  // namespace meshalyzer::fixer
