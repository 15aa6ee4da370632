#pragma once

#include "meshalyzer/set/run_listener.h"
#include "meshalyzer/set/set_options.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Analyses files, each for itself, in parallel, and big ones inside; at most a few at a time, as
/// memory allows. What is told does not depend on the number of threads, nor on the memory limit.
///
/// @param listener  Hears of each file, in order; of nothing between them.
/// @return          Whether all files were analysed: not where the listener stopped it, or where
///                  the run is but one shard of several.
[[nodiscard]] bool analyze_files(const std::vector<std::string>& paths, const SetOptions& options,
                                 RunListener& listener);

}  // namespace meshalyzer
