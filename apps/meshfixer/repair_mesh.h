#pragma once

#include "exit_code.h"
#include "input_file.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/report/repair_report.h"
#include "options.h"
#include "streams.h"

#include <functional>

namespace meshalyzer::fixer {

/// Repairs one mesh, writes what comes of it where the options say, and tells of it.
///
/// @param options  Of one input.
/// @param file     What the soup was read from.
/// @param tell     Is told what was done; its exit code counts where it is not Done.
/// @throws IoError, UsageError
[[nodiscard]] ExitCode repair_mesh(const Options& options, Soup soup, const InputFile& file,
                                   Streams streams,
                                   const std::function<ExitCode(const RepairReport&)>& tell);

}  // namespace meshalyzer::fixer
