#pragma once

#include "options.h"
#include "run_files.h"

#include <string>
#include <vector>

namespace meshalyzer::fixer {

/// Returns the file for the result of an input: OUT, a file with the name of the input in the
/// folder OUT, or the input itself. There must be an OUT, or --in-place.
[[nodiscard]] std::string result_path(const Options& options, const std::string& input);

/// Rejects the file of a result if its ending does not tell the format.
/// @throws IoError  if it is that of no known format.
void require_format(const std::string& result);

/// Returns the file in which --backup keeps an input.
[[nodiscard]] std::string backup_path(const std::string& input);

/// Collects the files of a run before anything is written: inputs, results, backups and reports.
///
/// @throws UsageError  if an output is an input or another output, or if standard input has no
///                     name for the file of its result.
[[nodiscard]] RunFiles files_of_run(const Options& options, const std::vector<std::string>& inputs);

/// Makes the folder OUT, if OUT is one.
/// @throws IoError  if it cannot be made.
void make_output_folder(const Options& options);

}  // namespace meshalyzer::fixer
