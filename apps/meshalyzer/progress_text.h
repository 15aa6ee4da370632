#pragma once

#include "meshalyzer/set/run_listener.h"

#include <chrono>
#include <string>

namespace meshalyzer {

/// Returns a line that shows the progress of a run: a bar, files, faces, rate and the remaining
/// time, in at most 79 columns.
///
/// @param elapsed  The time since the stage began.
[[nodiscard]] std::string progress_text(const RunProgress& progress,
                                        std::chrono::duration<double> elapsed);

}  // namespace meshalyzer
