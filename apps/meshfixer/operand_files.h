#pragma once

#include "input_file.h"
#include "meshalyzer/boolean/operands.h"
#include "options.h"

#include <memory>
#include <string>
#include <vector>

namespace meshalyzer::fixer {

/// The files whose solids are combined, as they were read.
struct OperandFiles {
  std::vector<std::unique_ptr<const InputFile>> files;
  /// One a file.
  std::vector<Soup> soups;
};

/// Reads the files that the paths of the options mean: mesh files, and all of folders.
///
/// @throws Error  for the first that cannot be read, or a folder without meshes.
/// @throws UsageError  where OUT, or the file of a report, is one of them.
[[nodiscard]] OperandFiles read_operands(const Options& options);

/// Says of each file that bounds no solid why, and what to do; empty where all do.
[[nodiscard]] std::string solid_faults(const OperandFiles& operands);

/// Makes the folder that a file for each input goes to, where OUT is one.
///
/// @throws UsageError  where an input, or two outputs, would be written at one place.
/// @throws IoError     where it cannot be made.
void make_output_folder(const Options& options, const OperandFiles& operands);

}  // namespace meshalyzer::fixer
