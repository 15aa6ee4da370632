#pragma once

#include "meshalyzer/set/run_listener.h"
#include "meshalyzer/set/set_analysis.h"
#include "meshalyzer/set/set_options.h"

#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Analyses the meshes of a set one by one, and their relations to each other; Request::is_set is
/// ignored.
///
/// Files are analysed in parallel, a few at a time, as memory allows, and large ones with several
/// threads each. The findings depend neither on the number of threads nor on the memory limit.
///
/// @param paths     The files, which must not change meanwhile, because some are read twice.
/// @return          Nothing if the listener stopped the run, or if it is one shard of several; then
///                  the listener has received all findings.
/// @throws InvalidArgument  as analyze() and measure_separation(); if the time limit is negative or
///                  NaN; and if the number of the shard is not below that of all shards.
/// @throws IoError  if a file cannot be read a second time or has changed. A file that cannot be
///                  read the first time is reported.
[[nodiscard]] std::optional<SetAnalysis> analyze_set(const std::vector<std::string>& paths,
                                                     const SetOptions& options,
                                                     RunListener& listener);

}  // namespace meshalyzer
