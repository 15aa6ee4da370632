#pragma once

#include <iosfwd>

namespace meshalyzer {

/// What the shell sees.
enum class ExitCode {
  /// All done; with -g: every mesh is good.
  Done = 0,
  /// With -g: a mesh is not good.
  NotGood = 1,
  /// Wrong usage; nothing was read.
  Usage = 2,
  /// An input could not be read, or the report could not be written. The other inputs are done.
  Trouble = 3,
};

/// The whole program, without global state, so that a test can call it.
///
/// @return an ExitCode as int. The report goes to `out`, everything else to `err`.
[[nodiscard]] int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace meshalyzer
