#pragma once

#include "meshalyzer/repair/edits/draft.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/touched.h"
#include "meshalyzer/repair/trial/repair_log.h"

#include <cstdint>
#include <span>
#include <string>

namespace meshalyzer {

/// Edits that were made. Only refers.
struct MadeEdits {
  const Draft& before;
  const Edits& edits;
  /// #operations, as apply_edits() takes them.
  std::span<const std::uint8_t> skipped;
  const Draft& after;
  /// As find_touched() returns it.
  const Touched& touched;
};

/// Adds what a pass did to a log: to its last step, where that is of the same pass, else as a new
/// one.
void log_edits(const std::string& pass, DefectCode code, const MadeEdits& made, RepairLog& log);

}  // namespace meshalyzer
