#pragma once

#include "inputs.h"
#include "options.h"
#include "picture_paths.h"

namespace meshalyzer {

/// Checks the files of a run before anything is written: meshes and journals that are read, and
/// reports, pictures and the journal that are written.
///
/// @throws UsageError if an output is an input or another output.
void check_files(const Options& options, const Inputs& inputs, const PicturePaths& pictures);

}  // namespace meshalyzer
