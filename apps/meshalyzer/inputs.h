#pragma once

#include "options.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// The mesh files that the paths of a command line stand for.
struct Inputs {
  /// The mesh files: see MeshPaths::files.
  std::vector<std::string> files;
  /// The names of the meshes in a report on several, see set_names().
  std::vector<std::string> names;
  /// Tells whether all files together are a set.
  bool is_set = false;
  /// The paths that could not be listed or held no mesh, with the reason, a line each.
  std::vector<std::string> errors;
};

/// Returns the mesh files that a command line stands for, and whether they are a set: the files of
/// a folder are, and several files if their relations are requested. A file named twice, also in
/// two spellings, is one mesh of a set.
/// @throws UsageError if the request does not apply to them.
[[nodiscard]] Inputs inputs_of(const Options& options);

}  // namespace meshalyzer
