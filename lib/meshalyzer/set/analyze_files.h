#pragma once

#include "meshalyzer/set/run_listener.h"
#include "meshalyzer/set/set_options.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Analyses files independently of each other: a few at a time in parallel, as memory allows, and
/// large ones with several threads each. The findings depend neither on the number of threads nor
/// on the memory limit.
///
/// @param listener  Receives the findings of each file, in order, and none between files.
/// @return          True if all files were analysed; false if the listener stopped the run, or if
///                  it is one shard of several.
/// @throws InvalidArgument  as analyze_set().
[[nodiscard]] bool analyze_files(const std::vector<std::string>& paths, const SetOptions& options,
                                 RunListener& listener);

}  // namespace meshalyzer
