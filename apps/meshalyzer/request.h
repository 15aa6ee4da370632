#pragma once

#include "meshalyzer/set/request.h"
#include "options.h"

namespace meshalyzer {

/// Returns the request of a command line.
///
/// @param is_set  True if the meshes are a set. If no question about it is named, all are asked,
///                but none with -a or -g.
[[nodiscard]] Request request_of(const Options& options, bool is_set);

}  // namespace meshalyzer
