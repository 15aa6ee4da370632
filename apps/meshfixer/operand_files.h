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
  /// The mesh of each file.
  std::vector<Soup> soups;
};

/// Reads the files that the paths of the options stand for: mesh files, and all mesh files of
/// folders.
///
/// @throws Error  for the first file that cannot be read, or whose result would have no known
/// format,
///                or a folder without meshes.
/// @throws UsageError  if an output of the run is one of them, or another output.
[[nodiscard]] OperandFiles read_operands(const Options& options);

/// Says for each file that bounds no solid why, and what to do; empty if all do.
[[nodiscard]] std::string solid_faults(const OperandFiles& operands);

}  // namespace meshalyzer::fixer
