#pragma once

#include "exit_code.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/report/repair_report.h"
#include "options.h"
#include "streams.h"

#include <functional>
#include <string_view>

namespace meshalyzer::fixer {

/// Repairs one mesh, writes what comes of it where the options say, and tells of it.
///
/// @param options  Of one input.
/// @param bytes    What the soup was read from.
/// @param tell     Is told what was done; its exit code counts where it is not Done.
/// @throws IoError, UsageError
[[nodiscard]] ExitCode repair_mesh(const Options& options, Soup soup, std::string_view bytes,
                                   Streams streams,
                                   const std::function<ExitCode(const RepairReport&)>& tell);

}  // namespace meshalyzer::fixer
