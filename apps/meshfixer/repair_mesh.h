#pragma once

#include "exit_code.h"
#include "input_file.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/report/repair_report.h"
#include "options.h"
#include "run_files.h"
#include "streams.h"

#include <functional>

namespace meshalyzer::fixer {

/// The circumstances of the repair of one mesh. The struct only refers to its data.
struct RepairTask {
  /// The options, with one input.
  const Options& options;
  /// The file of the mesh.
  const InputFile& file;
  /// The files of the run, to which the files of the components are added (--separate).
  RunFiles& files;
  Streams streams;
};

/// Repairs one mesh, writes the result to the destination in the options, and reports it.
///
/// @param soup       The mesh in the file.
/// @param on_report  Receives the report; its exit code counts unless it is Done.
/// @throws IoError     if a file cannot be read or written.
/// @throws UsageError  if a component would be written to an input or another output; nothing is
///                     written then.
[[nodiscard]] ExitCode repair_mesh(const RepairTask& task, Soup soup,
                                   const std::function<ExitCode(const RepairReport&)>& on_report);

}  // namespace meshalyzer::fixer
