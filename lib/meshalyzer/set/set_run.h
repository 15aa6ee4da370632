#pragma once

#include "meshalyzer/set/run_listener.h"
#include "meshalyzer/set/set_analysis.h"
#include "meshalyzer/set/set_options.h"

#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Analyses the meshes of a set one by one, whatever Request::is_set says, and what is between
/// them.
///
/// Files are worked on in parallel, and big ones inside; at most a few at a time, as memory allows.
/// What is told and returned does not depend on the number of threads, nor on the memory limit.
///
/// @param paths     The files; what is read twice must not change meanwhile.
/// @return          Nothing where the listener stopped it, or where the run is but one shard of
///                  several: then what was told is all there is.
/// @throws IoError  where a file cannot be read a second time or has changed; one that cannot be
///                  read the first time is told.
[[nodiscard]] std::optional<SetAnalysis> analyze_set(const std::vector<std::string>& paths,
                                                     const SetOptions& options,
                                                     RunListener& listener);

}  // namespace meshalyzer
