#pragma once

#include "meshalyzer/set/request.h"
#include "options.h"

namespace meshalyzer {

/// Returns what a command line asks to be found out.
///
/// @param is_set  Whether the meshes are a set: then all there is between them is asked for where
/// nothing is named, but nothing with -a or -g.
[[nodiscard]] Request request_of(const Options& options, bool is_set);

}  // namespace meshalyzer
