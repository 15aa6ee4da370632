#pragma once

#include "input_file.h"
#include "mesh_paths.h"
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

/// Reads the files of a boolean operation.
///
/// @throws Error  for a folder that cannot be listed or holds no mesh, or for the first file that
///                cannot be read, or whose result would have no known format.
[[nodiscard]] OperandFiles read_operands(const Options& options, const MeshPaths& paths);

/// Says for each file that bounds no solid why, and what to do, a line each; empty if all do.
[[nodiscard]] std::string solid_faults(const OperandFiles& operands);

}  // namespace meshalyzer::fixer
