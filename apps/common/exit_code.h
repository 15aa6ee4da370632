#pragma once

namespace meshalyzer {

/// The exit status of either program.
enum class ExitCode {
  /// All done; meshalyzer -g: every mesh is good; meshfixer: nothing asked for remains.
  Done = 0,
  /// meshalyzer -g: a mesh is not good. meshfixer: defects remain.
  NotGood = 1,
  /// Wrong usage; nothing was read.
  Usage = 2,
  /// An input could not be read, or the report could not be written. The other inputs are done.
  Trouble = 3,
  /// Ended by the user before all was done, as shells report it.
  Interrupted = 130,
};

}  // namespace meshalyzer
