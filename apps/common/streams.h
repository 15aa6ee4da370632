#pragma once

#include <iosfwd>

namespace meshalyzer {

/// The streams that a program writes to.
struct Streams {
  /// The stream for the report.
  std::ostream& out;
  /// The stream for everything else.
  std::ostream& err;
};

}  // namespace meshalyzer
