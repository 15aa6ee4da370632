#pragma once

#include "options.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// The mesh files that the paths of a command line mean.
struct Inputs {
  /// In order of the paths; for a folder the files in it with the ending of a known format,
  /// whatever its case, in order of the bytes of their names, not those in folders within it.
  std::vector<std::string> files;
  /// What the meshes are called where a report tells of several: set_names().
  std::vector<std::string> names;
  /// Whether all files together are a set.
  bool is_set = false;
  /// What could not be listed, or held no mesh, a line each.
  std::vector<std::string> troubles;
};

/// Whether a path is a folder.
[[nodiscard]] bool is_folder(const std::string& path);

/// The mesh files that a command line means, and whether they are a set: those of a folder are, and
/// several files where somebody asks for what is between them. A file named twice is one mesh of a
/// set.
/// @throws UsageError where what is asked for cannot be told of them.
[[nodiscard]] Inputs inputs_of(const Options& options);

}  // namespace meshalyzer
