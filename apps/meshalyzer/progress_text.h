#pragma once

#include "meshalyzer/set/run_listener.h"

#include <chrono>
#include <string>

namespace meshalyzer {

/// Returns a line of how far a run has come: a bar, files, faces, rate and the time left, at most
/// 79 columns.
///
/// @param elapsed  Since the stage began.
[[nodiscard]] std::string progress_text(const RunProgress& progress,
                                        std::chrono::duration<double> elapsed);

}  // namespace meshalyzer
