#pragma once

#include "check/command.h"
#include "meshalyzer/checks/check_files.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Returns the files to check, each with the criteria of its settings file and of the command line;
/// files that a settings file excludes are skipped.
///
/// @throws IoError  if a settings file is wrong.
[[nodiscard]] std::vector<CheckJob> jobs_of(const CheckCommand& command,
                                            const std::vector<std::string>& files);

}  // namespace meshalyzer
