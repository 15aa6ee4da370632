#pragma once

namespace meshalyzer {

/// The exit status of either program.
enum class ExitCode {
  /// All was done. With a check of goodness every mesh is good; after a repair no requested defect
  /// remains.
  Done = 0,
  /// A mesh is not good, or defects remain after a repair.
  NotGood = 1,
  /// The usage is wrong; nothing was read.
  Usage = 2,
  /// An input could not be read, or the report could not be written. The other inputs were
  /// processed.
  Failure = 3,
  /// The user interrupted the program; shells report this number for it.
  Interrupted = 130,
};

}  // namespace meshalyzer
