#pragma once

#include <string>
#include <vector>

namespace meshalyzer {

/// The mesh files that the paths of a command line mean.
struct Inputs {
  /// In order of the paths; the files of a folder in order of the bytes of their names.
  std::vector<std::string> files;
  /// Whether a path was a folder: then all files together are a set.
  bool is_set = false;
  /// What could not be listed, or held no mesh, a line each.
  std::vector<std::string> troubles;
};

/// Whether a path is a folder.
[[nodiscard]] bool is_folder(const std::string& path);

/// Replaces each folder by the mesh files in it: those with the ending of a known format, whatever
/// its case, not those in folders within it. Other paths stay as they are.
[[nodiscard]] Inputs find_inputs(const std::vector<std::string>& paths);

}  // namespace meshalyzer
