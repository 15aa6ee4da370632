#pragma once

#include <string>
#include <vector>

namespace meshalyzer {

/// The mesh files that the paths of a command line stand for: a path stands for itself, or, if it
/// is a folder, for the mesh files in it (MeshFolder::files); folders within the folder do not
/// count.
struct MeshPaths {
  /// The files in order of the paths, those of a folder in order of the bytes of their names.
  std::vector<std::string> files;
  /// The folders that could not be listed or hold no mesh, with the reason, a line each.
  std::vector<std::string> errors;
  /// Tells whether any path is a folder.
  bool has_folder = false;
};

/// Tells whether a path is a folder.
[[nodiscard]] bool is_folder(const std::string& path);

[[nodiscard]] MeshPaths find_meshes(const std::vector<std::string>& paths);

}  // namespace meshalyzer
