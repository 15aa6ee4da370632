#pragma once

#include "check/command.h"
#include "meshalyzer/checks/check_files.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Returns the files to check, each with the criteria of its settings file and of the command line;
/// those that a settings file excludes are left out.
///
/// @throws IoError  where a settings file cannot be understood.
[[nodiscard]] std::vector<CheckJob> jobs_of(const CheckCommand& command,
                                            const std::vector<std::string>& files);

}  // namespace meshalyzer
