#pragma once

#include "exit_code.h"
#include "input_file.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/report/repair_report.h"
#include "options.h"
#include "streams.h"

#include <functional>

namespace meshalyzer::fixer {

/// Repairs one mesh, writes the result to the destination in the options, and reports it.
///
/// @param options  The options, with one input.
/// @param file     The file from which the soup was read.
/// @param on_report  Receives the report; its exit code counts unless it is Done.
/// @throws IoError, UsageError
[[nodiscard]] ExitCode repair_mesh(const Options& options, Soup soup, const InputFile& file,
                                   Streams streams,
                                   const std::function<ExitCode(const RepairReport&)>& on_report);

}  // namespace meshalyzer::fixer
