#pragma once

#include <iosfwd>

namespace meshalyzer {

/// Where a program writes.
struct Streams {
  /// The report.
  std::ostream& out;
  /// Everything else.
  std::ostream& err;
};

}  // namespace meshalyzer
